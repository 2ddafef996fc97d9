using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>
    /// Read-backs under way. Those asked for in one frame are handed out at the start of the next, always: the host waits for the device if
    /// it is not done by then, so that runs are repeatable. Results live until the frame after that starts.
    /// </summary>
    sealed unsafe class ReadbackQueue : IDisposable
    {
        const int MaxFreeBuffers = 8;

        readonly GpuContext m_Context;
        readonly List<ReadbackOperation> m_Pending = new();
        readonly List<ReadbackOperation> m_Readable = new();
        readonly List<VulkanBuffer> m_Free = new();
        long m_Frame;

        internal ReadbackQueue(GpuContext context) => m_Context = context;

        internal ReadbackOperation Enqueue(GpuTexture texture, int mip, in TexelBox box, FormatInfo asked, ReadbackOperation operation)
        {
            operation.Width = box.Width;
            operation.Height = box.Height;
            operation.Layers = box.Depth;
            operation.LayerBytes = (long)box.Width * box.Height * asked.BytesPerTexel;
            if (!SameBits(texture.Format, asked))
                operation.Conversion = (texture.Format, asked);
            operation.Buffer = Rent((ulong)(box.Texels * texture.Format.BytesPerTexel));
            texture.CopyTo(operation.Buffer, 0, mip, box);
            return Enqueue(operation);
        }

        internal ReadbackOperation Enqueue(GpuBuffer buffer, int size, int offset, ReadbackOperation operation)
        {
            operation.Width = size;
            operation.Height = 1;
            operation.LayerBytes = size;
            operation.Buffer = Rent((ulong)size);
            buffer.CopyTo(operation.Buffer, (ulong)offset, (ulong)size);
            return Enqueue(operation);
        }

        /// <summary>Reads texels and waits for them.</summary>
        internal byte[] ReadNow(GpuTexture texture, int mip, in TexelBox box)
        {
            var bytes = new byte[box.Texels * texture.Format.BytesPerTexel];
            var buffer = Rent((ulong)bytes.Length);
            texture.CopyTo(buffer, 0, mip, box);
            m_Context.Stream.Wait(buffer.LastUse);
            Marshal.Copy((IntPtr)buffer.Mapped, bytes, 0, bytes.Length);
            Return(buffer);
            return bytes;
        }

        /// <summary>A frame starts: old results end, new ones appear.</summary>
        internal void BeginFrame()
        {
            m_Frame++;
            foreach (var operation in m_Readable)
                End(operation);
            m_Readable.Clear();
            CompleteUntil(m_Frame - 1);
        }

        /// <summary>Waits for one and makes it readable until the next frame.</summary>
        internal void Complete(ReadbackOperation operation)
        {
            if (!m_Pending.Remove(operation))
                return;
            m_Context.Stream.Wait(operation.Buffer.LastUse);
            m_Readable.Add(operation);
            operation.Complete();
        }

        internal void CompleteAll() => CompleteUntil(m_Frame);

        /// <summary>The device ends: what is under way fails.</summary>
        internal void Cancel()
        {
            foreach (var operation in m_Pending.ToArray())
            {
                operation.Fail();
                m_Readable.Add(operation);
            }
            m_Pending.Clear();
        }

        public void Dispose()
        {
            foreach (var operation in m_Readable)
            {
                operation.Expire();
                operation.Buffer.Dispose();
            }
            m_Readable.Clear();
            foreach (var buffer in m_Free)
                buffer.Dispose();
            m_Free.Clear();
        }

        static bool SameBits(FormatInfo a, FormatInfo b) => FormatTables.ToLinear(a.Format) == FormatTables.ToLinear(b.Format);

        ReadbackOperation Enqueue(ReadbackOperation operation)
        {
            operation.Frame = m_Frame;
            m_Pending.Add(operation);
            return operation;
        }

        void CompleteUntil(long frame)
        {
            // Callbacks may ask for more: those belong to the present frame and wait.
            foreach (var operation in m_Pending.FindAll(o => o.Frame <= frame))
                Complete(operation);
        }

        void End(ReadbackOperation operation)
        {
            operation.Expire();
            Return(operation.Buffer);
        }

        VulkanBuffer Rent(ulong size)
        {
            var index = m_Free.FindIndex(b => b.Size >= size && b.Size <= 2 * size + 4096);
            if (index >= 0)
            {
                var buffer = m_Free[index];
                m_Free.RemoveAt(index);
                return buffer;
            }
            return new VulkanBuffer(m_Context.Device, size, Vk.VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferPlace.Readback);
        }

        void Return(VulkanBuffer buffer)
        {
            m_Free.Add(buffer);
            if (m_Free.Count <= MaxFreeBuffers)
                return;
            m_Context.Stream.Release(m_Free[0], m_Free[0].LastUse);
            m_Free.RemoveAt(0);
        }
    }
}
