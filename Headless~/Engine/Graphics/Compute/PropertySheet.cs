using System;
using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>A value as bytes and the kind of numbers it was set as.</summary>
    sealed class ConstantValue
    {
        internal byte[] Bytes = Array.Empty<byte>();
        internal NumberKind Number;
    }

    /// <summary>A texture bound to a name.</summary>
    readonly struct TextureValue
    {
        internal TextureValue(Texture texture, int mip, RenderTextureSubElement element = RenderTextureSubElement.Default)
        {
            Texture = texture;
            Mip = mip;
            Element = element;
        }

        internal readonly Texture Texture;
        internal readonly int Mip;
        internal readonly RenderTextureSubElement Element;

        /// <summary>The memory behind the part that is meant; null if there is none.</summary>
        internal GpuTexture Native => Element == RenderTextureSubElement.Depth ? ((RenderTexture)Texture).DepthNative : Texture.Native;

        /// <summary>How the texture is sampled: as it says, but without filtering where the device cannot filter its format.</summary>
        internal Vulkan.SamplerState Sampler
        {
            get
            {
                var own = Texture.Sampler;
                return own.Filter == FilterMode.Point || Native is not { } native || native.CanFilter ? own
                    : new Vulkan.SamplerState(FilterMode.Point, own.U, own.V, own.W);
            }
        }
    }

    /// <summary>A range of a buffer bound as a constant buffer. Bytes.</summary>
    readonly struct ConstantBufferValue
    {
        internal ConstantBufferValue(GpuBuffer buffer, int offset, int size)
        {
            Buffer = buffer;
            Offset = offset;
            Size = size;
        }

        internal readonly GpuBuffer Buffer;
        internal readonly int Offset;
        internal readonly int Size;
    }

    /// <summary>Values by name: of one shader, or the global ones.</summary>
    sealed unsafe class PropertySheet
    {
        readonly Dictionary<int, ConstantValue> m_Constants = new();

        internal Dictionary<int, ConstantBufferValue> ConstantBuffers { get; } = new();

        internal bool IsEmpty => m_Constants.Count == 0 && ConstantBuffers.Count == 0;

        internal void Remove(int name) => m_Constants.Remove(name);

        internal bool TryGet(int name, out ConstantValue value) => m_Constants.TryGetValue(name, out value);

        internal void Set(int name, void* data, int bytes, NumberKind number)
        {
            if (!m_Constants.TryGetValue(name, out var value))
                m_Constants.Add(name, value = new ConstantValue());
            if (value.Bytes.Length != bytes)
                value.Bytes = new byte[bytes];
            value.Number = number;
            new ReadOnlySpan<byte>(data, bytes).CopyTo(value.Bytes);
        }

        internal void Set<T>(int name, T value, NumberKind number) where T : unmanaged => Set(name, &value, sizeof(T), number);

        internal void Set<T>(int name, ReadOnlySpan<T> values, NumberKind number) where T : unmanaged
        {
            fixed (T* p = values)
                Set(name, p, values.Length * sizeof(T), number);
        }

        /// <summary>The value, or the type's default.</summary>
        internal T Get<T>(int name) where T : unmanaged
        {
            var result = default(T);
            if (m_Constants.TryGetValue(name, out var value))
                value.Bytes.AsSpan(0, Math.Min(value.Bytes.Length, sizeof(T))).CopyTo(new Span<byte>(&result, sizeof(T)));
            return result;
        }

        internal T[] GetArray<T>(int name) where T : unmanaged
        {
            if (!m_Constants.TryGetValue(name, out var value))
                return null;
            var result = new T[value.Bytes.Length / sizeof(T)];
            fixed (T* p = result)
                value.Bytes.AsSpan(0, result.Length * sizeof(T)).CopyTo(new Span<byte>(p, result.Length * sizeof(T)));
            return result;
        }

        internal void CopyTo(PropertySheet other)
        {
            foreach (var (name, value) in m_Constants)
                other.m_Constants[name] = new ConstantValue { Bytes = (byte[])value.Bytes.Clone(), Number = value.Number };
            foreach (var (name, value) in ConstantBuffers)
                other.ConstantBuffers[name] = value;
        }

        internal void Clear()
        {
            m_Constants.Clear();
            ConstantBuffers.Clear();
        }
    }
}
