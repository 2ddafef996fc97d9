using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Where a mesh's attributes lie in its vertices. Equal layouts are the same object.</summary>
    sealed class MeshLayout
    {
        /// <summary>A draw without a mesh.</summary>
        internal static readonly MeshLayout None = new("", Array.Empty<VertexAttributeDescriptor>(), 0);

        static readonly Dictionary<string, MeshLayout> s_Known = new();

        readonly Dictionary<VertexAttribute, (uint Format, int Offset, bool Integer)> m_Attributes = new();

        MeshLayout(string key, IEnumerable<VertexAttributeDescriptor> attributes, int id)
        {
            Key = key;
            Id = id;
            foreach (var a in attributes)
            {
                m_Attributes.Add(a.attribute, (VulkanFormat(a), Stride, IsInteger(a.format)));
                Stride += a.dimension * SizeOf(a.format);
            }
        }

        /// <summary>Bytes per vertex.</summary>
        internal int Stride { get; }

        /// <summary>A number of its own.</summary>
        internal int Id { get; }

        string Key { get; }

        internal static MeshLayout Of(IReadOnlyList<VertexAttributeDescriptor> attributes)
        {
            var key = string.Join(" ", attributes.Select(a => $"{a.attribute}{a.format}{a.dimension}"));
            if (!s_Known.TryGetValue(key, out var layout))
                s_Known.Add(key, layout = new MeshLayout(key, attributes, s_Known.Count + 1));
            return layout;
        }

        internal bool TryGet(VertexAttribute attribute, out uint format, out int offset, out bool integer)
        {
            var found = m_Attributes.TryGetValue(attribute, out var value);
            (format, offset, integer) = value;
            return found;
        }

        /// <summary>The attribute that a semantic stands for.</summary>
        /// <exception cref="NotSupportedException">There is none.</exception>
        internal static VertexAttribute Attribute(string semantic) => semantic switch
        {
            "POSITION0" or "SV_POSITION0" => VertexAttribute.Position,
            "NORMAL0" => VertexAttribute.Normal,
            "TANGENT0" => VertexAttribute.Tangent,
            "COLOR0" => VertexAttribute.Color,
            "BLENDWEIGHT0" or "BLENDWEIGHTS0" => VertexAttribute.BlendWeight,
            "BLENDINDICES0" => VertexAttribute.BlendIndices,
            _ when semantic.StartsWith("TEXCOORD", StringComparison.Ordinal) && semantic.Length == 9 && semantic[8] < '8' =>
                VertexAttribute.TexCoord0 + (semantic[8] - '0'),
            _ => throw new NotSupportedException($"a vertex stage reads {semantic}, which meshes do not have"),
        };

        internal static int SizeOf(VertexAttributeFormat format) => format switch
        {
            VertexAttributeFormat.Float32 or VertexAttributeFormat.UInt32 or VertexAttributeFormat.SInt32 => 4,
            VertexAttributeFormat.UNorm8 or VertexAttributeFormat.SNorm8 or VertexAttributeFormat.UInt8 or VertexAttributeFormat.SInt8 => 1,
            _ => 2,
        };

        public override string ToString() => Key;

        static bool IsInteger(VertexAttributeFormat format) => format >= VertexAttributeFormat.UInt8;

        static uint VulkanFormat(VertexAttributeDescriptor a)
        {
            // vulkan_core.h numbers the formats of one channel layout in a row: UNORM SNORM USCALED SSCALED UINT SINT (SRGB | SFLOAT).
            uint first = (SizeOf(a.format), a.dimension) switch
            {
                (1, 1) => 9, (1, 2) => 16, (1, 3) => 23, (1, 4) => 37,
                (2, 1) => 70, (2, 2) => 77, (2, 3) => 84, (2, 4) => 91,
                (4, 1) => 98, (4, 2) => 101, (4, 3) => 104, (4, 4) => 107,
                _ => throw new ArgumentException($"{a.attribute} cannot have {a.dimension} components"),
            };
            return a.format switch
            {
                VertexAttributeFormat.UInt32 => first,
                VertexAttributeFormat.SInt32 => first + 1,
                VertexAttributeFormat.Float32 => first + 2,
                VertexAttributeFormat.UNorm8 or VertexAttributeFormat.UNorm16 => first,
                VertexAttributeFormat.SNorm8 or VertexAttributeFormat.SNorm16 => first + 1,
                VertexAttributeFormat.UInt8 or VertexAttributeFormat.UInt16 => first + 4,
                VertexAttributeFormat.SInt8 or VertexAttributeFormat.SInt16 => first + 5,
                _ => first + 6,
            };
        }
    }
}
