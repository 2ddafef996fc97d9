using System;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>The memory behind a GraphicsBuffer or a ComputeBuffer, with its hidden counter if it has one.</summary>
    sealed unsafe class GpuBuffer : IGpuObject
    {
        // As float not a number, as bytes and integers conspicuous.
        const uint FillPattern = 0xFFCDCDCD;

        const uint Usage = Vk.VK_BUFFER_USAGE_TRANSFER_SRC_BIT | Vk.VK_BUFFER_USAGE_TRANSFER_DST_BIT | Vk.VK_BUFFER_USAGE_STORAGE_BUFFER_BIT
            | Vk.VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | Vk.VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | Vk.VK_BUFFER_USAGE_VERTEX_BUFFER_BIT
                | Vk.VK_BUFFER_USAGE_INDEX_BUFFER_BIT | Vk.VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;

        readonly GpuContext m_Context;
        readonly string m_Kind;
        string m_Name;

        internal GpuBuffer(string kind, int count, int stride, GraphicsBuffer.Target target)
        {
            m_Context = Gpu.Context;
            m_Kind = kind;
            Count = count;
            Stride = stride;
            Target = target;
            // Whole words, so that a raw view can read the last one.
            var size = (Size + 3) / 4 * 4;
            Storage = new VulkanBuffer(m_Context.Device, (ulong)size, Usage, BufferPlace.Device);
            if ((target & (GraphicsBuffer.Target.Append | GraphicsBuffer.Target.Counter)) != 0)
                Counter = new VulkanBuffer(m_Context.Device, 4, Usage, BufferPlace.Device);
            m_Context.Add(this);
            if (GpuOptions.FillNewMemory)
                Fill(Storage, FillPattern);
            if (Counter != null)
                Fill(Counter, 0);
        }

        internal int Count { get; }

        internal int Stride { get; }

        internal GraphicsBuffer.Target Target { get; }

        internal long Size => (long)Count * Stride;

        internal VulkanBuffer Storage { get; private set; }

        internal VulkanBuffer Counter { get; private set; }

        internal bool IsAlive => Storage != null && !m_Context.IsDisposed;

        internal string Name
        {
            get => m_Name;
            set
            {
                m_Name = value;
                if (IsAlive)
                    m_Context.Device.SetName(Vk.VK_OBJECT_TYPE_BUFFER, Storage.Handle, value);
            }
        }

        public bool IsTexture => false;

        public long Bytes => Size;

        public string Describe() => $"{m_Kind} '{m_Name}': {Count} x {Stride} bytes";

        public void FreeNow()
        {
            Storage?.Dispose();
            Counter?.Dispose();
            Storage = Counter = null;
        }

        /// <summary>Frees the memory when the device is done with it.</summary>
        internal void Release()
        {
            if (!IsAlive)
                return;
            m_Context.Remove(this);
            m_Context.Stream.Release(Storage, Storage.LastUse);
            if (Counter != null)
                m_Context.Stream.Release(Counter, Counter.LastUse);
            Storage = Counter = null;
        }

        /// <summary>Writes bytes in order with all other work. Does not wait.</summary>
        internal void Write(void* source, long offset, long bytes)
        {
            var stream = m_Context.Stream;
            if (Storage.Mapped != null && Storage.LastUse <= stream.Completed)
            {
                Buffer.MemoryCopy(source, Storage.Mapped + offset, Size - offset, bytes);
                return;
            }
            while (bytes > 0)
            {
                var part = Math.Min(bytes, (long)stream.MaxSlice);
                var slice = stream.Staging((ulong)part);
                Buffer.MemoryCopy(source, slice.Pointer, part, part);
                CopyFrom(slice.Buffer, slice.Offset, (ulong)offset, (ulong)part);
                source = (byte*)source + part;
                offset += part;
                bytes -= part;
            }
        }

        /// <summary>Reads bytes; waits for all work that was asked for so far.</summary>
        internal void Read(void* target, long offset, long bytes)
        {
            var stream = m_Context.Stream;
            if (Storage.Mapped != null)
            {
                stream.Wait(Storage.LastUse);
                Buffer.MemoryCopy(Storage.Mapped + offset, target, bytes, bytes);
                return;
            }
            using var readback = new VulkanBuffer(m_Context.Device, (ulong)bytes, Vk.VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferPlace.Readback);
            CopyTo(readback, (ulong)offset, (ulong)bytes);
            stream.Wait(readback.LastUse);
            Buffer.MemoryCopy(readback.Mapped, target, bytes, bytes);
        }

        /// <summary>Records a copy from here to the start of another buffer.</summary>
        internal void CopyTo(VulkanBuffer target, ulong offset, ulong bytes) => Copy(m_Context, Storage, offset, target, 0, bytes);

        internal void CopyFrom(VulkanBuffer source, ulong sourceOffset, ulong offset, ulong bytes) =>
            Copy(m_Context, source, sourceOffset, Storage, offset, bytes);

        internal void SetCounter(uint value) => Fill(Counter, value);

        internal static void Copy(GpuContext context, VulkanBuffer source, ulong sourceOffset, VulkanBuffer target, ulong targetOffset, ulong bytes)
        {
            context.Stream.Read(source);
            context.Stream.Write(target);
            var region = new VkBufferCopy { srcOffset = sourceOffset, dstOffset = targetOffset, size = bytes };
            var commands = context.Stream.Command();
            context.Device.Api.vkCmdCopyBuffer(commands, source.Handle, target.Handle, 1, &region);
        }

        void Fill(VulkanBuffer buffer, uint word)
        {
            if (buffer.Mapped != null && buffer.LastUse <= m_Context.Stream.Completed)
            {
                for (ulong done = 0; done < buffer.Size; done += 1 << 30)
                    new Span<uint>(buffer.Mapped + done, (int)(Math.Min(buffer.Size - done, 1 << 30) / 4)).Fill(word);
                return;
            }
            m_Context.Stream.Write(buffer);
            var commands = m_Context.Stream.Command();
            m_Context.Device.Api.vkCmdFillBuffer(commands, buffer.Handle, 0, Vk.VK_WHOLE_SIZE, word);
        }
    }
}
