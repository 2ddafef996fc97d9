using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Shaders.Direct3D;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>What is Direct3D's own when kernels go by FXC: packing, strides, messages.</summary>
    public sealed class Direct3DTests() : GpuTest(KernelCompiler.Fxc)
    {
        struct Uneven
        {
            public Vector3 A, B;
            public uint C;
        }

        [Test]
        public void ConstantBuffer_BoundAsAWhole_IsPackedAsDirect3DPacksIt()
        {
            var bytes = new float[32];
            (bytes[4], bytes[8], bytes[12], bytes[13], bytes[14], bytes[27]) = (1, 2, 3, 4, 5, 6);
            var shader = Load("Direct3D");
            shader.SetConstantBuffer("Uneven", Buffer(bytes, GraphicsBuffer.Target.Constant), 0, 128);
            var result = Buffer(4, 16);
            var kernel = shader.FindKernel("Packed");
            shader.SetBuffer(kernel, "_Result", result);
            shader.Dispatch(kernel, 1, 1, 1);
            Assert.That(Read<Vector4>(result)[0], Is.EqualTo(new Vector4(1, 2, 3, 6)));
            Assert.That(Read<Vector4>(result)[1], Is.EqualTo(new Vector4(4, 5, 0, 0)));
        }

        [Test]
        public void StructuredBuffer_OfUnevenStructs_HasNoGaps()
        {
            var rows = Enumerable.Range(0, 5).Select(i => new Uneven { A = new Vector3(i, 1, 2), B = new Vector3(10, 20, 30), C = 7 }).ToArray();
            var offsets = Enumerable.Range(0, 5).Select(i => new Vector3(100 * i, 0, 1000)).ToArray();
            var target = Buffer(5, 28);
            var shader = Load("Direct3D");
            var kernel = shader.FindKernel("Tight");
            shader.SetBuffer(kernel, "_Tight", Buffer(rows));
            shader.SetBuffer(kernel, "_Offsets", Buffer(offsets));
            shader.SetBuffer(kernel, "_TightOut", target);
            shader.Dispatch(kernel, 5, 1, 1);
            var row = Read<Uneven>(target)[3];
            Assert.That((row.A, row.B, row.C), Is.EqualTo((new Vector3(313, 21, 1032), new Vector3(10, 20, 30), 10u)));
        }

        [Test]
        public void StructuredBuffer_OfAnotherStride_LogsAndDoesNothing()
        {
            var shader = Load("Direct3D");
            var kernel = shader.FindKernel("Tight");
            shader.SetBuffer(kernel, "_Tight", Buffer(5, 32));
            shader.SetBuffer(kernel, "_Offsets", Buffer(5, 12));
            shader.SetBuffer(kernel, "_TightOut", Buffer(5, 28));
            LogAssert.Expect(LogType.Error, new Regex("the stride of the shader's struct is 28 bytes, that of buffer 'test' 32"));
            shader.Dispatch(kernel, 1, 1, 1);
        }

        [Test]
        public void Error_InAnInclude_NamesFileLineAndFxcsMessage()
        {
            LogAssert.Expect(LogType.Error, new Regex(
                @"^Shader error in 'Broken', kernel Misspelt:\n/.*Graphics/Fixtures/BrokenInclude\.hlsl\(4\): error X3004: undeclared identifier"));
            Assert.That(Load("Broken").HasKernel("Misspelt"), Is.False);
        }

        [Test]
        public void KernelWithoutEntryPoint_IsNotFound()
        {
            LogAssert.Expect(LogType.Error, new Regex(@"kernel Missing:\n/.*Broken\.compute.*: error X3501: 'Missing': entrypoint not found"));
            Assert.That(Load("Broken").HasKernel("Missing"), Is.False);
        }

        // glslang lets these through.
        [TestCase("RWStructuredBuffer<uint> _R; groupshared uint g[8]; [numthreads(8,1,1)] void Main(uint i : SV_GroupIndex) { for (uint n = 0; n < _R[i]; n++) { "
            + "g[i] += g[7 - i]; GroupMemoryBarrierWithGroupSync(); } _R[i] = g[i]; }", "(2): error X3663: thread sync operation found in varying flow control")]
        [TestCase("RWStructuredBuffer<uint> _R; [numthreads(8,1,1)] void Main(uint i : SV_GroupIndex) { uint x; _R[i] = x; }",
            "(2): error X4000: variable 'x' used without having been completely initialized")]
        [TestCase("RWStructuredBuffer<int> _R; [numthreads(8,1,1)] void Main(int3 i : SV_GroupThreadID) { _R[i.x] = i.x / 3; }",
            "(2): warning X3556: integer divides may be much slower")]
        [TestCase("Buffer<uint> _B; RWStructuredBuffer<uint> _R; [numthreads(8,1,1)] void Main(uint i : SV_GroupIndex) { _R[i] = _B[i]; }",
            "'_B' is a typed buffer; use a StructuredBuffer")]
        [TestCase("Texture2D<float> _T[2]; RWStructuredBuffer<float> _R; [numthreads(1,1,1)] void Main() { "
            + "_R[0] = _T[0].Load(int3(0,0,0)) + _T[1].Load(int3(0,0,0)); }", "is an array of resources")]
        public void Kernel_ThatDirect3DOrTheHostRefuses_IsNotFound(string source, string message)
        {
            LogAssert.Expect(LogType.Error, new Regex(Regex.Escape(message)));
            Assert.That(Compile(source).HasKernel("Main"), Is.False);
        }

        [Test]
        public void SecondLoad_OfTheSameSource_ComesFromTheCache()
        {
            var source = $"RWStructuredBuffer<uint> _R; [numthreads(1,1,1)] void Main() {{ _R[0] = {Environment.TickCount64 % 1000000000}u; }}";
            var (compiled, hits) = (FxcRoute.CompileCount, FxcRoute.CacheHitCount);
            Assert.That(Compile(source).HasKernel("Main"));
            Assert.That((FxcRoute.CompileCount, FxcRoute.CacheHitCount), Is.EqualTo((compiled + 1, hits)));
            Assert.That(Compile(source).HasKernel("Main"));
            Assert.That((FxcRoute.CompileCount, FxcRoute.CacheHitCount), Is.EqualTo((compiled + 1, hits + 1)));
        }

        ComputeShader Compile(string source)
        {
            // The same name each time: it is a part of what is compiled.
            var path = Path.Combine(Path.GetTempPath(), $"anatomycarve-direct3d-test-{Environment.ProcessId}.compute");
            File.WriteAllText(path, "#pragma kernel Main\n" + source + "\n");
            try
            {
                return Own(ComputeShader.Load(path));
            }
            finally
            {
                File.Delete(path);
            }
        }
    }
}
