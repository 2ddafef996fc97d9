using System;
using System.IO;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Shaders;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    public sealed class CompilerTests : GpuTest
    {
        [Test]
        public void Keywords_SwitchedOn_ChooseTheVariant()
        {
            var shader = Load("Keywords");
            Assert.That(Result(shader), Is.EqualTo(5), "the first of RED and GREEN by default");
            shader.EnableKeyword("DOUBLED");
            Assert.That(Result(shader), Is.EqualTo(10));
            shader.EnableKeyword(new LocalKeyword(shader, "GREEN"));
            Assert.That(Result(shader), Is.EqualTo(110));
            shader.DisableKeyword("DOUBLED");
            Assert.That(shader.IsKeywordEnabled("DOUBLED"), Is.False);
            Assert.That(Result(shader), Is.EqualTo(105));
            Shader.EnableKeyword("EVERYWHERE");
            Assert.That(Result(shader), Is.EqualTo(1105));
            Shader.DisableKeyword("EVERYWHERE");
        }

        [Test]
        public void KeywordSpace_OfShader_NamesAllItDeclares() =>
            Assert.That(Load("Keywords").keywordSpace.keywordNames, Is.EqualTo(new[] { "DOUBLED", "RED", "GREEN", "EVERYWHERE" }));

        [Test]
        public void LocalKeyword_ThatIsNotDeclared_LogsAndStaysInvalid()
        {
            LogAssert.Expect(LogType.Error, new Regex("Local keyword NOSUCH doesn't exist"));
            Assert.That(new LocalKeyword(Load("Keywords"), "NOSUCH").isValid, Is.False);
        }

        [Test]
        public void KernelWithoutEntryPoint_IsNotFound()
        {
            var shader = Load("Broken");
            Assert.That(shader.HasKernel("Fine"));
            LogAssert.Expect(LogType.Error, new Regex("kernel Missing:(.|\n)*Entry point not found"));
            Assert.That(shader.HasKernel("Missing"), Is.False);
            Assert.That(Assert.Throws<ArgumentException>(() => shader.FindKernel("Missing")).Message, Is.EqualTo("Kernel 'Missing' not found."));
            Assert.Throws<ArgumentException>(() => shader.FindKernel("NeverHeardOf"));
        }

        [Test]
        public void ErrorInAnInclude_NamesKernelFileAndLine()
        {
            LogAssert.Expect(LogType.Error, new Regex(@"kernel Misspelt:(.|\n)*BrokenInclude\.hlsl\(4\): .*valu"));
            Assert.That(Load("Broken").HasKernel("Misspelt"), Is.False);
        }

        [TestCase("NineTargets", "9 random-write resources")]
        [TestCase("ReadsHalf", "'_Wide' is read and written")]
        [TestCase("Huge", @"numthreads\(1024,2,1\)")]
        public void KernelBeyondDirect3D11_IsNotSupported(string kernel, string message)
        {
            LogAssert.Expect(LogType.Error, new Regex(message));
            Assert.That(Load("Limits").HasKernel(kernel), Is.False);
        }

        [Test]
        public void SecondLoad_OfTheSameSource_ComesFromTheCache()
        {
            var folder = Path.Combine(Path.GetTempPath(), "anatomycarve-test-" + Guid.NewGuid().ToString("N"));
            var before = GpuOptions.CacheFolder;
            GpuOptions.CacheFolder = folder;
            try
            {
                var (compiled, hits) = (HlslCompiler.CompileCount, HlslCompiler.CacheHitCount);
                Load("Constants").FindKernel("Named");
                Assert.That((HlslCompiler.CompileCount, HlslCompiler.CacheHitCount), Is.EqualTo((compiled + 1, hits)));
                Load("Constants").FindKernel("Named");
                Assert.That((HlslCompiler.CompileCount, HlslCompiler.CacheHitCount), Is.EqualTo((compiled + 1, hits + 1)));
                Assert.That(Directory.GetFiles(Path.Combine(folder, "kernels")), Has.Length.EqualTo(1), "no temporary files stay behind");
            }
            finally
            {
                GpuOptions.CacheFolder = before;
                Directory.Delete(folder, true);
            }
        }

        [Test]
        public void Include_OfPackagePath_IsFoundUnderThePackageRoot()
        {
            var path = Path.Combine(Path.GetTempPath(), "anatomycarve-test-" + Guid.NewGuid().ToString("N") + ".compute");
            File.WriteAllText(path, "\uFEFF#pragma kernel Main\n#include \"Packages/com.anatomycarve.vr/Headless~/Tests/Graphics/Fixtures/Included.hlsl\"\n"
                + "RWStructuredBuffer<uint> _Result;\n[numthreads(1,1,1)] void Main() { _Result[0] = Included(); }\n");
            try
            {
                Assert.That(Result(Own(ComputeShader.Load(path))), Is.EqualTo(5));
            }
            finally
            {
                File.Delete(path);
            }
        }

        uint Result(ComputeShader shader)
        {
            var result = Buffer(1, 4);
            var kernel = shader.FindKernel("Main");
            shader.SetBuffer(kernel, "_Result", result);
            shader.Dispatch(kernel, 1, 1, 1);
            return Read<uint>(result)[0];
        }
    }
}
