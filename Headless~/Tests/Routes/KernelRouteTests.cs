using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Routes
{
    /// <summary>
    /// The package's kernels by both routes to the device, glslang's and that of Microsoft's compiler, which is Unity's: the same volumes and pictures of
    /// random carvings. What was observed, with seeds 1 to 40, stands beside each limit.
    /// </summary>
    [TestFixtureSource(nameof(Cases))]
    sealed class KernelRouteTests(int seed, CutMode cut, TextureLayout layout)
    {
        const int Seeds = 6;
        const int Kernels = 4;
        const float ColourLimit = 1f / 255f;
        const float DepthLimitMm = 1e-3f;

        /// <summary>Pixels at edges, where a rounding decides what is seen.</summary>
        const double EdgeShare = 0.001;

        CarvingRun glslang, fxc;

        static IEnumerable<TestFixtureData> Cases() =>
            from seed in Enumerable.Range(1, Seeds)
            from cut in new[] { CutMode.Binary, CutMode.Smooth }
            from layout in new[] { TextureLayout.Compact, TextureLayout.Portable }
            select new TestFixtureData(seed, cut, layout);

        [OneTimeSetUp]
        public void CarveByBothRoutes()
        {
            glslang = CarvingRun.Of(KernelCompiler.Glslang, seed, cut, layout);
            fxc = CarvingRun.Of(KernelCompiler.Fxc, seed, cut, layout);
        }

        [Test]
        public void Kernels_GoByTheRouteThatTheHostChose()
        {
            Assert.That(glslang.KernelsByFxc, Is.Zero);
            Assert.That(fxc.KernelsByFxc, Is.GreaterThanOrEqualTo(Kernels));
        }

        [Test]
        public void Opacity_ByBothRoutes_IsBitEqual()
        {
            for (int n = 0; n < glslang.Volumes.Count; n++)
            {
                Assert.That(glslang.Volumes[n][CarvingRun.Opacity].Any(v => v > 0), $"edit {n}: nothing is visible");
                Assert.That(fxc.Volumes[n][CarvingRun.Opacity], Is.EqualTo(glslang.Volumes[n][CarvingRun.Opacity]), $"edit {n}");
            }
        }

        [Test]
        public void OtherVolumes_ByBothRoutes_DifferByOneCodeAtMost()
        {
            int volumes = 0, different = 0, worst = 0;
            for (int n = 0; n < glslang.Volumes.Count; n++)
                foreach (var (name, expected) in glslang.Volumes[n])
                {
                    byte[] actual = fxc.Volumes[n][name];
                    Assert.That(actual, Has.Length.EqualTo(expected.Length), name);
                    volumes++;
                    different += actual.Zip(expected, (a, b) => a != b ? 1 : 0).Sum();
                    worst = Math.Max(worst, actual.Zip(expected, (a, b) => Math.Abs(a - b)).Max());
                }
            TestContext.Out.WriteLine($"{different} bytes of {volumes} volumes differ, by up to {worst}");
            Assert.That(volumes, Is.GreaterThan(glslang.Volumes.Count), "opacity and others after each edit");
            Assert.That(worst, Is.LessThanOrEqualTo(1), "observed: 1, in 8 bytes of 1,440 volumes");
        }

        [Test]
        public void Pictures_ByBothRoutes_AreTheSameButForEdges()
        {
            int pixels = 0, visible = 0, different = 0;
            for (int n = 0; n < glslang.Pictures.Count; n++)
            {
                PictureData a = glslang.Pictures[n], b = fxc.Pictures[n];
                for (int p = 0; p < a.Segments.Length; p++)
                {
                    pixels++;
                    visible += a.Segments[p] != PictureData.NoSegment ? 1 : 0;
                    different += IsSame(a, b, p) ? 0 : 1;
                }
            }
            TestContext.Out.WriteLine($"{different} of {pixels} pixels differ, {visible} show a segment");
            Assert.That(visible, Is.GreaterThan(pixels / 100), "there is nothing to be seen");
            Assert.That(different, Is.LessThanOrEqualTo(EdgeShare * pixels), $"of {pixels} pixels; observed: 0");
        }

        [Test]
        public void SampleCounts_ByBothRoutes_AreTheSameButForEdges()
        {
            // The first picture was made without a count.
            for (int n = 1; n < glslang.Samples.Count; n++)
            {
                Assert.That(glslang.Samples[n], Is.Positive);
                Assert.That(fxc.Samples[n], Is.EqualTo(glslang.Samples[n]).Within(EdgeShare * glslang.Samples[n]), "observed: the same");
            }
        }

        static bool IsSame(PictureData a, PictureData b, int pixel)
        {
            var colour = a.Color[pixel] - b.Color[pixel];
            bool sameColour = new[] { colour.r, colour.g, colour.b, colour.a }.All(c => Math.Abs(c) <= ColourLimit);
            // Where nothing is visible, depth is infinite.
            bool sameDepth = a.DepthMm[pixel].Equals(b.DepthMm[pixel]) || Math.Abs(a.DepthMm[pixel] - b.DepthMm[pixel]) <= DepthLimitMm;
            return sameColour && sameDepth && a.Segments[pixel] == b.Segments[pixel];
        }
    }
}
