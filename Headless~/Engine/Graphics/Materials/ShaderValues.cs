using System;
using System.Collections.Generic;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>
    /// Values, textures and buffers by name: of a material or a property block. Colours are kept as they were set and, for shaders, turned into
    /// the project's colour space.
    /// </summary>
    sealed class ShaderValues
    {
        readonly Dictionary<int, Color> m_Colors = new();

        internal PropertySheet Numbers { get; } = new();

        internal KernelResources Resources { get; } = new();

        internal bool IsEmpty => Numbers.IsEmpty && Resources.Textures.Count == 0 && Resources.Buffers.Count == 0;

        internal bool HasColor(int name) => m_Colors.ContainsKey(name);

        internal bool HasNumber(int name) => Numbers.TryGet(name, out _);

        internal void Set<T>(int name, T value, NumberKind number) where T : unmanaged
        {
            m_Colors.Remove(name);
            Numbers.Set(name, value, number);
        }

        internal void Set<T>(int name, ReadOnlySpan<T> values) where T : unmanaged
        {
            if (values.Length == 0)
                throw new ArgumentException("Zero-sized array is not allowed.");
            m_Colors.Remove(name);
            Numbers.Set(name, values, NumberKind.Float);
        }

        internal void SetColor(int name, Color value)
        {
            Numbers.Set(name, (Vector4)ColorSpaces.ToShader(value), NumberKind.Float);
            m_Colors[name] = value;
        }

        /// <summary>Each value takes a row of 16 bytes, as arrays in constant buffers do.</summary>
        internal void SetFloats(int name, IReadOnlyList<float> values)
        {
            var rows = new Vector4[values?.Count ?? throw new ArgumentNullException(nameof(values))];
            for (var i = 0; i < rows.Length; i++)
                rows[i] = new Vector4(values[i], 0, 0, 0);
            Set(name, new ReadOnlySpan<Vector4>(rows));
        }

        internal Color GetColor(int name) => m_Colors.TryGetValue(name, out var color) ? color : (Color)Numbers.Get<Vector4>(name);

        internal Vector4 GetVector(int name) => m_Colors.TryGetValue(name, out var color) ? (Vector4)color : Numbers.Get<Vector4>(name);

        internal float[] GetFloats(int name)
        {
            var rows = Numbers.GetArray<Vector4>(name);
            return rows == null ? null : Array.ConvertAll(rows, r => r.x);
        }

        internal void CopyTo(ShaderValues other)
        {
            foreach (var (name, color) in m_Colors)
                other.m_Colors[name] = color;
            Numbers.CopyTo(other.Numbers);
            Resources.CopyTo(other.Resources);
        }

        internal void Clear()
        {
            m_Colors.Clear();
            Numbers.Clear();
            Resources.Clear();
        }
    }
}
