using System;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Files;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>carve render --compiler.</summary>
    sealed class CompilerOptionTests
    {
        TestFolder folder;

        [SetUp]
        public void MakeFolder() => folder = new TestFolder();

        [TearDown]
        public void DeleteFolder() => folder.Dispose();

        [Test]
        public void Render_ByEitherCompiler_GivesTheSamePicture()
        {
            byte[] Picture(string compiler)
            {
                CarveResult result = Render(compiler);
                Assert.That(result.ExitCode, Is.Zero, result.Error);
                return PngFile.ReadRgb(folder[compiler + ".png"]).Values;
            }

            byte[] glslang = Picture("glslang"), fxc = Picture("fxc");
            Assert.That(glslang.Distinct().Count(), Is.GreaterThan(10));
            Assert.That(glslang.Zip(fxc, (a, b) => Math.Abs(a - b)).Max(), Is.LessThanOrEqualTo(1), "observed: 0");
        }

        [Test]
        public void Report_NamesTheCompiler()
        {
            Render("fxc", ["--report", folder["report.json"]]);
            JsonNode report = JsonNode.Parse(File.ReadAllText(folder["report.json"]));
            Assert.That((string)report["device"]["kernelCompiler"], Is.EqualTo("fxc"));
        }

        [Test]
        public void Render_ByFxcThatIsNotSetUp_SaysWhatSetsItUp()
        {
            CarveResult result = Render("fxc", [], ("XDG_CACHE_HOME", folder["empty"]));
            Assert.That(result.ExitCode, Is.EqualTo(1));
            Assert.That(result.ErrorLines, Has.Length.EqualTo(1));
            Assert.That(result.Error, Does.Contain("d3dcompiler_47.dll was not found").And.Contain("Headless~/check-d3d sets it up"));
            Assert.That(File.Exists(folder["fxc.png"]), Is.False);
        }

        CarveResult Render(string compiler, string[] more = null, params (string Name, string Value)[] environment) => Carve.Process(
            ["render", Phantom.WriteVolume(folder), "--labels", Phantom.WriteLabels(folder), "--tf", "0:0,50:1", "--size", "48x40", "--compiler", compiler,
                "--output", folder[compiler + ".png"], .. more ?? []], environment);
    }
}
