using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>A mesh on the device: all attributes of a vertex side by side, and the indices of all submeshes one after the other.</summary>
    sealed unsafe class MeshBuffers
    {
        readonly GpuBuffer m_Vertices;
        readonly GpuBuffer m_Indices;
        readonly (uint First, uint Count)[] m_Parts;

        internal MeshBuffers(string name, SortedDictionary<VertexAttribute, MeshChannel> channels, IReadOnlyList<SubMesh> parts, IndexFormat format)
        {
            Layout = MeshLayout.Of(channels.Select(c => new VertexAttributeDescriptor(c.Key, c.Value.Format, c.Value.Dimension)).ToList());
            var count = channels[VertexAttribute.Position].Count;
            m_Vertices = Fill("Mesh's vertices", name, Interleaved(channels.Values.ToList(), count), Layout.Stride, GraphicsBuffer.Target.Vertex);
            IsWide = format == IndexFormat.UInt32;
            m_Parts = new (uint, uint)[parts.Count];
            var indices = new List<int>();
            for (var i = 0; i < parts.Count; i++)
            {
                var first = indices.Count;
                indices.AddRange(parts[i].Topology == MeshTopology.Quads ? Triangles(parts[i].Indices) : parts[i].Indices);
                m_Parts[i] = ((uint)first, (uint)(indices.Count - first));
            }
            if (indices.Count > 0)
                m_Indices = Fill("Mesh's indices", name, IsWide ? Bytes(indices.ToArray()) : Bytes(indices.ConvertAll(i => (ushort)i).ToArray()),
                    IsWide ? 4 : 2, GraphicsBuffer.Target.Index);
        }

        internal MeshLayout Layout { get; }

        /// <summary>Whether indices have 32 bits.</summary>
        internal bool IsWide { get; }

        internal VulkanBuffer Vertices => m_Vertices.Storage;

        internal VulkanBuffer Indices => m_Indices.Storage;

        internal bool IsAlive => m_Vertices.IsAlive;

        /// <summary>The range of indices of a submesh.</summary>
        internal (uint First, uint Count) Part(int subMesh) => m_Parts[subMesh];

        internal void Release()
        {
            m_Vertices.Release();
            m_Indices?.Release();
        }

        static byte[] Interleaved(List<MeshChannel> channels, int count)
        {
            var stride = channels.Sum(c => c.Dimension * MeshLayout.SizeOf(c.Format));
            var bytes = new byte[stride * count];
            fixed (byte* start = bytes)
            {
                for (var vertex = 0; vertex < count; vertex++)
                {
                    var at = start + vertex * stride;
                    foreach (var channel in channels)
                        for (var c = 0; c < channel.Dimension; c++)
                            at += Write(at, channel.Format, channel.Values[vertex * channel.Dimension + c]);
                }
            }
            return bytes;
        }

        static int Write(byte* at, VertexAttributeFormat format, float value)
        {
            switch (format)
            {
                case VertexAttributeFormat.Float32:
                    *(float*)at = value;
                    return 4;
                case VertexAttributeFormat.UNorm8:
                    *at = (byte)Math.Round(Mathf.Clamp01(value) * 255f);
                    return 1;
                default:
                    throw new NotSupportedException($"vertices in {format}");
            }
        }

        static IEnumerable<int> Triangles(int[] quads)
        {
            for (var q = 0; q < quads.Length; q += 4)
                foreach (var corner in new[] { 0, 1, 2, 0, 2, 3 })
                    yield return quads[q + corner];
        }

        static byte[] Bytes<T>(T[] values) where T : unmanaged
        {
            var bytes = new byte[values.Length * sizeof(T)];
            Buffer.BlockCopy(values, 0, bytes, 0, bytes.Length);
            return bytes;
        }

        static GpuBuffer Fill(string kind, string name, byte[] bytes, int stride, GraphicsBuffer.Target target)
        {
            var buffer = new GpuBuffer(kind, bytes.Length / stride, stride, target) { Name = name };
            fixed (byte* data = bytes)
                buffer.Write(data, 0, bytes.Length);
            return buffer;
        }
    }
}
