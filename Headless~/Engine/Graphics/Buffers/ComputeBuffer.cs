using System;
using System.Collections.Generic;
using Unity.Collections;

namespace UnityEngine
{
    /// <summary>A buffer on the GPU, in the older class. Release it: nobody else does.</summary>
    public sealed class ComputeBuffer : IDisposable
    {
        const string TypeName = "ComputeBuffer";
        const int MaxStride = 2048;

        readonly GpuBuffer m_Buffer;

        /// <exception cref="ArgumentException">Count, stride or size is out of range.</exception>
        public ComputeBuffer(int count, int stride) : this(count, stride, ComputeBufferType.Default)
        {
        }

        /// <exception cref="ArgumentException">Count, stride or size is out of range.</exception>
        public ComputeBuffer(int count, int stride, ComputeBufferType type)
        {
            MainThread.Check("ComputeBuffer constructor");
            if (count <= 0)
                throw new ArgumentException("Attempting to create a zero length compute buffer", nameof(count));
            if (stride <= 0)
                throw new ArgumentException("Attempting to create a compute buffer with a negative or null stride", nameof(stride));
            if (stride % 4 != 0 || stride > MaxStride)
                throw new ArgumentException($"Invalid stride {stride} for Compute Buffer - must be a multiple of 4 and at most {MaxStride}", nameof(stride));
            if ((long)count * stride > SystemInfo.maxGraphicsBufferSize)
                throw new ArgumentException($"The total size of the compute buffer ({(long)count * stride} bytes) exceeds the maximum buffer size. Maximum "
                    + $"supported buffer size: {SystemInfo.maxGraphicsBufferSize} bytes.");
            m_Buffer = new GpuBuffer(TypeName, count, stride, TargetOf(type));
        }

        ~ComputeBuffer()
        {
            if (m_Buffer is { IsAlive: true })
                Debug.LogWarning("GarbageCollector disposing of ComputeBuffer. Please use ComputeBuffer.Release() or .Dispose() to manually release the "
                    + "buffer.");
        }

        public int count => Alive("count").Count;

        /// <summary>Bytes per element.</summary>
        public int stride => Alive("stride").Stride;

        public string name
        {
            set => Alive("name").Name = value;
        }

        internal GpuBuffer Native => m_Buffer;

        public bool IsValid() => m_Buffer.IsAlive;

        public void Dispose()
        {
            MainThread.Check("ComputeBuffer.Dispose");
            m_Buffer.Release();
            GC.SuppressFinalize(this);
        }

        public void Release() => Dispose();

        /// <exception cref="ArgumentException">The elements are not blittable.</exception>
        public void SetData(Array data) => BufferTransfer.Set(Alive("SetData"), TypeName, data, 0, 0, data?.Length ?? 0);

        public void SetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count) =>
            BufferTransfer.Set(Alive("SetData"), TypeName, data, managedBufferStartIndex, computeBufferStartIndex, count);

        public void SetData<T>(List<T> data) where T : struct => BufferTransfer.Set(Alive("SetData"), TypeName, data, 0, 0, data?.Count ?? 0);

        public void SetData<T>(List<T> data, int managedBufferStartIndex, int computeBufferStartIndex, int count) where T : struct =>
            BufferTransfer.Set(Alive("SetData"), TypeName, data, managedBufferStartIndex, computeBufferStartIndex, count);

        public void SetData<T>(NativeArray<T> data) where T : struct => BufferTransfer.Set(Alive("SetData"), TypeName, data, 0, 0, data.Length);

        public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int computeBufferStartIndex, int count) where T : struct =>
            BufferTransfer.Set(Alive("SetData"), TypeName, data, nativeBufferStartIndex, computeBufferStartIndex, count);

        /// <summary>Reads the buffer; waits for all GPU work asked for before.</summary>
        public void GetData(Array data) => BufferTransfer.Get(Alive("GetData"), TypeName, data, 0, 0, data?.Length ?? 0);

        public void GetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count) =>
            BufferTransfer.Get(Alive("GetData"), TypeName, data, managedBufferStartIndex, computeBufferStartIndex, count);

        public void SetCounterValue(uint counterValue) => BufferCounters.Set(Alive("SetCounterValue"), counterValue);

        public static void CopyCount(ComputeBuffer src, ComputeBuffer dst, int dstOffsetBytes) =>
            BufferCounters.Copy(src?.m_Buffer, dst?.m_Buffer, dstOffsetBytes);

        static GraphicsBuffer.Target TargetOf(ComputeBufferType type)
        {
            var target = (GraphicsBuffer.Target)0;
            if ((type & ComputeBufferType.Raw) != 0)
                target |= GraphicsBuffer.Target.Raw;
            if ((type & ComputeBufferType.Append) != 0)
                target |= GraphicsBuffer.Target.Append;
            if ((type & ComputeBufferType.Counter) != 0)
                target |= GraphicsBuffer.Target.Counter;
            if ((type & ComputeBufferType.Constant) != 0)
                target |= GraphicsBuffer.Target.Constant;
            if ((type & ComputeBufferType.IndirectArguments) != 0)
                target |= GraphicsBuffer.Target.IndirectArguments;
            const ComputeBufferType other = ComputeBufferType.Raw | ComputeBufferType.Constant | ComputeBufferType.IndirectArguments;
            return (type & other) == 0 || (type & ComputeBufferType.Structured) != 0 ? target | GraphicsBuffer.Target.Structured : target;
        }

        GpuBuffer Alive(string member)
        {
            MainThread.Check("ComputeBuffer." + member);
            if (!m_Buffer.IsAlive)
                throw new NullReferenceException("The ComputeBuffer was released and cannot be used any more (" + member + ").");
            return m_Buffer;
        }
    }
}
