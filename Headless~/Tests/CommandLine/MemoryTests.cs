using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>What the command line says of memory.</summary>
    sealed class MemoryTests
    {
        [Test]
        public void Render_OfThePhantom_TakesWhatWasForetold([Values("compact", "portable")] string layout)
        {
            var memory = Render("--phantom", "48x40x37", "--layout", layout)["memory"];

            Assert.That(memory["voxels"].AsArray().Select(side => (int)side), Is.EqualTo(new[] { 48, 40, 37 }));
            Assert.That((string)memory["layout"], Is.EqualTo(layout));
            Assert.That((long)memory["gpuBytes"], Is.LessThanOrEqualTo((long)memory["forecast"]["gpuBytes"]), "at most: the header does not say how many segments");
            Assert.That((long)memory["gpuBytes"], Is.GreaterThan(7 * 48 * 40 * 37));
            Assert.That((long)memory["cpuBytes"], Is.EqualTo((long)memory["forecast"]["cpuBytes"]));
        }

        [Test]
        public void Render_WithASmallBudget_IsCoarserAndSaysSo()
        {
            var report = Render("--phantom", "96x96x64", "--budget", "2");

            Assert.That(report["memory"]["voxels"].AsArray().Select(side => (int)side), Is.EqualTo(new[] { 48, 48, 64 }), "slices are thicker than pixels");
            Assert.That((long)report["memory"]["gpuBytes"], Is.LessThanOrEqualTo(2 << 20));
            Assert.That((string)report["warnings"].AsArray().Single(), Does.Contain("was made coarser, from 96 x 96 x 64 to 48 x 48 x 64 voxels"));
        }

        /// <summary>Minutes and some GiB; asked for by name: <c>Headless~/test --filter Name~LargeCt</c>. Last seen: 7.0158 bytes per voxel.</summary>
        [Test, Explicit("takes minutes and some GiB")]
        public void Render_OfALargeCt_FitsInSevenBytesPerVoxel([Values("compact", "portable")] string layout)
        {
            var report = Render("--phantom", "512x512x600", "--layout", layout, "--budget", "2048");

            Assert.That(report["memory"]["voxels"].AsArray().Select(side => (int)side), Is.EqualTo(new[] { 512, 512, 600 }));
            Assert.That((double)report["memory"]["gpuBytesPerVoxel"], Is.LessThanOrEqualTo(7.1));
            Assert.That(report["segments"].AsArray().Sum(segment => (int)segment["visiblePixels"]), Is.GreaterThan(1000), "something is seen");
        }

        static JsonNode Render(params string[] arguments)
        {
            using var folder = new TestFolder();
            var result = Carve.InProcess(["render", .. arguments, "--size", "64x48", "--output", folder["picture.png"], "--report", folder["report.json"]]);
            Assert.That(result.ExitCode, Is.Zero, result.Error);
            return JsonNode.Parse(File.ReadAllText(folder["report.json"]));
        }
    }
}
