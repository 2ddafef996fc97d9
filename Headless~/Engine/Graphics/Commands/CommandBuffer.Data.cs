using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering
{
    public partial class CommandBuffer
    {
        /// <summary>Records an upload; the data is copied now.</summary>
        public void SetBufferData(GraphicsBuffer buffer, Array data)
        {
            var copy = (Array)(data ?? throw new ArgumentNullException(nameof(data))).Clone();
            Record(() => buffer.SetData(copy));
        }

        public void SetBufferData(GraphicsBuffer buffer, Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
        {
            var copy = (Array)(data ?? throw new ArgumentNullException(nameof(data))).Clone();
            Record(() => buffer.SetData(copy, managedBufferStartIndex, graphicsBufferStartIndex, count));
        }

        public void SetBufferData<T>(GraphicsBuffer buffer, List<T> data) where T : struct =>
            SetBufferData(buffer, (Array)(data ?? throw new ArgumentNullException(nameof(data))).ToArray());

        public void SetBufferData<T>(GraphicsBuffer buffer, NativeArray<T> data) where T : struct => SetBufferData(buffer, (Array)data.ToArray());

        public void SetBufferData<T>(GraphicsBuffer buffer, NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count)
            where T : struct =>
            SetBufferData(buffer, (Array)data.ToArray(), nativeBufferStartIndex, graphicsBufferStartIndex, count);

        public void RequestAsyncReadback(Texture src, Action<AsyncGPUReadbackRequest> callback) =>
            Record(() => AsyncGPUReadback.Request(src, 0, callback));

        public void RequestAsyncReadback(Texture src, int mipIndex, Action<AsyncGPUReadbackRequest> callback) =>
            Record(() => AsyncGPUReadback.Request(src, mipIndex, callback));

        public void RequestAsyncReadback(Texture src, int mipIndex, GraphicsFormat dstFormat, Action<AsyncGPUReadbackRequest> callback) =>
            Record(() => AsyncGPUReadback.Request(src, mipIndex, dstFormat, callback));

        public void RequestAsyncReadback(Texture src, int mipIndex, int x, int width, int y, int height, int z, int depth,
            Action<AsyncGPUReadbackRequest> callback) =>
            Record(() => AsyncGPUReadback.Request(src, mipIndex, x, width, y, height, z, depth, callback));

        public void RequestAsyncReadback(GraphicsBuffer src, Action<AsyncGPUReadbackRequest> callback) =>
            Record(() => AsyncGPUReadback.Request(src, callback));

        public void RequestAsyncReadback(GraphicsBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest> callback) =>
            Record(() => AsyncGPUReadback.Request(src, size, offset, callback));

        public void RequestAsyncReadback(ComputeBuffer src, Action<AsyncGPUReadbackRequest> callback) =>
            Record(() => AsyncGPUReadback.Request(src, callback));

        /// <summary>Records a wait for all read-backs asked for before.</summary>
        public void WaitAllAsyncReadbackRequests() => Record(AsyncGPUReadback.WaitAllRequests);
    }
}
