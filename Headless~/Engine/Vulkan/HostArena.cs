using System;
using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>A piece of mapped memory that the device can read.</summary>
    readonly unsafe struct HostSlice
    {
        internal HostSlice(VulkanBuffer buffer, ulong offset)
        {
            Buffer = buffer;
            Offset = offset;
        }

        internal readonly VulkanBuffer Buffer;
        internal readonly ulong Offset;

        internal byte* Pointer => Buffer.Mapped + Offset;
    }

    /// <summary>Mapped chunks of one size, handed out in order and taken back when the device is done with them.</summary>
    sealed class HostArena : IDisposable
    {
        readonly VulkanDevice m_Device;
        readonly uint m_Usage;
        readonly Stack<VulkanBuffer> m_Free = new();
        readonly List<VulkanBuffer> m_All = new();
        VulkanBuffer m_Current;
        ulong m_Used;

        internal HostArena(VulkanDevice device, ulong chunkSize, uint usage)
        {
            m_Device = device;
            ChunkSize = chunkSize;
            m_Usage = usage;
        }

        internal ulong ChunkSize { get; }

        /// <summary>How many chunks exist.</summary>
        internal int ChunkCount => m_All.Count;

        /// <summary>Whether the next slice of that size needs a chunk that does not exist yet.</summary>
        internal bool WouldGrow(ulong size, ulong alignment) =>
            m_Free.Count == 0 && (m_Current == null || Align(m_Used, alignment) + size > ChunkSize);

        /// <summary>Takes a slice; a chunk that it starts is added to <paramref name="owned"/>.</summary>
        /// <exception cref="ArgumentOutOfRangeException">More than a chunk.</exception>
        internal HostSlice Take(ulong size, ulong alignment, List<VulkanBuffer> owned)
        {
            if (size > ChunkSize)
                throw new ArgumentOutOfRangeException(nameof(size), size, $"at most {ChunkSize} bytes fit");
            var offset = Align(m_Used, alignment);
            if (m_Current == null || offset + size > ChunkSize)
            {
                m_Current = m_Free.Count > 0 ? m_Free.Pop() : Grow();
                owned.Add(m_Current);
                offset = 0;
            }
            m_Used = offset + size;
            return new HostSlice(m_Current, offset);
        }

        /// <summary>A submission ends: its chunks are not to be written any more.</summary>
        internal void Seal()
        {
            m_Current = null;
            m_Used = 0;
        }

        internal void Return(List<VulkanBuffer> chunks)
        {
            foreach (var chunk in chunks)
                m_Free.Push(chunk);
            chunks.Clear();
        }

        public void Dispose()
        {
            foreach (var chunk in m_All)
                chunk.Dispose();
            m_All.Clear();
            m_Free.Clear();
            m_Current = null;
        }

        VulkanBuffer Grow()
        {
            var chunk = new VulkanBuffer(m_Device, ChunkSize, m_Usage, BufferPlace.Upload);
            m_All.Add(chunk);
            return chunk;
        }

        static ulong Align(ulong value, ulong alignment) => (value + alignment - 1) / alignment * alignment;
    }
}
