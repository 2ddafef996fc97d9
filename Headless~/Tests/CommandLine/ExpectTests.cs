using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    sealed class ExpectTests
    {
        const string Report = """{"segments": [{"index": 0, "name": "skin", "visiblePixels": 100}, {"index": 1, "name": "liver", "visiblePixels": 0}]}""";

        TestFolder folder;

        [SetUp]
        public void MakeFolder() => folder = new TestFolder();

        [TearDown]
        public void DeleteFolder() => folder.Dispose();

        [TestCase("""{"name": "skin", "minimumPixels": 100}""", "1 passed, 0 failed", 0)]
        [TestCase("""{"name": "skin", "minimumPixels": 101}""", "0 passed, 1 failed", 1)]
        [TestCase("""{"name": "skin", "maximumPixels": 99}""", "0 passed, 1 failed", 1)]
        [TestCase("""{"name": "skin", "minimumPixels": 1, "maximumPixels": 100}, {"name": "liver", "maximumPixels": 0}""", "2 passed, 0 failed", 0)]
        [TestCase("""{"name": "spleen", "maximumPixels": 0}""", "0 passed, 1 failed", 1)]
        public void Expect_OfLimits_CountsThoseThatAreKept(string expectations, string summary, int exitCode)
        {
            var result = Carve.InProcess("expect", folder.Write("report.json", Report), folder.Write("expected.json", $"{{\"segments\": [{expectations}]}}"));

            Assert.That(result.ExitCode, Is.EqualTo(exitCode), result.Error);
            Assert.That(result.Output.TrimEnd().Split('\n')[^1], Is.EqualTo(summary));
        }

        [TestCase("{}")]
        [TestCase("[1]")]
        [TestCase("null")]
        [TestCase("no JSON")]
        public void Expect_OfSomethingElse_IsRefused(string text)
        {
            var result = Carve.InProcess("expect", folder.Write("report.json", Report), folder.Write("expected.json", text));

            Assert.That((result.ExitCode, result.ErrorLines.Length), Is.EqualTo((1, 1)), result.Error);
        }
    }
}
