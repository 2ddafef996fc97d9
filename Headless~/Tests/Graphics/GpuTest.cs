using System;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Shaders;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>What tests on the device share: kernels from the Fixtures folder, and things that are freed when a test ends.</summary>
    public abstract class GpuTest
    {
        readonly Stack<Action> m_Cleanup = new();
        readonly KernelCompiler m_Compiler;

        /// <param name="compiler">Through which compilers the kernels of these tests go.</param>
        protected GpuTest(KernelCompiler compiler = KernelCompiler.Glslang) => m_Compiler = compiler;

        protected static string FixtureFolder => Path.Combine(GraphicsSetUp.Host.PackageRoot, "Headless~", "Tests", "Graphics", "Fixtures");

        [SetUp]
        public void ChooseCompiler() => GpuOptions.KernelRoute = (KernelRoute)m_Compiler;

        [TearDown]
        public void FreeAll()
        {
            GpuOptions.KernelRoute = KernelRoute.Glslang;
            while (m_Cleanup.Count > 0)
                m_Cleanup.Pop()();
        }

        protected ComputeShader Load(string name) => Own(ComputeShader.Load(Path.Combine(FixtureFolder, name + ".compute")));

        protected T Own<T>(T item) where T : UnityEngine.Object
        {
            m_Cleanup.Push(() => UnityEngine.Object.DestroyImmediate(item, true));
            return item;
        }

        protected GraphicsBuffer Buffer(int count, int stride, GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured)
        {
            var buffer = new GraphicsBuffer(target, count, stride) { name = "test" };
            m_Cleanup.Push(buffer.Release);
            return buffer;
        }

        protected GraphicsBuffer Buffer<T>(T[] data, GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured) where T : unmanaged
        {
            var buffer = Buffer(data.Length, System.Runtime.CompilerServices.Unsafe.SizeOf<T>(), target);
            buffer.SetData(data);
            return buffer;
        }

        protected static T[] Read<T>(GraphicsBuffer buffer) where T : unmanaged
        {
            var data = new T[(long)buffer.count * buffer.stride / System.Runtime.CompilerServices.Unsafe.SizeOf<T>()];
            buffer.GetData(data);
            return data;
        }

        protected RenderTexture Volume(int width, int height, int depth, GraphicsFormat format)
        {
            var texture = Own(new RenderTexture(new RenderTextureDescriptor(width, height, format, 0)
            {
                dimension = TextureDimension.Tex3D,
                volumeDepth = depth,
                enableRandomWrite = true,
            }));
            texture.name = "test volume";
            Assert.That(texture.Create(), Is.True);
            return texture;
        }

        /// <summary>A texture's texels, all slices of mip level 0.</summary>
        protected static T[] Read<T>(Texture texture) where T : unmanaged
        {
            var request = AsyncGPUReadback.Request(texture);
            request.WaitForCompletion();
            Assert.That(request.hasError, Is.False);
            var all = new List<T>();
            for (var layer = 0; layer < request.layerCount; layer++)
                all.AddRange(request.GetData<T>(layer).ToArray());
            return all.ToArray();
        }
    }
}
