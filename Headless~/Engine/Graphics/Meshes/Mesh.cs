using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Vertices and what they form. Destroy it: nobody else does.</summary>
    public sealed partial class Mesh : Object
    {
        const int MaxUInt16Vertices = 65535;

        readonly SortedDictionary<VertexAttribute, MeshChannel> m_Channels = new();
        readonly List<SubMesh> m_SubMeshes = new();
        MeshBuffers m_Buffers;
        IndexFormat m_IndexFormat = IndexFormat.UInt16;
        Bounds m_Bounds;
        bool m_Changed = true;

        public Mesh()
        {
            MainThread.Check("Internal_Create");
            m_SubMeshes.Add(new SubMesh());
        }

        /// <summary>Whether the CPU's copy exists.</summary>
        public bool isReadable { get; private set; } = true;

        public int vertexCount => m_Channels.TryGetValue(VertexAttribute.Position, out var positions) ? positions.Count : 0;

        /// <summary>16 bits reach 65,535 vertices.</summary>
        public IndexFormat indexFormat
        {
            get { Use("get_indexFormat"); return m_IndexFormat; }
            set
            {
                Use("set_indexFormat");
                if (m_IndexFormat == value)
                    return;
                m_IndexFormat = value;
                m_Changed = true;
            }
        }

        /// <summary>The box around all vertices, in the mesh's own space; what culling goes by.</summary>
        public Bounds bounds
        {
            get { Use("get_bounds"); return m_Bounds; }
            set { Use("set_bounds"); m_Bounds = value; }
        }

        public int vertexAttributeCount => m_Channels.Count;

        public bool HasVertexAttribute(VertexAttribute attr) => m_Channels.ContainsKey(attr);

        public int GetVertexAttributeDimension(VertexAttribute attr) => m_Channels.TryGetValue(attr, out var channel) ? channel.Dimension : 0;

        public VertexAttributeFormat GetVertexAttributeFormat(VertexAttribute attr) =>
            m_Channels.TryGetValue(attr, out var channel) ? channel.Format : VertexAttributeFormat.Float32;

        /// <summary>Takes away all vertices and triangles.</summary>
        public void Clear() => Clear(true);

        public void Clear(bool keepVertexLayout)
        {
            Change("Clear");
            m_Channels.Clear();
            m_SubMeshes.Clear();
            m_SubMeshes.Add(new SubMesh());
            m_Bounds = default;
        }

        /// <summary>Hints that the mesh changes often; nothing depends on it here.</summary>
        public void MarkDynamic() => Use("MarkDynamic");

        /// <summary>Uploads now what would be uploaded with the next draw.</summary>
        /// <param name="markNoLongerReadable">Whether the CPU's copy is dropped; the mesh cannot be changed any more.</param>
        public void UploadMeshData(bool markNoLongerReadable)
        {
            Change("UploadMeshData");
            Upload();
            if (!markNoLongerReadable)
                return;
            isReadable = false;
            foreach (var channel in m_Channels.Values)
                channel.Drop();
        }

        public void RecalculateBounds() => RecalculateBounds(MeshUpdateFlags.Default);

        public void RecalculateBounds(MeshUpdateFlags flags)
        {
            Change("RecalculateBounds");
            m_Bounds = MeshMath.Bounds(vertices);
        }

        public void RecalculateNormals() => RecalculateNormals(MeshUpdateFlags.Default);

        /// <summary>Each vertex's normal is the mean of its triangles', by area.</summary>
        public void RecalculateNormals(MeshUpdateFlags flags)
        {
            Change("RecalculateNormals");
            normals = MeshMath.Normals(vertices, triangles);
        }

        /// <summary>The memory on the device, up to date; null if there is nothing to draw.</summary>
        internal MeshBuffers Buffers
        {
            get
            {
                if (m_Changed && isReadable)
                    Upload();
                return m_Buffers is { IsAlive: true } ? m_Buffers : null;
            }
        }

        internal IReadOnlyList<SubMesh> SubMeshes => m_SubMeshes;

        internal override Object CloneNative()
        {
            if (!isReadable)
                throw new InvalidOperationException($"Not allowed to clone mesh '{NameForMessages}': it is not readable");
            var copy = new Mesh { m_IndexFormat = m_IndexFormat, m_Bounds = m_Bounds };
            foreach (var (attribute, channel) in m_Channels)
                copy.m_Channels.Add(attribute, channel.Copy());
            copy.m_SubMeshes.Clear();
            foreach (var subMesh in m_SubMeshes)
                copy.m_SubMeshes.Add(subMesh.Copy());
            return copy;
        }

        internal override void OnNativeDestroy()
        {
            m_Buffers?.Release();
            m_Buffers = null;
        }

        void Upload()
        {
            m_Changed = false;
            m_Buffers?.Release();
            m_Buffers = vertexCount == 0 ? null : new MeshBuffers(NameForMessages, m_Channels, m_SubMeshes, m_IndexFormat);
        }

        void Change(string api)
        {
            Use(api);
            if (!isReadable)
                throw new InvalidOperationException($"Not allowed to call {api} on mesh '{NameForMessages}': it was uploaded with markNoLongerReadable");
            m_Changed = true;
        }
    }
}
