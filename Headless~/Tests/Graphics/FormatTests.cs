using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    [TestFixture(KernelCompiler.Glslang)]
    [TestFixture(KernelCompiler.Fxc)]
    public sealed class FormatTests(KernelCompiler compiler) : GpuTest(compiler)
    {
        const int Width = 5, Height = 3, Depth = 2;

        [TestCase(GraphicsFormat.R8_UNorm, typeof(byte), 255)]
        [TestCase(GraphicsFormat.R8G8_UNorm, typeof(byte), 255)]
        [TestCase(GraphicsFormat.R8G8B8A8_UNorm, typeof(byte), 255)]
        [TestCase(GraphicsFormat.R8_SNorm, typeof(sbyte), 127)]
        [TestCase(GraphicsFormat.R8G8B8A8_SNorm, typeof(sbyte), 127)]
        [TestCase(GraphicsFormat.R16_UNorm, typeof(ushort), 65535)]
        [TestCase(GraphicsFormat.R16G16_UNorm, typeof(ushort), 65535)]
        [TestCase(GraphicsFormat.R32_SFloat, typeof(float), 1)]
        [TestCase(GraphicsFormat.R32G32_SFloat, typeof(float), 1)]
        [TestCase(GraphicsFormat.R32G32B32A32_SFloat, typeof(float), 1)]
        public void RandomWrite_OfEachFloatFormat_StoresRoundedValues(GraphicsFormat format, Type type, double scale)
        {
            var texture = Write("WriteFloat", "_FloatTarget", format);
            Check(texture, type, (x, y, z, c) => Math.Round(new[] { x, y, z, 4 }[c] / 8.0 * scale, MidpointRounding.ToEven), scale == 1);
        }

        [TestCase(GraphicsFormat.R16_SFloat)]
        [TestCase(GraphicsFormat.R16G16_SFloat)]
        [TestCase(GraphicsFormat.R16G16B16A16_SFloat)]
        public void RandomWrite_OfHalfFormats_StoresExactEighths(GraphicsFormat format)
        {
            var texture = Write("WriteFloat", "_FloatTarget", format);
            var data = Read<ushort>(texture);
            var channels = (int)GraphicsFormatUtility.GetComponentCount(format);
            for (var i = 0; i < data.Length; i++)
            {
                var (x, y, z) = Place(i / channels);
                Assert.That(Mathf.HalfToFloat(data[i]), Is.EqualTo(new[] { x, y, z, 4 }[i % channels] / 8f), $"value {i}");
            }
        }

        [TestCase(GraphicsFormat.R8_UInt, typeof(byte))]
        [TestCase(GraphicsFormat.R16_UInt, typeof(ushort))]
        [TestCase(GraphicsFormat.R32_UInt, typeof(uint))]
        [TestCase(GraphicsFormat.R32G32B32A32_UInt, typeof(uint))]
        public void RandomWrite_OfUnsignedFormats_StoresWholeNumbers(GraphicsFormat format, Type type) =>
            Check(Write("WriteUInt", "_UIntTarget", format), type, (x, y, z, c) => new[] { x, y, z, 7 }[c], false);

        [TestCase(GraphicsFormat.R8_SInt, typeof(sbyte))]
        [TestCase(GraphicsFormat.R16_SInt, typeof(short))]
        [TestCase(GraphicsFormat.R32_SInt, typeof(int))]
        public void RandomWrite_OfSignedFormats_StoresWholeNumbers(GraphicsFormat format, Type type) =>
            Check(Write("WriteSInt", "_SIntTarget", format), type, (x, y, z, c) => -new[] { x, y, z, 7 }[c], false);

        [Test]
        public void Format_Denied_IsSupportedForNothing()
        {
            GpuOptions.DeniedFormats.Add(GraphicsFormat.R8_UNorm);
            try
            {
                Assert.That(SystemInfo.IsFormatSupported(GraphicsFormat.R8_UNorm, GraphicsFormatUsage.Sample), Is.False);
                Assert.That(SystemInfo.GetCompatibleFormat(GraphicsFormat.R8_UNorm, GraphicsFormatUsage.LoadStore), Is.EqualTo(GraphicsFormat.R8G8B8A8_UNorm));
                Assert.Throws<ArgumentException>(() => _ = new RenderTexture(new RenderTextureDescriptor(4, 4, GraphicsFormat.R8_UNorm, 0)));
                UnityEngine.TestTools.LogAssert.Expect(LogType.Error,
                    new System.Text.RegularExpressions.Regex("Texture creation failed. 'R8_UNorm' is not supported"));
                Assert.That(new Texture3D(4, 4, 4, GraphicsFormat.R8_UNorm, TextureCreationFlags.None) == null, "a fake null");
            }
            finally
            {
                GpuOptions.DeniedFormats.Clear();
            }
        }

        [Test]
        public void SRGBFormats_AreNeverRandomWrite() =>
            Assert.That(SystemInfo.IsFormatSupported(GraphicsFormat.R8G8B8A8_SRGB, GraphicsFormatUsage.LoadStore), Is.False);

        [Test]
        public void NewRenderTexture_BeforeAnyWrite_HoldsNoNumbers()
        {
            var texture = Volume(3, 3, 3, GraphicsFormat.R32_SFloat);
            Assert.That(Read<float>(texture), Is.All.NaN);
        }

        [Test]
        public void NewBuffer_BeforeAnyWrite_HoldsNoNumbers() => Assert.That(Read<float>(Buffer(10, 4)), Is.All.NaN);

        RenderTexture Write(string kernelName, string target, GraphicsFormat format)
        {
            Assume.That(SystemInfo.IsFormatSupported(format, GraphicsFormatUsage.LoadStore), $"{format} on {SystemInfo.graphicsDeviceName}");
            var shader = Load("Formats");
            var texture = Volume(Width, Height, Depth, format);
            var kernel = shader.FindKernel(kernelName);
            shader.SetInts("_Size", Width, Height, Depth, 0);
            shader.SetTexture(kernel, target, texture);
            shader.Dispatch(kernel, 2, 1, 1);
            return texture;
        }

        static (int X, int Y, int Z) Place(int texel) => (texel % Width, texel / Width % Height, texel / Width / Height);

        static void Check(Texture texture, Type type, Func<int, int, int, int, double> expected, bool isFloat)
        {
            var channels = (int)GraphicsFormatUtility.GetComponentCount(texture.graphicsFormat);
            var bytes = Read<byte>(texture);
            var size = System.Runtime.InteropServices.Marshal.SizeOf(type);
            Assert.That(bytes, Has.Length.EqualTo(Width * Height * Depth * channels * size));
            for (var i = 0; i < bytes.Length / size; i++)
            {
                var (x, y, z) = Place(i / channels);
                var exact = isFloat ? new[] { x, y, z, 4 }[i % channels] / 8.0 : expected(x, y, z, i % channels);
                Assert.That(Value(bytes, i * size, type), Is.EqualTo(exact), $"value {i}");
            }
        }

        static double Value(byte[] bytes, int at, Type type)
        {
            if (type == typeof(byte))
                return bytes[at];
            if (type == typeof(sbyte))
                return (sbyte)bytes[at];
            if (type == typeof(ushort))
                return BitConverter.ToUInt16(bytes, at);
            if (type == typeof(short))
                return BitConverter.ToInt16(bytes, at);
            if (type == typeof(uint))
                return BitConverter.ToUInt32(bytes, at);
            return type == typeof(int) ? BitConverter.ToInt32(bytes, at) : BitConverter.ToSingle(bytes, at);
        }
    }
}
