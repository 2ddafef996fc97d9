using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    [TestFixture(KernelCompiler.Glslang)]
    [TestFixture(KernelCompiler.Fxc)]
    public sealed class DispatchTests(KernelCompiler compiler) : GpuTest(compiler)
    {
        struct Row
        {
            public Vector4 A;
            public uint X, Y, Z, W;
        }

        [Test]
        public void StructuredBuffers_ReadAndWritten_KeepTheirLayout()
        {
            var shader = Load("Buffers");
            var rows = Enumerable.Range(0, 5).Select(i => new Row { A = new Vector4(i, 1, 2, 3), X = 10, Y = 0, Z = 0, W = 20 }).ToArray();
            var source = Buffer(rows);
            var target = Buffer(5, 32);
            var kernel = shader.FindKernel("Structs");
            shader.SetBuffer(kernel, "_Rows", source);
            shader.SetBuffer(kernel, "_RowsOut", target);
            shader.Dispatch(kernel, 5, 1, 1);
            var result = Read<Row>(target);
            Assert.That(result[3].A, Is.EqualTo(new Vector4(6, 2, 4, 6)));
            Assert.That((result[3].X, result[3].Y, result[3].W), Is.EqualTo((13u, 3u, 23u)));
        }

        [Test]
        public void RawBuffers_ReadAndWritten_CountInBytes()
        {
            var shader = Load("Buffers");
            var source = Buffer(new uint[] { 1, 2, 3, 4 }, GraphicsBuffer.Target.Raw);
            var target = Buffer(4, 4, GraphicsBuffer.Target.Raw);
            var kernel = shader.FindKernel("Raw");
            shader.SetBuffer(kernel, "_Bytes", source);
            shader.SetBuffer(kernel, "_BytesOut", target);
            shader.Dispatch(kernel, 4, 1, 1);
            Assert.That(Read<uint>(target), Is.EqualTo(new uint[] { 2, 3, 4, 5 }));
        }

        [Test]
        public void GroupShared_WithBarriers_SumsEachGroup()
        {
            var shader = Load("Buffers");
            var words = Buffer(10, 4);
            var kernel = shader.FindKernel("Shared");
            shader.SetBuffer(kernel, "_Words", words);
            shader.Dispatch(kernel, 10, 1, 1);
            var expected = Enumerable.Range(0, 10).Select(g => (uint)Enumerable.Range(g * 64, 64).Sum());
            Assert.That(Read<uint>(words), Is.EqualTo(expected));
        }

        [Test]
        public void AppendBuffer_Counted_HoldsEachElementOnce()
        {
            var shader = Load("Buffers");
            var found = Buffer(64, 4, GraphicsBuffer.Target.Append);
            var count = Buffer(1, 4);
            found.SetCounterValue(0);
            var kernel = shader.FindKernel("Collect");
            shader.SetBuffer(kernel, "_Found", found);
            shader.Dispatch(kernel, 1, 1, 1);
            GraphicsBuffer.CopyCount(found, count, 0);
            Assert.That(Read<uint>(count)[0], Is.EqualTo(22));
            Assert.That(Read<uint>(found).Take(22).OrderBy(v => v), Is.EqualTo(Enumerable.Range(0, 22).Select(i => (uint)(3 * i))));
        }

        [Test]
        public void DispatchIndirect_FromBuffer_RunsThatManyGroups()
        {
            var shader = Load("Buffers");
            var words = Buffer(new uint[] { 0 });
            var arguments = Buffer(new uint[] { 99, 2, 3, 4 }, GraphicsBuffer.Target.IndirectArguments);
            var kernel = shader.FindKernel("Grid");
            shader.SetBuffer(kernel, "_Words", words);
            shader.DispatchIndirect(kernel, arguments, 4);
            Assert.That(Read<uint>(words)[0], Is.EqualTo(24));
        }

        [Test]
        public void Dispatches_InARow_SeeEachOthersResults()
        {
            var shader = Load("Buffers");
            var a = Buffer(new uint[] { 0, 0 }, GraphicsBuffer.Target.Raw);
            var b = Buffer(2, 4, GraphicsBuffer.Target.Raw);
            var kernel = shader.FindKernel("Raw");
            var submissions = Gpu.Context.Stream.SubmissionCount;
            for (var i = 0; i < 100; i++)
            {
                shader.SetBuffer(kernel, "_Bytes", i % 2 == 0 ? a : b);
                shader.SetBuffer(kernel, "_BytesOut", i % 2 == 0 ? b : a);
                shader.Dispatch(kernel, 2, 1, 1);
            }
            Assert.That(Gpu.Context.Stream.SubmissionCount, Is.EqualTo(submissions), "dispatches gather in one submission");
            Assert.That(Read<uint>(a), Is.EqualTo(new uint[] { 100, 100 }));
        }

        [Test]
        public void ThreadGroupSizes_OfKernel_AreItsNumThreads()
        {
            var shader = Load("Sampling");
            shader.GetKernelThreadGroupSizes(shader.FindKernel("Count"), out var x, out var y, out var z);
            Assert.That((x, y, z), Is.EqualTo((4u, 4u, 1u)));
        }

        [Test]
        public void Copy_OfShader_HasValuesOfItsOwn()
        {
            var shader = Load("Constants");
            shader.SetFloat("_LooseFloat", 1);
            var copy = Own(UnityEngine.Object.Instantiate(shader));
            copy.SetFloat("_LooseFloat", 2);
            Assert.That((Loose(shader), Loose(copy)), Is.EqualTo((1f, 2f)));
        }

        float Loose(ComputeShader shader)
        {
            var result = Buffer(8, 16);
            var kernel = shader.FindKernel("Loose");
            shader.SetBuffer(kernel, "_Result", result);
            shader.Dispatch(kernel, 1, 1, 1);
            return Read<Vector4>(result)[0].x;
        }
    }
}
