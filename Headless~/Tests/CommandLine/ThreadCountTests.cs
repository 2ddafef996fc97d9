using System.IO;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>However many threads a CPU driver takes, a picture is the same. (A driver that is no CPU's ignores the variable.)</summary>
    sealed class ThreadCountTests
    {
        [Test]
        public void Render_WithAnyNumberOfDriverThreads_IsTheSame()
        {
            using var folder = new TestFolder();
            string volume = Phantom.WriteVolume(folder), labels = Phantom.WriteLabels(folder);
            folder.Write("carving.json", """
                {"version": 1, "space": "LPS", "spheres": [
                  {"centerMm": [23, 9, 15], "radiusMm": 12, "clipped": [{"label": 1, "name": "left"}, {"label": 5, "name": "top"}]}]}
                """);
            foreach (var threads in new[] { "1", "2", "8" })
            {
                var result = Carve.Process(
                    ["render", volume, "--labels", labels, "--carving", folder["carving.json"], "--camera", "60,20", "--size", "96x96",
                        "--output", folder[threads + ".png"], "--segments", folder[threads + ".pgm"], "--depth", folder[threads + ".pfm"]],
                    ("LP_NUM_THREADS", threads));
                Assert.That(result.ExitCode, Is.Zero, result.Error);
                foreach (var extension in new[] { ".png", ".pgm", ".pfm" })
                    Assert.That(File.ReadAllBytes(folder[threads + extension]), Is.EqualTo(File.ReadAllBytes(folder["1" + extension])), threads + extension);
            }
        }
    }
}
