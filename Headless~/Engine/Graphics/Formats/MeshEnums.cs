using System;

namespace UnityEngine.Rendering
{
    /// <summary>What a vertex can have.</summary>
    public enum VertexAttribute
    {
        Position = 0,
        Normal = 1,
        Tangent = 2,
        Color = 3,
        TexCoord0 = 4,
        TexCoord1 = 5,
        TexCoord2 = 6,
        TexCoord3 = 7,
        TexCoord4 = 8,
        TexCoord5 = 9,
        TexCoord6 = 10,
        TexCoord7 = 11,
        BlendWeight = 12,
        BlendIndices = 13,
    }

    /// <summary>How a component of an attribute is stored.</summary>
    public enum VertexAttributeFormat
    {
        Float32 = 0,
        Float16 = 1,
        UNorm8 = 2,
        SNorm8 = 3,
        UNorm16 = 4,
        SNorm16 = 5,
        UInt8 = 6,
        SInt8 = 7,
        UInt16 = 8,
        SInt16 = 9,
        UInt32 = 10,
        SInt32 = 11,
    }

    /// <summary>Bits of an index.</summary>
    public enum IndexFormat
    {
        UInt16 = 0,
        UInt32 = 1,
    }

    /// <summary>What a change of a mesh leaves out.</summary>
    [Flags]
    public enum MeshUpdateFlags
    {
        Default = 0,
        DontValidateIndices = 1,
        DontResetBoneBounds = 2,
        DontNotifyMeshUsers = 4,
        DontRecalculateBounds = 8,
    }

    /// <summary>An attribute of a mesh's vertices.</summary>
    public struct VertexAttributeDescriptor : IEquatable<VertexAttributeDescriptor>
    {
        public VertexAttributeDescriptor(VertexAttribute attribute = VertexAttribute.Position, VertexAttributeFormat format = VertexAttributeFormat.Float32,
            int dimension = 3, int stream = 0)
        {
            this.attribute = attribute;
            this.format = format;
            this.dimension = dimension;
            this.stream = stream;
        }

        public VertexAttribute attribute { get; set; }

        public VertexAttributeFormat format { get; set; }

        /// <summary>How many components, 1 to 4.</summary>
        public int dimension { get; set; }

        public int stream { get; set; }

        public override string ToString() => $"(attr={attribute} fmt={format} dim={dimension} stream={stream})";

        public override int GetHashCode() => (((int)attribute * 31 + (int)format) * 31 + dimension) * 31 + stream;

        public override bool Equals(object other) => other is VertexAttributeDescriptor d && Equals(d);

        public bool Equals(VertexAttributeDescriptor other) =>
            attribute == other.attribute && format == other.format && dimension == other.dimension && stream == other.stream;

        public static bool operator ==(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => lhs.Equals(rhs);

        public static bool operator !=(VertexAttributeDescriptor lhs, VertexAttributeDescriptor rhs) => !lhs.Equals(rhs);
    }

    /// <summary>A part of a mesh that has a material of its own.</summary>
    public struct SubMeshDescriptor
    {
        public SubMeshDescriptor(int indexStart, int indexCount, MeshTopology topology = MeshTopology.Triangles)
        {
            this.indexStart = indexStart;
            this.indexCount = indexCount;
            this.topology = topology;
            bounds = default;
            baseVertex = 0;
            firstVertex = 0;
            vertexCount = 0;
        }

        public Bounds bounds { get; set; }

        public MeshTopology topology { get; set; }

        public int indexStart { get; set; }

        public int indexCount { get; set; }

        public int baseVertex { get; set; }

        public int firstVertex { get; set; }

        public int vertexCount { get; set; }

        public override string ToString() =>
            $"(topo={topology} indices={indexStart},{indexCount} vertices={firstVertex},{vertexCount} basevtx={baseVertex} bounds={bounds})";
    }
}
