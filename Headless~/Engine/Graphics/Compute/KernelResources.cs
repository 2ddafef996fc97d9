using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Textures and buffers by name: of one kernel, or the global ones.</summary>
    sealed class KernelResources
    {
        internal Dictionary<int, TextureValue> Textures { get; } = new();

        internal Dictionary<int, GpuBuffer> Buffers { get; } = new();

        internal void CopyTo(KernelResources other)
        {
            foreach (var (name, value) in Textures)
                other.Textures[name] = value;
            foreach (var (name, value) in Buffers)
                other.Buffers[name] = value;
        }

        internal void Clear()
        {
            Textures.Clear();
            Buffers.Clear();
        }
    }
}
