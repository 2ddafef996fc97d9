using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using AnatomyCarve.Headless.Cli.Files;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>What a camera draws beside what the kernel renders, from the command line.</summary>
    sealed class DrawnTests
    {
        const int Width = 48, Height = 40;

        TestFolder folder;

        [SetUp]
        public void MakeFolder()
        {
            folder = new TestFolder();
            folder.Write("front.json", """{"space": "LPS", "eyeMm": [43, -181, 45], "targetMm": [23, 19, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""");
        }

        [TearDown]
        public void DeleteFolder() => folder.Dispose();

        [TestCase("built-in", "compact")]
        [TestCase("universal", "portable")]
        public void Drawn_IsWhatTheKernelRenders(string pipeline, string layout)
        {
            Render("--pipeline", pipeline, "--layout", layout);
            AssertAlike(PngFile.ReadRgb(folder["kernel.png"]).Values, PngFile.ReadRgb(folder["drawn.png"]).Values, 2);
            float[] expected = PfmFile.Read(folder["kernel.pfm"]).Values, actual = PfmFile.Read(folder["drawn.pfm"]).Values;
            int compared = 0, different = 0;
            for (int p = 0; p < expected.Length; p++)
                if (float.IsFinite(expected[p]))
                {
                    compared++;
                    different += Math.Abs(expected[p] - actual[p]) > 1e-3f ? 1 : 0;
                }
            Assert.That(compared, Is.GreaterThan(200));
            Assert.That(different, Is.LessThanOrEqualTo(2), "depths further apart than 1e-3 mm");
        }

        [Test]
        public void Drawn_InAGammaProject_ShowsOpaqueMatterTheSame()
        {
            Render("--color-space", "gamma");
            AssertAlike(PngFile.ReadRgb(folder["kernel.png"]).Values, PngFile.ReadRgb(folder["drawn.png"]).Values, 2, 0.15);
        }

        [TestCase("multi-pass")]
        [TestCase("instanced")]
        [TestCase("multiview")]
        public void Drawn_ForAHeadset_HasBothEyesSideBySide(string stereo)
        {
            Render("--stereo", stereo);
            Plane<byte> both = PngFile.ReadRgb(folder["drawn.png"]);
            Assert.That((both.Width / 3, both.Height), Is.EqualTo((2 * Width, Height)));
            Assert.That(PfmFile.Read(folder["drawn.pfm"]).Width, Is.EqualTo(2 * Width));

            // The left eye's picture is that of a camera 32 mm to the left of it.
            double dx = 200 / Math.Sqrt(200 * 200 + 20 * 20), dy = 20 / Math.Sqrt(200 * 200 + 20 * 20);
            string eye = FormattableString.Invariant(
                $$"""{"space": "LPS", "eyeMm": [{{43 - 32 * dx}}, {{-181 - 32 * dy}}, 45], "targetMm": [{{23 - 32 * dx}}, {{19 - 32 * dy}}, 15], "up": [0, 0, 1], "verticalFovDegrees": 20}""");
            folder.Write("front.json", eye);
            Render();
            byte[] left = Enumerable.Range(0, Height).SelectMany(row => both.Values.AsSpan(row * both.Width, 3 * Width).ToArray()).ToArray();
            AssertAlike(PngFile.ReadRgb(folder["kernel.png"]).Values, left, 3);
        }

        void Render(params string[] more)
        {
            CarveResult result = Carve.Process(["render", Phantom.WriteVolume(folder), "--labels", Phantom.WriteLabels(folder), "--tf", "0:0,50:1",
                "--size", $"{Width}x{Height}", "--camera", folder["front.json"], "--output", folder["kernel.png"], "--depth", folder["kernel.pfm"],
                "--drawn", folder["drawn.png"], "--drawn-depth", folder["drawn.pfm"], .. more]);
            Assert.That(result.ExitCode, Is.Zero, result.Error);
            Assert.That(result.Error, Is.Empty);
        }

        /// <summary>Nearly all bytes within some codes of each other.</summary>
        static void AssertAlike(IReadOnlyList<byte> expected, IReadOnlyList<byte> actual, int codes, double share = 0.003)
        {
            Assert.That(actual, Has.Count.EqualTo(expected.Count));
            int different = Enumerable.Range(0, expected.Count).Count(n => Math.Abs(expected[n] - actual[n]) > codes);
            Assert.That(different, Is.LessThanOrEqualTo(share * expected.Count));
            Assert.That(expected.Distinct().Count(), Is.GreaterThan(20), "something is seen");
        }
    }
}
