using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>Atomics, random-write volumes, several textures and constant buffers in a kernel.</summary>
    [TestFixture(KernelCompiler.Glslang)]
    [TestFixture(KernelCompiler.Fxc)]
    public sealed class KernelResourceTests(KernelCompiler compiler) : GpuTest(compiler)
    {
        const int Size = 8;

        [Test]
        public void InterlockedAdd_InGroupAndBuffer_CountsEachThread()
        {
            var values = Enumerable.Range(0, Size * Size * Size).Select(i => (uint)(i * i % 11)).ToArray();
            var counts = Buffer(new uint[8]);
            var shader = Load("Direct3D");
            var kernel = shader.FindKernel("Histogram");
            shader.SetTexture(kernel, "_Values", Numbers(values));
            shader.SetBuffer(kernel, "_Counts", counts);
            shader.Dispatch(kernel, 2, 2, 2);
            Assert.That(Read<uint>(counts), Is.EqualTo(Enumerable.Range(0, 8).Select(n => (uint)values.Count(v => (v & 7) == n))));
        }

        [Test]
        public void RandomWriteVolume_ReadAndWritten_KeepsBoth()
        {
            var values = Enumerable.Range(0, Size * Size * Size).Select(i => (uint)i).ToArray();
            var cells = Volume(Size, Size, Size, GraphicsFormat.R32_UInt);
            UnityEngine.Graphics.CopyTexture(Numbers(values), cells);
            var shader = Load("Direct3D");
            var kernel = shader.FindKernel("Refine");
            shader.SetTexture(kernel, "_Cells", cells);
            shader.SetTexture(kernel, "_Values", Numbers(values));
            shader.Dispatch(kernel, 2, 2, 2);
            Assert.That(Read<uint>(cells).Skip(1), Is.EqualTo(values.Skip(1).Select(v => 2 * v)));
            Assert.That(Read<uint>(cells)[0], Is.EqualTo(1000));
        }

        [Test]
        public void InlineSampler_OfTwoTextures_FiltersBoth()
        {
            var volume = Own(new Texture3D(2, 1, 1, TextureFormat.RFloat, false) { filterMode = FilterMode.Point });
            volume.SetPixelData(new[] { 1f, 4f }, 0);
            volume.Apply(false);
            var picture = Own(new Texture2D(1, 2, TextureFormat.RGFloat, false) { filterMode = FilterMode.Point });
            picture.SetPixelData(new[] { 0f, 10f, 0f, 20f }, 0);
            picture.Apply(false);
            var blend = Volume(1, 1, 1, GraphicsFormat.R32G32_SFloat);
            var shader = Load("Direct3D");
            var kernel = shader.FindKernel("Blend");
            shader.SetTexture(kernel, "_Volume", volume);
            shader.SetTexture(kernel, "_Picture", picture);
            shader.SetTexture(kernel, "_Blend", blend);
            shader.Dispatch(kernel, 1, 1, 1);
            Assert.That(Read<float>(blend), Is.EqualTo(new[] { 2.5f, 15f }).Within(1e-3));
        }

        [Test]
        public void NamedConstants_AfterArraysAndMatrices_ArriveWhereTheShaderReadsThem()
        {
            var shader = Load("Direct3D");
            shader.SetFloats("_Three", 1, 0, 0, 0, 2, 0, 0, 0, 3);
            shader.SetFloats("_AfterThree", 4, 5);
            shader.SetFloats("_Turn", 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3);
            shader.SetFloat("_AfterTurn", 6);
            shader.SetInts("_Words", 7, 8);
            shader.SetInt("_Flag", 1);
            shader.SetVector("_First", new Vector4(9, 10, 11, 12));
            var result = Run(shader, "Packed", 4);
            Assert.That(result[0], Is.EqualTo(new Vector4(1, 2, 3, 6)));
            Assert.That(result[1], Is.EqualTo(new Vector4(4, 5, 7, 8)));
            Assert.That(result[2], Is.EqualTo(new Vector4(1, 20, 300, 1)));
            Assert.That(result[3], Is.EqualTo(new Vector4(9, 10, 11, 12)));
        }

        Vector4[] Run(ComputeShader shader, string name, int rows)
        {
            var result = Buffer(rows, 16);
            var kernel = shader.FindKernel(name);
            shader.SetBuffer(kernel, "_Result", result);
            shader.Dispatch(kernel, 1, 1, 1);
            return Read<Vector4>(result);
        }

        Texture3D Numbers(uint[] values)
        {
            var texture = Own(new Texture3D(Size, Size, Size, GraphicsFormat.R32_UInt, TextureCreationFlags.None) { filterMode = FilterMode.Point });
            texture.SetPixelData(values, 0);
            texture.Apply(false);
            return texture;
        }
    }
}
