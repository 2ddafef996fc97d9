using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    [TestFixture(KernelCompiler.Glslang)]
    [TestFixture(KernelCompiler.Fxc)]
    public sealed class SamplingTests(KernelCompiler compiler) : GpuTest(compiler)
    {
        const int Size = 4;

        [Test]
        public void LinearClamp_BetweenTexels_IsTheirMean()
        {
            // The value of texel (x, y, z) is x + 10 y + 100 z: linear, so that the exact answer is known.
            var values = Sample("Filtered", Ramp(), new Vector3(0.5f, 0.5f, 0.5f), new Vector3(0.25f, 0.375f, 0.125f), new Vector3(-1, 2, 0.125f));
            Assert.That(values[0], Is.EqualTo(1.5f + 15 + 150).Within(1e-3));
            Assert.That(values[1], Is.EqualTo(0.5f + 10).Within(1e-3));
            Assert.That(values[2], Is.EqualTo(30).Within(1e-3), "clamped to texel (0, 3, 0)");
        }

        [Test]
        public void PointRepeat_Outside_WrapsAround()
        {
            var values = Sample("Nearest", Ramp(), new Vector3(1.125f, 0.125f, 0.125f), new Vector3(-0.125f, 0.125f, 0.125f));
            Assert.That(values, Is.EqualTo(new[] { 0f, 3f }));
        }

        [Test]
        public void SamplerNamedAfterTexture_FiltersAsTheTextureSays()
        {
            var texture = Ramp();
            texture.wrapMode = TextureWrapMode.Clamp;
            texture.filterMode = FilterMode.Point;
            Assert.That(Sample("Own", texture, new Vector3(0.24f, 0.1f, 0.1f))[0], Is.EqualTo(0));
            texture.filterMode = FilterMode.Bilinear;
            Assert.That(Sample("Own", texture, new Vector3(0.25f, 0.125f, 0.125f))[0], Is.EqualTo(0.5f).Within(1e-3));
        }

        [TestCase(GraphicsFormat.R8_UInt)]
        [TestCase(GraphicsFormat.R16_UInt)]
        public void IntegerVolume_Loaded_GivesItsLabels(GraphicsFormat format)
        {
            var labels = Enumerable.Range(0, 64).Select(i => (ushort)(i * 3)).ToArray();
            var texture = Own(new Texture3D(4, 4, 4, format, TextureCreationFlags.None) { filterMode = FilterMode.Point });
            if (format == GraphicsFormat.R8_UInt)
                texture.SetPixelData(labels.Select(l => (byte)l).ToArray(), 0);
            else
                texture.SetPixelData(labels, 0);
            texture.Apply(false, true);
            var shader = Load("Sampling");
            var kernel = shader.FindKernel("Labels");
            var found = Buffer(64, 4);
            shader.SetTexture(kernel, "_Labels", texture);
            shader.SetBuffer(kernel, "_Found", found);
            shader.Dispatch(kernel, 1, 1, 1);
            Assert.That(Read<uint>(found), Is.EqualTo(labels.Select(l => (uint)l)));
        }

        [Test]
        public void TextureArray_Loaded_GivesEachPicture()
        {
            var array = Own(new Texture2DArray(1, 1, 3, GraphicsFormat.R8G8B8A8_UNorm, TextureCreationFlags.None));
            for (var i = 0; i < 3; i++)
                array.SetPixelData(new byte[] { 0, (byte)(i * 51), 0, 0 }, 0, i);
            array.Apply(false);
            var shader = Load("Sampling");
            var kernel = shader.FindKernel("Slices");
            var values = Buffer(3, 4);
            shader.SetTexture(kernel, "_Array", array);
            shader.SetBuffer(kernel, "_Values", values);
            shader.Dispatch(kernel, 3, 1, 1);
            Assert.That(Read<float>(values), Is.EqualTo(new[] { 0f, 0.2f, 0.4f }).Within(1e-6));
        }

        [Test]
        public void SingleChannelTexture_ReadAndWritten_KeepsBoth()
        {
            var shader = Load("Sampling");
            var counts = Own(new RenderTexture(new RenderTextureDescriptor(4, 4, GraphicsFormat.R32_UInt, 0) { enableRandomWrite = true }));
            counts.Create();
            var zero = Own(new Texture2D(4, 4, GraphicsFormat.R32_UInt, TextureCreationFlags.None));
            zero.SetPixelData(new uint[16], 0);
            zero.Apply(false);
            UnityEngine.Graphics.CopyTexture(zero, counts);
            var kernel = shader.FindKernel("Count");
            shader.SetTexture(kernel, "_Counts", counts);
            shader.Dispatch(kernel, 1, 1, 1);
            Assert.That(Read<uint>(counts).Skip(1), Is.All.EqualTo(1u));
        }

        Texture3D Ramp()
        {
            var data = Enumerable.Range(0, Size * Size * Size).Select(i => (float)(i % Size + i / Size % Size * 10 + i / Size / Size * 100)).ToArray();
            var texture = Own(new Texture3D(Size, Size, Size, TextureFormat.RFloat, false) { name = "ramp" });
            texture.SetPixelData(data, 0);
            texture.Apply(false, true);
            return texture;
        }

        float[] Sample(string name, Texture texture, params Vector3[] points)
        {
            var shader = Load("Sampling");
            var kernel = shader.FindKernel(name);
            var values = Buffer(points.Length, 4);
            shader.SetTexture(kernel, "_Volume", texture);
            shader.SetBuffer(kernel, "_Points", Buffer(points.Select(p => (Vector4)p).ToArray()));
            shader.SetBuffer(kernel, "_Values", values);
            shader.Dispatch(kernel, points.Length, 1, 1);
            return Read<float>(values);
        }
    }
}
