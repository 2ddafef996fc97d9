using System;
using System.Collections.Generic;
using Unity.Collections;

namespace UnityEngine
{
    /// <summary>A buffer on the GPU. Release it: nobody else does.</summary>
    public sealed partial class GraphicsBuffer : IDisposable
    {
        const string TypeName = "GraphicsBuffer";
        const int MaxStructuredStride = 2048;

        readonly GpuBuffer m_Buffer;

        /// <exception cref="ArgumentException">Count, stride or size is out of range, or they do not fit the target.</exception>
        public GraphicsBuffer(Target target, int count, int stride)
            : this(target, IsPure(target) ? UsageFlags.LockBufferForWrite : UsageFlags.None, count, stride)
        {
        }

        /// <exception cref="ArgumentException">Count, stride or size is out of range, or they do not fit the target.</exception>
        public GraphicsBuffer(Target target, UsageFlags usageFlags, int count, int stride)
        {
            MainThread.Check("GraphicsBuffer constructor");
            if (count <= 0)
                throw new ArgumentException("Attempting to create a zero length graphics buffer", nameof(count));
            if (stride <= 0)
                throw new ArgumentException("Attempting to create a graphics buffer with a negative or null stride", nameof(stride));
            if ((target & Target.Index) != 0 && stride != 2 && stride != 4)
                throw new ArgumentException("Attempting to create an index buffer with an invalid stride: " + stride, nameof(stride));
            const Target loose = Target.Vertex | Target.Index | Target.CopySource | Target.CopyDestination;
            if ((target & ~loose) != 0 && stride % 4 != 0)
                throw new ArgumentException("Stride must be a multiple of 4 unless the buffer is only used as a vertex buffer and/or index buffer",
                    nameof(stride));
            if ((target & Target.Structured) != 0 && stride > MaxStructuredStride)
                throw new ArgumentException($"Structured buffers have strides of at most {MaxStructuredStride} bytes, not {stride}", nameof(stride));
            if ((target & Target.Raw) != 0 && (target & Target.Structured) == 0 && stride != 4)
                throw new ArgumentException("Raw buffers have a stride of 4 bytes, not " + stride, nameof(stride));
            if ((usageFlags & UsageFlags.LockBufferForWrite) != 0 && (target & Target.CopyDestination) != 0)
                throw new ArgumentException("A buffer that is locked for writing cannot be a copy destination", nameof(target));
            var size = (long)count * stride;
            if (size > SystemInfo.maxGraphicsBufferSize)
                throw new ArgumentException($"The total size of the graphics buffer ({size} bytes) exceeds the maximum buffer size. Maximum supported "
                    + $"buffer size: {SystemInfo.maxGraphicsBufferSize} bytes.");
            this.usageFlags = usageFlags;
            m_Buffer = new GpuBuffer(TypeName, count, stride, target);
        }

        ~GraphicsBuffer()
        {
            if (m_Buffer is { IsAlive: true })
                Debug.LogWarning("GarbageCollector disposing of GraphicsBuffer. Please use GraphicsBuffer.Release() or .Dispose() to manually release the "
                    + "buffer.");
        }

        public int count => Alive("count").Count;

        /// <summary>Bytes per element.</summary>
        public int stride => Alive("stride").Stride;

        public Target target => Alive("target").Target;

        public UsageFlags usageFlags { get; }

        public string name
        {
            set => Alive("name").Name = value;
        }

        internal GpuBuffer Native => m_Buffer;

        public bool IsValid() => m_Buffer.IsAlive;

        public void Dispose()
        {
            MainThread.Check("GraphicsBuffer.Dispose");
            m_Buffer.Release();
            GC.SuppressFinalize(this);
        }

        public void Release() => Dispose();

        /// <exception cref="ArgumentException">The elements are not blittable.</exception>
        public void SetData(Array data) => BufferTransfer.Set(Alive("SetData"), TypeName, data, 0, 0, data?.Length ?? 0);

        /// <param name="data">The source.</param>
        /// <param name="managedBufferStartIndex">First element in the source.</param>
        /// <param name="graphicsBufferStartIndex">First element in the buffer, in units of the source's element size.</param>
        /// <param name="count">Elements.</param>
        /// <exception cref="ArgumentException">The elements are not blittable.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The range does not fit source or buffer.</exception>
        public void SetData(Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count) =>
            BufferTransfer.Set(Alive("SetData"), TypeName, data, managedBufferStartIndex, graphicsBufferStartIndex, count);

        public void SetData<T>(List<T> data) where T : struct => BufferTransfer.Set(Alive("SetData"), TypeName, data, 0, 0, data?.Count ?? 0);

        public void SetData<T>(List<T> data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count) where T : struct =>
            BufferTransfer.Set(Alive("SetData"), TypeName, data, managedBufferStartIndex, graphicsBufferStartIndex, count);

        public void SetData<T>(NativeArray<T> data) where T : struct => BufferTransfer.Set(Alive("SetData"), TypeName, data, 0, 0, data.Length);

        public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count) where T : struct =>
            BufferTransfer.Set(Alive("SetData"), TypeName, data, nativeBufferStartIndex, graphicsBufferStartIndex, count);

        /// <summary>Reads the buffer; waits for all GPU work asked for before.</summary>
        public void GetData(Array data) => BufferTransfer.Get(Alive("GetData"), TypeName, data, 0, 0, data?.Length ?? 0);

        public void GetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count) =>
            BufferTransfer.Get(Alive("GetData"), TypeName, data, managedBufferStartIndex, computeBufferStartIndex, count);

        /// <summary>Sets the hidden counter of an append, consume or counter buffer.</summary>
        public void SetCounterValue(uint counterValue) => BufferCounters.Set(Alive("SetCounterValue"), counterValue);

        /// <summary>Copies the hidden counter into another buffer.</summary>
        public static void CopyCount(GraphicsBuffer src, GraphicsBuffer dst, int dstOffsetBytes) =>
            BufferCounters.Copy(src?.m_Buffer, dst?.m_Buffer, dstOffsetBytes);

        public static void CopyCount(ComputeBuffer src, GraphicsBuffer dst, int dstOffsetBytes) =>
            BufferCounters.Copy(src?.Native, dst?.m_Buffer, dstOffsetBytes);

        public static void CopyCount(GraphicsBuffer src, ComputeBuffer dst, int dstOffsetBytes) =>
            BufferCounters.Copy(src?.m_Buffer, dst?.Native, dstOffsetBytes);

        public static void CopyCount(ComputeBuffer src, ComputeBuffer dst, int dstOffsetBytes) => BufferCounters.Copy(src?.Native, dst?.Native, dstOffsetBytes);

        static bool IsPure(Target target) => target != 0 && (target & ~(Target.Vertex | Target.Index)) == 0;

        GpuBuffer Alive(string member)
        {
            MainThread.Check("GraphicsBuffer." + member);
            if (!m_Buffer.IsAlive)
                throw new NullReferenceException("The GraphicsBuffer was released and cannot be used any more (" + member + ").");
            return m_Buffer;
        }
    }
}
