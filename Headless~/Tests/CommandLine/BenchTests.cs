using System.Linq;
using System.Text.Json.Nodes;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>`carve bench load`: what it counts and what it writes. How long things take is shown by the command, not by tests.</summary>
    sealed class BenchTests
    {
        [Test]
        public void BenchLoad_OfAPair_ReportsBytesTimesAndMemory()
        {
            using var folder = new TestFolder();
            var (volume, labels, report) = (Phantom.WriteVolume(folder), Phantom.WriteLabels(folder), folder["report.json"]);

            var result = Carve.InProcess("bench", "load", volume, "--labels", labels, "--runs", "3", "--threads", "2", "--report", report);

            Assert.That(result.ExitCode, Is.Zero, result.Error);
            Assert.That(result.Output, Does.Contain("24 x 20 x 16 voxels, 4 segments; median of 3 runs").And.Contain("packed, 1 thread").And.Contain("packed, 2 threads"));
            var found = JsonNode.Parse(System.IO.File.ReadAllText(report)).AsObject();
            Assert.That((string)found["volume"], Is.EqualTo(volume));
            Assert.That((string)found["labels"], Is.EqualTo(labels));
            Assert.That(found["dims"].AsArray().Select(size => (int)size), Is.EqualTo(new[] { 24, 20, 16 }));
            Assert.That((long)found["voxelBytes"], Is.EqualTo(24 * 20 * 16 * 4));
            Assert.That((long)found["fileBytes"],
                Is.EqualTo(new System.IO.FileInfo(volume).Length + new System.IO.FileInfo(labels).Length));
            Assert.That((long)found["packedBytes"],
                Is.EqualTo((long)found["packedIntensityBytes"] + (long)found["packedLabelBytes"] + (long)found["packedHeaderBytes"]));
            var loads = found["loads"].AsArray();
            Assert.That(loads.Select(load => (string)load["way"]), Is.EqualTo(new[] { "files", "packed, 1 thread", "packed, 2 threads" }));
            foreach (var load in loads)
            {
                var times = load["ms"].AsArray().Select(time => (double)time).Order().ToArray();
                Assert.That(times, Has.Length.EqualTo(3));
                Assert.That((double)load["medianMs"], Is.EqualTo(times[1]));
                Assert.That((long)load["allocatedBytes"], Is.GreaterThan((long)found["voxelBytes"]));
            }

            Assert.That(folder.FileNames, Is.EqualTo(new[] { "labels.seg.nrrd", "report.json", "volume.nrrd" }));
        }

        [Test]
        public void BenchLoad_OfThePhantom_HasItsSizeAndSegments()
        {
            var result = Carve.InProcess("bench", "load", "--phantom", "40x30x20", "--runs", "1", "--threads", "1");

            Assert.That(result.ExitCode, Is.Zero, result.Error);
            Assert.That(result.Output, Does.Contain("40 x 30 x 20 voxels, 41 segments").And.Not.Contain("threads"));
        }

        [Test]
        public void BenchLoad_OfMissingFile_IsRefusedInOneLine()
        {
            var result = Carve.InProcess("bench", "load", "nowhere.nrrd");

            Assert.That((result.ExitCode, result.ErrorLines.Length), Is.EqualTo((1, 1)), result.Error);
            Assert.That(result.Error, Does.StartWith("carve: nowhere.nrrd: "));
        }
    }
}
