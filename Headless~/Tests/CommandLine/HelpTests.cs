using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    sealed class HelpTests
    {
        [Test]
        public void Help_WithoutCommand_NamesEachCommand()
        {
            var result = Carve.InProcess("--help");

            Assert.That(result.ExitCode, Is.Zero);
            foreach (var command in new[] { "render", "scene", "info", "compare", "expect", "bench" })
                Assert.That(result.Output, Does.Match($@"(?m)^\s+{command}\b"), command);
        }

        [Test]
        public void Help_OfRender_DescribesEachOption()
        {
            var result = Carve.InProcess("render", "--help");

            Assert.That(result.ExitCode, Is.Zero);
            foreach (var option in new[]
            {
                "--labels", "--tf", "--carving", "--camera", "--size", "--quality", "--cut", "--anti-aliasing", "--background", "--output",
                "--depth", "--segments", "--report", "--no-progress", "--drawn", "--drawn-depth", "--pipeline", "--color-space", "--layout", "--stereo", "--phantom",
                "--budget", "--compiler",
            })
                Assert.That(result.Output, Does.Match($@"(?m)^\s+{option}\b.*\s\w+"), option);
            Assert.That(result.Output, Does.Contain("AZIMUTH,ELEVATION"));
            Assert.That(result.Output, Does.Match(@"fast:\s+step\s+1,\s+binary\s+cuts,\s+hardware\s+filter"));
            Assert.That(result.Output, Does.Match(@"balanced:\s+step\s+0\.5,\s+binary\s+cuts").And.Match(@"exactly\s+by\s+Eq\.\s+1"));
            Assert.That(result.Output, Does.Contain("balanced|best|fast").Or.Contain("fast|balanced|best"));
        }

        [TestCase("info", "--json")]
        [TestCase("scene", "--frames")]
        [TestCase("compare", "--json")]
        [TestCase("expect", "REPORT")]
        public void Help_OfCommand_DescribesItsArguments(string command, string argument)
        {
            var result = Carve.InProcess(command, "--help");

            Assert.That(result.ExitCode, Is.Zero);
            Assert.That(result.Output, Does.Contain(argument));
        }
    }
}
