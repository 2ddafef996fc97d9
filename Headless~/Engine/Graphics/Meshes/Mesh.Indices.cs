using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed partial class Mesh
    {
        public int subMeshCount
        {
            get { Use("get_subMeshCount"); return m_SubMeshes.Count; }
            set
            {
                Change("set_subMeshCount");
                while (m_SubMeshes.Count > Math.Max(0, value))
                    m_SubMeshes.RemoveAt(m_SubMeshes.Count - 1);
                while (m_SubMeshes.Count < value)
                    m_SubMeshes.Add(new SubMesh());
            }
        }

        /// <summary>The triangles of all submeshes; setting them leaves one submesh, and the bounds are computed anew.</summary>
        public int[] triangles
        {
            get => m_SubMeshes.Where(s => s.Topology == MeshTopology.Triangles).SelectMany(s => s.Indices.Select(i => i + s.BaseVertex)).ToArray();
            set
            {
                subMeshCount = 1;
                SetTriangles(value, 0);
            }
        }

        public void SetTriangles(int[] triangles, int submesh) => SetTriangles(triangles, submesh, true);

        public void SetTriangles(int[] triangles, int submesh, bool calculateBounds) => SetTriangles(triangles, submesh, calculateBounds, 0);

        public void SetTriangles(int[] triangles, int submesh, bool calculateBounds, int baseVertex) =>
            SetIndices(triangles, MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

        public void SetTriangles(List<int> triangles, int submesh) => SetTriangles(triangles?.ToArray(), submesh);

        public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds) => SetTriangles(triangles?.ToArray(), submesh, calculateBounds);

        public void SetTriangles(ushort[] triangles, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
            SetIndices(triangles, MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

        public void SetIndices(int[] indices, MeshTopology topology, int submesh) => SetIndices(indices, topology, submesh, true);

        public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds) =>
            SetIndices(indices, topology, submesh, calculateBounds, 0);

        /// <param name="indices">Which vertices.</param>
        /// <param name="topology">What they form.</param>
        /// <param name="submesh">0 to <see cref="subMeshCount"/> - 1.</param>
        /// <param name="calculateBounds">Whether the mesh's bounds are computed anew.</param>
        /// <param name="baseVertex">Is added to every index.</param>
        public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds, int baseVertex)
        {
            Change("SetIndices");
            if (submesh < 0 || submesh >= m_SubMeshes.Count)
            {
                Debug.LogError($"Failed setting indices. Submesh index is out of bounds ({submesh} of {m_SubMeshes.Count}, mesh '{NameForMessages}').");
                return;
            }
            indices ??= Array.Empty<int>();
            if (Problem(indices, topology, baseVertex) is { } problem)
            {
                Debug.LogError($"Failed setting {(topology == MeshTopology.Triangles ? "triangles" : "indices")}. {problem} (mesh '{NameForMessages}').");
                return;
            }
            m_SubMeshes[submesh] = new SubMesh { Indices = (int[])indices.Clone(), Topology = topology, BaseVertex = baseVertex };
            if (calculateBounds)
                m_Bounds = MeshMath.Bounds(vertices);
        }

        public void SetIndices(ushort[] indices, MeshTopology topology, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
            SetIndices(Array.ConvertAll(indices ?? Array.Empty<ushort>(), i => (int)i), topology, submesh, calculateBounds, baseVertex);

        public void SetIndices(List<int> indices, MeshTopology topology, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
            SetIndices(indices?.ToArray(), topology, submesh, calculateBounds, baseVertex);

        public int[] GetTriangles(int submesh) =>
            SubMesh(submesh).Topology == MeshTopology.Triangles ? GetIndices(submesh) : Array.Empty<int>();

        public int[] GetIndices(int submesh) => GetIndices(submesh, true);

        public int[] GetIndices(int submesh, bool applyBaseVertex)
        {
            Use("GetIndices");
            var part = SubMesh(submesh);
            return part.Indices.Select(i => applyBaseVertex ? i + part.BaseVertex : i).ToArray();
        }

        public MeshTopology GetTopology(int submesh) => SubMesh(submesh).Topology;

        public uint GetIndexCount(int submesh) => (uint)SubMesh(submesh).Indices.Length;

        public uint GetIndexStart(int submesh)
        {
            SubMesh(submesh);
            return (uint)m_SubMeshes.Take(submesh).Sum(s => s.Indices.Length);
        }

        public uint GetBaseVertex(int submesh) => (uint)SubMesh(submesh).BaseVertex;

        public SubMeshDescriptor GetSubMesh(int index)
        {
            var part = SubMesh(index);
            var used = part.Indices.Select(i => i + part.BaseVertex).DefaultIfEmpty(0).ToArray();
            return new SubMeshDescriptor((int)GetIndexStart(index), part.Indices.Length, part.Topology)
            {
                baseVertex = part.BaseVertex,
                firstVertex = used.Min(),
                vertexCount = part.Indices.Length == 0 ? 0 : used.Max() - used.Min() + 1,
                bounds = m_Bounds,
            };
        }

        SubMesh SubMesh(int index) => index >= 0 && index < m_SubMeshes.Count ? m_SubMeshes[index]
            : throw new IndexOutOfRangeException($"Submesh {index} is outside 0 to {m_SubMeshes.Count - 1} (mesh '{NameForMessages}')");

        string Problem(int[] indices, MeshTopology topology, int baseVertex)
        {
            var multiple = topology switch { MeshTopology.Triangles => 3, MeshTopology.Quads => 4, MeshTopology.Lines => 2, _ => 1 };
            if (indices.Length % multiple != 0)
                return $"The number of supplied {(multiple == 3 ? "triangle " : "")}indices must be a multiple of {multiple}.";
            foreach (var index in indices)
            {
                if (index < 0 || index + baseVertex < 0 || index + baseVertex >= vertexCount)
                    return $"Some indices are referencing out of bounds vertices. IndexCount: {indices.Length}, VertexCount: {vertexCount}";
                if (m_IndexFormat == IndexFormat.UInt16 && index > MaxUInt16Vertices)
                    return $"Index {index} does not fit into 16 bits; set indexFormat to UInt32 first.";
            }
            return null;
        }
    }
}
