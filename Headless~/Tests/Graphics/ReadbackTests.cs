using System;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    public sealed class ReadbackTests : GpuTest
    {
        [Test]
        public void Request_IsDoneAtTheStartOfTheNextFrame_AndGoneInTheOneAfter()
        {
            var buffer = Buffer(new uint[] { 1, 2, 3 });
            var called = 0;
            var request = AsyncGPUReadback.Request(buffer, r => called += r.GetData<uint>().Length);
            Assert.That(request.done, Is.False);
            Assert.Throws<InvalidOperationException>(() => request.GetData<uint>());
            GraphicsSetUp.Host.Step();
            Assert.That((request.done, request.hasError, called), Is.EqualTo((true, false, 3)));
            var data = request.GetData<uint>();
            Assert.That(data.ToArray(), Is.EqualTo(new uint[] { 1, 2, 3 }));
            GraphicsSetUp.Host.Step();
            Assert.That((request.done, request.hasError, called), Is.EqualTo((true, true, 3)));
            Assert.Throws<InvalidOperationException>(() => request.GetData<uint>());
            Assert.That(data.IsCreated, Is.False, "a view that is over");
        }

        [Test]
        public void Request_SeesWorkBefore_AndNotAfter()
        {
            var buffer = Buffer(new uint[] { 1 });
            var request = AsyncGPUReadback.Request(buffer);
            buffer.SetData(new uint[] { 2 });
            request.WaitForCompletion();
            Assert.That(request.GetData<uint>()[0], Is.EqualTo(1));
            Assert.That(Read<uint>(buffer)[0], Is.EqualTo(2));
        }

        [Test]
        public void VolumeRequest_HasALayerPerSlice()
        {
            var texture = Volume2();
            var request = AsyncGPUReadback.Request(texture);
            request.WaitForCompletion();
            Assert.That((request.layerCount, request.layerDataSize, request.width, request.height), Is.EqualTo((4, 6, 3, 2)));
            Assert.That(request.GetData<byte>(2).ToArray(), Is.EqualTo(new byte[] { 12, 13, 14, 15, 16, 17 }));
            Assert.Throws<ArgumentException>(() => request.GetData<byte>(4));
        }

        [Test]
        public void Region_GivenAsPairsPerAxis_IsCutOut()
        {
            var request = AsyncGPUReadback.Request(Volume2(), 0, 1, 2, 0, 1, 2, 2);
            request.WaitForCompletion();
            Assert.That(request.layerCount, Is.EqualTo(2));
            Assert.That(request.GetData<byte>(0).ToArray(), Is.EqualTo(new byte[] { 13, 14 }));
            Assert.That(request.GetData<byte>(1).ToArray(), Is.EqualTo(new byte[] { 19, 20 }));
        }

        [Test]
        public void OtherFormat_IsConverted()
        {
            var texture = Own(new Texture2D(1, 1, GraphicsFormat.R8_UNorm, TextureCreationFlags.None));
            texture.SetPixelData(new byte[] { 51 }, 0);
            texture.Apply(false);
            var request = AsyncGPUReadback.Request(texture, 0, GraphicsFormat.R32_SFloat);
            request.WaitForCompletion();
            Assert.That(request.GetData<float>()[0], Is.EqualTo(0.2f));
        }

        [Test]
        public void BufferRequest_WithSizeAndOffset_CountsBytes()
        {
            var request = AsyncGPUReadback.Request(Buffer(new uint[] { 1, 2, 3, 4 }), 8, 4);
            request.WaitForCompletion();
            Assert.That(request.GetData<uint>().ToArray(), Is.EqualTo(new uint[] { 2, 3 }));
        }

        [Test]
        public void IntoNativeArray_FillsIt()
        {
            var output = new NativeArray<uint>(3, Allocator.Persistent);
            try
            {
                AsyncGPUReadback.RequestIntoNativeArray(ref output, Buffer(new uint[] { 7, 8, 9 }));
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(output.ToArray(), Is.EqualTo(new uint[] { 7, 8, 9 }));
            }
            finally
            {
                output.Dispose();
            }
        }

        [Test]
        public void SourceDestroyedBeforeTheResult_DoesNoHarm()
        {
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 2, 4);
            buffer.SetData(new uint[] { 5, 6 });
            var request = AsyncGPUReadback.Request(buffer);
            buffer.Release();
            GraphicsSetUp.Host.Step();
            Assert.That(request.GetData<uint>().ToArray(), Is.EqualTo(new uint[] { 5, 6 }));
        }

        [Test]
        public void CommandBufferRequest_RunsItsCallback()
        {
            var result = 0u;
            using var commands = new CommandBuffer { name = "read back" };
            commands.RequestAsyncReadback(Buffer(new uint[] { 9 }), r => result = r.GetData<uint>()[0]);
            Assert.That(result, Is.Zero);
            UnityEngine.Graphics.ExecuteCommandBuffer(commands);
            GraphicsSetUp.Host.Step();
            Assert.That(result, Is.EqualTo(9));
        }

        Texture3D Volume2()
        {
            var texture = Own(new Texture3D(3, 2, 4, TextureFormat.R8, false));
            texture.SetPixelData(Enumerable.Range(0, 24).Select(i => (byte)i).ToArray(), 0);
            texture.Apply(false, true);
            return texture;
        }
    }
}
