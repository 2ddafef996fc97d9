using System;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering
{
    /// <summary>Brings textures and buffers back from the GPU without waiting. Results appear at the start of the next frame.</summary>
    public static partial class AsyncGPUReadback
    {
        /// <summary>A mip level with all slices, in its own format.</summary>
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex = 0, Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Texture(src, mipIndex, null, null, callback, default);

        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, GraphicsFormat dstFormat, Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Texture(src, mipIndex, null, dstFormat, callback, default);

        /// <summary>As in Unity, the format is the sRGB one where there is one.</summary>
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, TextureFormat dstFormat, Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Texture(src, mipIndex, null, FormatTables.Of(dstFormat, true), callback, default);

        /// <summary>A part of a mip level. Position and size come in pairs per axis.</summary>
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, int x, int width, int y, int height, int z, int depth,
            Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Texture(src, mipIndex, new TexelBox(x, y, z, width, height, depth), null, callback, default);

        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, int x, int width, int y, int height, int z, int depth,
            GraphicsFormat dstFormat, Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Texture(src, mipIndex, new TexelBox(x, y, z, width, height, depth), dstFormat, callback, default);

        public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Buffer(src?.Native, null, callback, default);

        /// <param name="src">The buffer.</param>
        /// <param name="size">Bytes.</param>
        /// <param name="offset">Bytes.</param>
        /// <param name="callback">Called at the start of the frame in which the data is there.</param>
        public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Buffer(src?.Native, (size, offset), callback, default);

        public static AsyncGPUReadbackRequest Request(ComputeBuffer src, Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Buffer(src?.Native, null, callback, default);

        public static AsyncGPUReadbackRequest Request(ComputeBuffer src, int size, int offset, Action<AsyncGPUReadbackRequest> callback = null) =>
            Readback.Buffer(src?.Native, (size, offset), callback, default);

        /// <summary>Into an array of the caller's, which must not be touched until the request is done.</summary>
        /// <exception cref="ArgumentException">The array is too small or of Temp or TempJob memory.</exception>
        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, Texture src, int mipIndex = 0,
            Action<AsyncGPUReadbackRequest> callback = null) where T : struct =>
            Readback.Texture(src, mipIndex, null, null, callback, Readback.Output(output));

        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, GraphicsBuffer src,
            Action<AsyncGPUReadbackRequest> callback = null) where T : struct =>
            Readback.Buffer(src?.Native, null, callback, Readback.Output(output));

        public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(ref NativeArray<T> output, GraphicsBuffer src, int size, int offset,
            Action<AsyncGPUReadbackRequest> callback = null) where T : struct =>
            Readback.Buffer(src?.Native, (size, offset), callback, Readback.Output(output));

        /// <summary>Waits for everything asked for so far.</summary>
        public static void WaitAllRequests()
        {
            MainThread.Check("WaitAllRequests");
            if (Gpu.IsStarted)
                Gpu.Context.Readbacks.CompleteAll();
        }
    }
}
