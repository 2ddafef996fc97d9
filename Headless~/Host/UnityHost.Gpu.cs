using System;
using UnityEngine;

namespace AnatomyCarve.Headless
{
    public sealed partial class UnityHost
    {
        /// <summary>How often the main thread waited for the GPU since the start: blocking read-backs, <see cref="FinishGpu"/>, full staging memory.</summary>
        public long GpuWaits => Gpu.IsStarted ? Gpu.Context.Stream.WaitCount : 0;

        /// <summary>Hands all work to the GPU and waits until it is done: what a clock around GPU work needs.</summary>
        public void FinishGpu()
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            if (Gpu.IsStarted)
                Gpu.Context.Stream.Wait(Gpu.Context.Stream.CurrentSerial);
        }

        /// <summary>A .compute file that is no asset of the package.</summary>
        /// <exception cref="FormatException">Its pragmas make no sense. Kernels are compiled when they are asked for.</exception>
        public ComputeShader LoadComputeShader(string path)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            return ComputeShader.Load(path);
        }

        /// <summary>What a texture holds, texel by texel as it is stored.</summary>
        /// <exception cref="ArgumentException">The texture has no memory on the GPU.</exception>
        public byte[] ReadTexture(Texture texture)
        {
            ObjectDisposedException.ThrowIf(m_Disposed, this);
            ArgumentNullException.ThrowIfNull(texture);
            var native = texture.Native ?? throw new ArgumentException($"Texture {texture.name} was not created", nameof(texture));
            var (width, height, depth) = native.Image.Shape.Mip(0);
            return Gpu.Context.Readbacks.ReadNow(native, 0, new TexelBox(0, 0, 0, width, height, Math.Max(depth, native.Image.Shape.Layers)));
        }
    }
}
