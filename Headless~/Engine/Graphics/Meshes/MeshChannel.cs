using System;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>One attribute of all vertices, as floats whatever the format on the device is.</summary>
    sealed class MeshChannel
    {
        internal MeshChannel(VertexAttributeFormat format, int dimension, float[] values)
        {
            Format = format;
            Dimension = dimension;
            Values = values;
            Count = values.Length / dimension;
        }

        internal VertexAttributeFormat Format { get; }

        internal int Dimension { get; }

        internal int Count { get; }

        /// <summary>Null once the CPU's copy is dropped.</summary>
        internal float[] Values { get; private set; }

        internal void Drop() => Values = null;

        internal MeshChannel Copy() => new(Format, Dimension, (float[])Values.Clone());

        internal static MeshChannel Of(Vector2[] values) => Of(VertexAttributeFormat.Float32, 2, values, (v, target) => (target[0], target[1]) = (v.x, v.y));

        internal static MeshChannel Of(Vector3[] values) =>
            Of(VertexAttributeFormat.Float32, 3, values, (v, target) => (target[0], target[1], target[2]) = (v.x, v.y, v.z));

        internal static MeshChannel Of(Vector4[] values) => Of(VertexAttributeFormat.Float32, 4, values, Set);

        internal static MeshChannel Of(Color[] values) => Of(VertexAttributeFormat.Float32, 4, values, (c, target) => Set(c, target));

        internal static MeshChannel Of(Color32[] values) => Of(VertexAttributeFormat.UNorm8, 4, values, (c, target) => Set((Color)c, target));

        /// <summary>A value with zeros, and 1 in w, for components that there are none of.</summary>
        internal Vector4 this[int vertex]
        {
            get
            {
                var value = new Vector4(0f, 0f, 0f, 1f);
                for (var c = 0; c < Dimension; c++)
                    value[c] = Values[vertex * Dimension + c];
                return value;
            }
        }

        internal T[] Read<T>(Func<Vector4, T> convert)
        {
            var result = new T[Count];
            for (var i = 0; i < Count; i++)
                result[i] = convert(this[i]);
            return result;
        }

        static void Set(Vector4 v, Span<float> target) => (target[0], target[1], target[2], target[3]) = (v.x, v.y, v.z, v.w);

        delegate void Writer<T>(T value, Span<float> target);

        static MeshChannel Of<T>(VertexAttributeFormat format, int dimension, T[] values, Writer<T> write)
        {
            var floats = new float[values.Length * dimension];
            for (var i = 0; i < values.Length; i++)
                write(values[i], floats.AsSpan(i * dimension, dimension));
            return new MeshChannel(format, dimension, floats);
        }
    }

    /// <summary>The indices of one submesh, as they were set.</summary>
    sealed class SubMesh
    {
        internal int[] Indices = Array.Empty<int>();
        internal MeshTopology Topology;
        internal int BaseVertex;

        internal SubMesh Copy() => new() { Indices = (int[])Indices.Clone(), Topology = Topology, BaseVertex = BaseVertex };
    }
}
