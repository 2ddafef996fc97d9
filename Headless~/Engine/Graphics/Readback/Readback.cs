using System;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering
{
    /// <summary>Checks requests and hands them to the queue.</summary>
    static class Readback
    {
        internal static AsyncGPUReadbackRequest Texture(Texture source, int mip, TexelBox? part, GraphicsFormat? asked,
            Action<AsyncGPUReadbackRequest> callback, NativeArray<byte> output)
        {
            MainThread.Check("AsyncGPUReadback.Request");
            if (source == null)
                throw new ArgumentNullException(nameof(source));
            var native = source.Native;
            if (native == null)
                return Failed($"AsyncGPUReadback - RenderTexture '{source.NameForMessages}' is not created.", callback);
            var shape = native.Image.Shape;
            if (mip < 0 || mip >= shape.Mips)
                return Failed($"AsyncGPUReadback - mip index {mip} is outside 0 to {shape.Mips - 1} (texture '{source.NameForMessages}').", callback);
            var (width, height, depth) = shape.Mip(mip);
            depth = Math.Max(depth, shape.Layers);
            var box = part ?? new TexelBox(0, 0, 0, width, height, depth);
            if (box.X < 0 || box.Y < 0 || box.Z < 0 || box.Width <= 0 || box.Height <= 0 || box.Depth <= 0
                || box.X + box.Width > width || box.Y + box.Height > height || box.Z + box.Depth > depth)
                return Failed($"AsyncGPUReadback - the region is not inside the mip level of {width} x {height} x {depth} (texture "
                    + $"'{source.NameForMessages}').", callback);
            var format = asked is { } wanted ? FormatInfo.Of(wanted) : native.Format;
            if (format == null)
                return Failed($"AsyncGPUReadback - the format {asked} is not supported.", callback);
            CheckOutput(output, box.Texels * format.BytesPerTexel);
            return new AsyncGPUReadbackRequest(Gpu.Context.Readbacks.Enqueue(native, mip, box, format, Operation(callback, output)));
        }

        internal static AsyncGPUReadbackRequest Buffer(GpuBuffer source, (int Size, int Offset)? part, Action<AsyncGPUReadbackRequest> callback,
            NativeArray<byte> output)
        {
            MainThread.Check("AsyncGPUReadback.Request");
            if (source == null)
                throw new ArgumentNullException(nameof(source));
            if (!source.IsAlive)
                throw new ObjectDisposedException(source.Name, "AsyncGPUReadback of a released buffer");
            var (size, offset) = part ?? (checked((int)source.Size), 0);
            if (size <= 0 || offset < 0 || (long)offset + size > source.Size)
                return Failed($"AsyncGPUReadback - {size} bytes at {offset} are not inside buffer '{source.Name}' of {source.Size} bytes.", callback);
            CheckOutput(output, size);
            return new AsyncGPUReadbackRequest(Gpu.Context.Readbacks.Enqueue(source, size, offset, Operation(callback, output)));
        }

        internal static NativeArray<byte> Output<T>(NativeArray<T> output) where T : struct
        {
            if (!output.IsCreated)
                throw new ArgumentException("The array is not created", nameof(output));
            if (output.Memory.Allocator is Allocator.Temp or Allocator.TempJob)
                throw new ArgumentException("AsyncGPUReadback cannot use Temp memory as input since the result may only become available at an unspecified "
                    + "point in the future.");
            return output.Reinterpret<byte>(PixelTransfer.SizeOf<T>());
        }

        static ReadbackOperation Operation(Action<AsyncGPUReadbackRequest> callback, NativeArray<byte> output) =>
            new() { Callback = callback, Output = output };

        static void CheckOutput(NativeArray<byte> output, long bytes)
        {
            if (output.IsCreated && output.Length < bytes)
                throw new ArgumentException($"The array has {output.Length} bytes, {bytes} are needed", nameof(output));
        }

        static AsyncGPUReadbackRequest Failed(string message, Action<AsyncGPUReadbackRequest> callback)
        {
            Debug.LogError(message);
            var request = new AsyncGPUReadbackRequest(ReadbackOperation.Failure());
            callback?.Invoke(request);
            return request;
        }
    }
}
