using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.TestTools;
using UnityEngine.Vulkan;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    public sealed class DeviceTests : GpuTest
    {
        [Test]
        public void ValidationLayer_FindingAMistake_BecomesAnErrorInTheLog()
        {
            var messages = Gpu.Context.Messages;
            var before = messages.Count;
            LogAssert.Expect(LogType.Error, new Regex("^Vulkan validation: .*vkCreateBuffer"));
            using (new VulkanBuffer(Gpu.Context.Device, 16, usage: 0, BufferPlace.Readback))
            {
            }
            messages.Drain();
            GraphicsSetUp.ExpectedMessages += messages.Count - before;
        }

        [Test]
        public void UnknownDevice_AskedFor_NamesThoseThatExist() =>
            Assert.That(Assert.Throws<VulkanException>(() => PhysicalDevices.Choose(Gpu.Context.Instance, "no such device")).Message,
                Does.Contain("ANATOMYCARVE_GPU").And.Contain(SystemInfo.graphicsDeviceName));

        [Test]
        public void Counters_FollowCreationAndRelease()
        {
            var (textures, buffers, bytes) = (Gpu.Context.TextureCount, Gpu.Context.BufferCount, Gpu.Context.Bytes);
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 100, 16);
            var texture = Volume(8, 8, 8, GraphicsFormat.R32_SFloat);
            Assert.That((Gpu.Context.TextureCount, Gpu.Context.BufferCount), Is.EqualTo((textures + 1, buffers + 1)));
            Assert.That(Gpu.Context.Bytes, Is.GreaterThanOrEqualTo(bytes + 1600 + 2048));
            buffer.Release();
            texture.Release();
            Assert.That((Gpu.Context.TextureCount, Gpu.Context.BufferCount, Gpu.Context.Bytes), Is.EqualTo((textures, buffers, bytes)));
        }

        [Test]
        public void DestroyedWhileInUse_LivesUntilTheDeviceIsDone()
        {
            var shader = Load("Buffers");
            var kernel = shader.FindKernel("Raw");
            var target = Buffer(4, 4, GraphicsBuffer.Target.Raw);
            var source = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 4, 4);
            source.SetData(new uint[] { 1, 2, 3, 4 });
            shader.SetBuffer(kernel, "_Bytes", source);
            shader.SetBuffer(kernel, "_BytesOut", target);
            shader.Dispatch(kernel, 4, 1, 1);
            source.Release();
            Assert.That(Read<uint>(target), Is.EqualTo(new uint[] { 2, 3, 4, 5 }));
        }

        [Test]
        public void Limits_AreAtMostUnitys()
        {
            Assert.That(SystemInfo.maxTexture3DSize, Is.LessThanOrEqualTo(2048));
            Assert.That(SystemInfo.supportedRandomWriteTargetCount, Is.EqualTo(8));
            Assert.That(SystemInfo.maxComputeWorkGroupSizeZ, Is.LessThanOrEqualTo(64));
            Assert.That(SystemInfo.graphicsDeviceType, Is.EqualTo(UnityEngine.Rendering.GraphicsDeviceType.Vulkan));
        }

        [TestCase("sampler_LinearClamp", FilterMode.Bilinear, TextureWrapMode.Clamp, TextureWrapMode.Clamp)]
        [TestCase("MyPointRepeatSampler", FilterMode.Point, TextureWrapMode.Repeat, TextureWrapMode.Repeat)]
        [TestCase("sampler_trilinear_mirror", FilterMode.Trilinear, TextureWrapMode.Mirror, TextureWrapMode.Mirror)]
        [TestCase("sampler_linear_clampU_repeatV", FilterMode.Bilinear, TextureWrapMode.Clamp, TextureWrapMode.Repeat)]
        public void InlineSampler_IsReadFromItsName(string name, FilterMode filter, TextureWrapMode u, TextureWrapMode v)
        {
            Assert.That(InlineSampler.TryParse(name, out var state));
            Assert.That((state.Filter, state.U, state.V), Is.EqualTo((filter, u, v)));
        }

        [TestCase("sampler_MyTexture")]
        [TestCase("sampler_Linear")]
        [TestCase("samplerClamp")]
        public void OtherSamplerNames_AreNotInline(string name) => Assert.That(InlineSampler.TryParse(name, out _), Is.False);
    }
}
