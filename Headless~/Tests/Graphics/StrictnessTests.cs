using System;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>What Unity refuses, and how.</summary>
    [TestFixture(KernelCompiler.Glslang)]
    [TestFixture(KernelCompiler.Fxc)]
    public sealed class StrictnessTests(KernelCompiler compiler) : GpuTest(compiler)
    {
        [Test]
        public void Dispatch_WithUnsetResource_LogsAndDoesNothing()
        {
            var (shader, kernel, values) = Sampler();
            LogAssert.Expect(LogType.Error, new Regex(@"^Compute shader \(Sampling\): Property \(_Volume\) at kernel index \(0\) is not set"));
            ExpectSkipped(shader, kernel, values);
        }

        [Test]
        public void Dispatch_WithDestroyedTexture_LogsAndDoesNothing()
        {
            var (shader, kernel, values) = Sampler();
            var texture = new Texture3D(2, 2, 2, TextureFormat.RFloat, false);
            shader.SetTexture(kernel, "_Volume", texture);
            UnityEngine.Object.DestroyImmediate(texture);
            LogAssert.Expect(LogType.Error, new Regex(@"Property \(_Volume\) at kernel index \(0\) is not set .*destroyed"));
            ExpectSkipped(shader, kernel, values);
        }

        [Test]
        public void Dispatch_WithReleasedRenderTexture_LogsAndDoesNothing()
        {
            var (shader, kernel, values) = Sampler();
            var texture = Volume(2, 2, 2, GraphicsFormat.R32_SFloat);
            texture.Release();
            Assert.That(texture.IsCreated(), Is.False);
            shader.SetTexture(kernel, "_Volume", texture);
            LogAssert.Expect(LogType.Error, new Regex(@"Property \(_Volume\) at kernel index \(0\) is not set .*'test volume' is not created"));
            ExpectSkipped(shader, kernel, values);
        }

        [Test]
        public void Dispatch_WithReleasedBuffer_LogsAndDoesNothing()
        {
            var shader = Load("Buffers");
            var kernel = shader.FindKernel("Shared");
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1, 4) { name = "gone" };
            shader.SetBuffer(kernel, "_Words", buffer);
            buffer.Release();
            LogAssert.Expect(LogType.Error, new Regex(@"Property \(_Words\) at kernel index \(2\) is not set \(buffer 'gone' was released\)"));
            shader.Dispatch(kernel, 1, 1, 1);
        }

        [Test]
        public void Dispatch_WithWrongDimension_LogsAndDoesNothing()
        {
            var (shader, kernel, values) = Sampler();
            shader.SetTexture(kernel, "_Volume", Own(new Texture2D(2, 2, TextureFormat.RFloat, false)));
            LogAssert.Expect(LogType.Error, new Regex(@"mismatching texture dimension \(expected 3, got 2\)"));
            ExpectSkipped(shader, kernel, values);
        }

        [Test]
        public void Dispatch_WithIntegerTextureForFloats_LogsAndDoesNothing()
        {
            var (shader, kernel, values) = Sampler();
            shader.SetTexture(kernel, "_Volume", Own(new Texture3D(2, 2, 2, GraphicsFormat.R8_UInt, TextureCreationFlags.None)));
            LogAssert.Expect(LogType.Error, new Regex("is of Float, but texture .* has the format R8_UInt"));
            ExpectSkipped(shader, kernel, values);
        }

        [Test]
        public void RandomWrite_ToTextureWithoutTheFlag_LogsAndDoesNothing()
        {
            var shader = Load("Sampling");
            var kernel = shader.FindKernel("Count");
            var texture = Own(new RenderTexture(new RenderTextureDescriptor(4, 4, GraphicsFormat.R32_UInt, 0)));
            texture.Create();
            shader.SetTexture(kernel, "_Counts", texture);
            LogAssert.Expect(LogType.Error, new Regex("UAV but the texture wasn't created with the UAV usage flag set!"));
            shader.Dispatch(kernel, 1, 1, 1);
        }

        [Test]
        public void ReadAndWrite_OfMoreThanOneChannel_LogsAndDoesNothing()
        {
            var shader = Load("Sampling");
            var kernel = shader.FindKernel("Count");
            var texture = Own(new RenderTexture(new RenderTextureDescriptor(4, 4, GraphicsFormat.R8_UInt, 0) { enableRandomWrite = true }));
            texture.Create();
            shader.SetTexture(kernel, "_Counts", texture);
            LogAssert.Expect(LogType.Error, new Regex("must have one 32-bit channel, not R8_UInt"));
            shader.Dispatch(kernel, 1, 1, 1);
        }

        [Test]
        public void Dispatch_WithWrongStride_LogsAndDoesNothing()
        {
            var shader = Load("Buffers");
            var kernel = shader.FindKernel("Structs");
            shader.SetBuffer(kernel, "_Rows", Buffer(4, 16));
            shader.SetBuffer(kernel, "_RowsOut", Buffer(4, 32));
            LogAssert.Expect(LogType.Error, new Regex("the stride of the shader's struct is 32 bytes, that of buffer 'test' 16"));
            shader.Dispatch(kernel, 1, 1, 1);
        }

        [TestCase(0, "must be above zero")]
        [TestCase(-1, "must be above zero")]
        [TestCase(65536, "above the maximum allowed limit")]
        public void Dispatch_WithGroupCountsOutside_LogsAndDoesNothing(int groups, string message)
        {
            var shader = Load("Buffers");
            var kernel = shader.FindKernel("Grid");
            var words = Buffer(new uint[] { 7 });
            shader.SetBuffer(kernel, "_Words", words);
            LogAssert.Expect(LogType.Error, new Regex(message));
            shader.Dispatch(kernel, 1, groups, 1);
            Assert.That(Read<uint>(words)[0], Is.EqualTo(7));
        }

        [Test]
        public void Dispatch_WithMostGroups_Runs()
        {
            var shader = Load("Buffers");
            var kernel = shader.FindKernel("Grid");
            var words = Buffer(new uint[] { 0 });
            shader.SetBuffer(kernel, "_Words", words);
            shader.Dispatch(kernel, 65535, 1, 1);
            Assert.That(Read<uint>(words)[0], Is.EqualTo(65535));
        }

        [Test]
        public void KernelIndex_OutOfRange_ThrowsOrLogsAsInUnity()
        {
            var shader = Load("Buffers");
            var texture = Own(new Texture2D(2, 2));
            Assert.Throws<IndexOutOfRangeException>(() => shader.SetTexture(99, "_Words", texture));
            Assert.Throws<IndexOutOfRangeException>(() => shader.GetKernelThreadGroupSizes(99, out _, out _, out _));
            LogAssert.Expect(LogType.Error, "Buffers.compute: Kernel at index (99) is invalid");
            shader.SetBuffer(99, "_Words", Buffer(1, 4));
            LogAssert.Expect(LogType.Error, "Buffers.compute: Kernel at index (99) is invalid");
            shader.Dispatch(99, 1, 1, 1);
        }

        [Test]
        public void NullResources_AreRefused()
        {
            var shader = Load("Sampling");
            Assert.Throws<ArgumentNullException>(() => shader.SetTexture(0, "_Volume", null));
            Assert.Throws<ArgumentNullException>(() => shader.SetBuffer(0, "_Values", (GraphicsBuffer)null));
            Assert.Throws<ArgumentNullException>(() => shader.DispatchIndirect(0, (GraphicsBuffer)null));
        }

        [TestCase(GraphicsBuffer.Target.Structured, 0, 4)]
        [TestCase(GraphicsBuffer.Target.Structured, 4, 0)]
        [TestCase(GraphicsBuffer.Target.Structured, 4, 6)]
        [TestCase(GraphicsBuffer.Target.Structured, 1, 4096)]
        [TestCase(GraphicsBuffer.Target.Index, 4, 8)]
        [TestCase(GraphicsBuffer.Target.Raw, 4, 16)]
        public void GraphicsBuffer_OfImpossibleShape_IsRefused(GraphicsBuffer.Target target, int count, int stride) =>
            Assert.Throws<ArgumentException>(() => _ = new GraphicsBuffer(target, count, stride));

        [Test]
        public void SetData_OutsideTheBuffer_IsRefused()
        {
            var buffer = Buffer(4, 4);
            Assert.Throws<ArgumentOutOfRangeException>(() => buffer.SetData(new int[5]));
            Assert.Throws<ArgumentOutOfRangeException>(() => buffer.SetData(new int[4], 0, 1, 4));
            Assert.Throws<ArgumentOutOfRangeException>(() => buffer.SetData(new int[4], 2, 0, 3));
            Assert.Throws<ArgumentException>(() => buffer.SetData(new bool[4]));
        }

        [Test]
        public void SameTexture_ReadAndWritten_LogsAndDoesNothing()
        {
            var path = System.IO.Path.Combine(System.IO.Path.GetTempPath(), Guid.NewGuid().ToString("N") + ".compute");
            System.IO.File.WriteAllText(path, "#pragma kernel Main\nTexture2D<float> _In;\nRWTexture2D<float> _Out;\n[numthreads(1,1,1)] void Main() { "
                + "_Out[uint2(0,0)] = _In[uint2(0,0)]; }\n");
            try
            {
                var shader = Own(ComputeShader.Load(path));
                var texture = Own(new RenderTexture(new RenderTextureDescriptor(4, 4, GraphicsFormat.R32_SFloat, 0) { enableRandomWrite = true }));
                texture.Create();
                shader.SetTexture(0, "_In", texture);
                shader.SetTexture(0, "_Out", texture);
                LogAssert.Expect(LogType.Error, new Regex("both for reading \\(_In\\) and for writing \\(_Out\\)"));
                shader.Dispatch(0, 1, 1, 1);
            }
            finally
            {
                System.IO.File.Delete(path);
            }
        }

        (ComputeShader, int, GraphicsBuffer) Sampler()
        {
            var shader = Load("Sampling");
            var kernel = shader.FindKernel("Filtered");
            var values = Buffer(new[] { 42f });
            shader.SetBuffer(kernel, "_Points", Buffer(new[] { Vector4.zero }));
            shader.SetBuffer(kernel, "_Values", values);
            return (shader, kernel, values);
        }

        static void ExpectSkipped(ComputeShader shader, int kernel, GraphicsBuffer values)
        {
            shader.Dispatch(kernel, 1, 1, 1);
            Assert.That(Read<float>(values)[0], Is.EqualTo(42));
        }
    }
}
