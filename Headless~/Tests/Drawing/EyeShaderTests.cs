using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Drawing
{
    /// <summary>
    /// T30: what a camera draws by the eye shader against what the kernel makes of the same rays; for one camera and for both eyes in each way of drawing
    /// them, in both pipelines, both colour spaces and both layouts.
    /// </summary>
    public sealed class EyeShaderTests
    {
        /// <summary>Rays begin at positions that differ by rounding; at hard edges a sample then falls to the other side.</summary>
        const double AllowedShare = 0.002; // edges, and rays on which a hair decides in which step the first visible point is; observed: 0.0011

        const double DepthLimitMm = 1e-3;

        static readonly HostStereo[] Stereo = [HostStereo.Mono, HostStereo.MultiPass, HostStereo.SinglePassInstanced, HostStereo.Multiview];

        static IEnumerable<TestCaseData> Projects() =>
            from scene in new[] { "markers", "veil", "head" }
            from pipeline in new[] { HostPipeline.BuiltIn, HostPipeline.Universal }
            from stereo in Stereo
            select new TestCaseData(scene, new HostOptions { RenderPipeline = pipeline, Stereo = stereo }).SetArgDisplayNames(scene, $"{pipeline}", $"{stereo}");

        static IEnumerable<TestCaseData> GammaProjects() =>
            from scene in new[] { "markers", "veil" }
            from pipeline in new[] { HostPipeline.BuiltIn, HostPipeline.Universal }
            from stereo in new[] { HostStereo.Mono, HostStereo.SinglePassInstanced }
            select new TestCaseData(scene, new HostOptions { RenderPipeline = pipeline, Stereo = stereo, ColorSpace = ColorSpace.Gamma })
                .SetArgDisplayNames(scene, $"{pipeline}", $"{stereo}");

        [TestCaseSource(nameof(Projects))]
        public void Picture_IsTheKernels(string scene, HostOptions project) => AssertTheKernels(scene, project, TextureLayout.Automatic);

        [TestCaseSource(nameof(GammaProjects))]
        public void Picture_OfAGammaProject_IsTheKernelsBlendedAsItBlends(string scene, HostOptions project) =>
            AssertTheKernels(scene, project, TextureLayout.Automatic);

        [Test]
        public void Picture_OfThePortableLayout_IsTheKernels([ValueSource(nameof(Stereo))] HostStereo stereo) =>
            AssertTheKernels("markers", new HostOptions { RenderPipeline = HostPipeline.Universal, Stereo = stereo }, TextureLayout.Portable);

        [Test]
        public void Eyes_SeeDifferentPictures()
        {
            using var drawn = new DrawnScene(new HostOptions { Stereo = HostStereo.SinglePassInstanced });
            Show(drawn, "markers");
            drawn.Draw();
            Color32[] right = drawn.Drawn(1);
            Assert.That(drawn.Drawn(0).Where((color, p) => !color.Equals(right[p])).Count(), Is.GreaterThan(500));
        }

        [Test]
        public void OpaqueThings_HideTheVolumeAndAreHiddenByIt_InBothEyes([ValueSource(nameof(Stereo))] HostStereo stereo,
            [Values(HostPipeline.BuiltIn, HostPipeline.Universal)] HostPipeline pipeline)
        {
            using var drawn = new DrawnScene(new HostOptions { RenderPipeline = pipeline, Stereo = stereo });
            Show(drawn, "markers");
            GameObject wall = GameObject.CreatePrimitive(PrimitiveType.Cube);
            wall.transform.localScale = new Vector3(0.5f, 0.5f, 0.0002f);
            wall.transform.SetPositionAndRotation(drawn.Renderer.transform.position, drawn.Camera.transform.rotation);
            drawn.Draw();
            Color32[][] both = Enumerable.Range(0, drawn.Eyes).Select(drawn.Drawn).ToArray();
            drawn.Renderer.enabled = false;
            drawn.Draw();
            Color32[][] wallAlone = Enumerable.Range(0, drawn.Eyes).Select(drawn.Drawn).ToArray();
            drawn.Renderer.enabled = true;
            wall.SetActive(false);
            drawn.Draw();
            Vector3 forward = drawn.Camera.transform.forward;
            double wallMm = 1000 * Vector3.Dot(drawn.Renderer.transform.position - drawn.Camera.transform.position, forward);
            for (int eye = 0; eye < drawn.Eyes; eye++)
            {
                Color32[] volumeAlone = drawn.Drawn(eye);
                float[] depth = drawn.DrawnDepthMm(eye);
                Color[] kernel = drawn.Kernel(eye).Color;
                int front = 0, back = 0;
                for (int p = 0; p < depth.Length; p++)
                {
                    // The wall's front is at one depth along the view; its distance along a ray is that or more.
                    if (depth[p] < wallMm - 1 && kernel[p].a > 0.998f)
                    {
                        front++;
                        AssertSeen(both[eye][p], volumeAlone[p], $"eye {eye}, pixel {p}: the volume is nearer");
                    }
                    if (float.IsInfinity(depth[p]) || depth[p] > 1.3 * wallMm)
                    {
                        back++;
                        AssertSeen(both[eye][p], wallAlone[eye][p], $"eye {eye}, pixel {p}: the wall is nearer");
                    }
                }
                Assert.That(front, Is.GreaterThan(100), "something is before the wall");
                Assert.That(back, Is.GreaterThan(1000), "the wall is seen");
            }
        }

        /// <summary>The same but for a code: what is behind shines through the last 0.2 %.</summary>
        static void AssertSeen(Color32 actual, Color32 expected, string what) =>
            Assert.That(Math.Max(Math.Abs(actual.r - expected.r), Math.Max(Math.Abs(actual.g - expected.g), Math.Abs(actual.b - expected.b))),
                Is.LessThanOrEqualTo(1), $"{what}: {actual} is not {expected}");

        static void AssertTheKernels(string scene, HostOptions project, TextureLayout layout)
        {
            using var drawn = new DrawnScene(project);
            Show(drawn, scene);
            drawn.Renderer.Layout = layout;
            drawn.Draw();
            for (int eye = 0; eye < drawn.Eyes; eye++)
            {
                PictureData kernel = drawn.Kernel(eye);
                AssertColors(drawn.Drawn(eye), drawn.Blended(kernel), $"{scene}, eye {eye}");
                AssertDepths(drawn.DrawnDepthMm(eye), kernel, $"{scene}, eye {eye}");
            }
            Assert.That(drawn.Errors, Is.Empty);
        }

        /// <summary>Within one code of what should be stored, and within the half that storing rounds away.</summary>
        static void AssertColors(Color32[] actual, Vector3[] expected, string what)
        {
            double largest = 0;
            int different = 0, drawn = 0;
            for (int p = 0; p < actual.Length; p++)
            {
                var (color, wanted) = (actual[p], expected[p]);
                double difference = Math.Max(Math.Abs(color.r - wanted.x), Math.Max(Math.Abs(color.g - wanted.y), Math.Abs(color.b - wanted.z)));
                largest = Math.Max(largest, difference);
                different += difference > 1.5 ? 1 : 0;
                drawn += (expected[p] - expected[0]).magnitude > 2 ? 1 : 0;
            }
            TestContext.Out.WriteLine(FormattableString.Invariant($"{what}: largest difference {largest:0.##} codes, {different} of {drawn} drawn pixels above 1.5"));
            Assert.That(drawn, Is.GreaterThan(500), what);
            Assert.That(different, Is.LessThanOrEqualTo(AllowedShare * actual.Length), what);
        }

        static void AssertDepths(float[] actual, PictureData kernel, string what)
        {
            double largest = 0, sum = 0;
            int different = 0, compared = 0;
            for (int p = 0; p < actual.Length; p++)
            {
                if (kernel.Segments[p] == PictureData.NoSegment)
                    continue;
                double difference = Math.Abs((double)actual[p] - kernel.DepthMm[p]);
                compared++;
                if (difference > DepthLimitMm)
                    different++;
                else
                    (largest, sum) = (Math.Max(largest, difference), sum + difference * difference);
            }
            TestContext.Out.WriteLine(FormattableString.Invariant(
                $"{what}: depth {Math.Sqrt(sum / Math.Max(compared, 1)):0.00000} mm RMS, {different} of {compared} above {DepthLimitMm} mm"));
            Assert.That(compared, Is.GreaterThan(what.StartsWith("veil", StringComparison.Ordinal) ? 0 : 500), what);
            Assert.That(different, Is.LessThanOrEqualTo(AllowedShare * actual.Length), what);
        }

        static void Show(DrawnScene drawn, string scene)
        {
            switch (scene)
            {
                case "markers":
                    drawn.ShowMarkers();
                    break;
                case "veil":
                    drawn.ShowMarkers("0:0.01,500:0.05,1000:0.3");
                    break;
                default:
                    drawn.ShowFiles(DrawnScene.Sample("Colin27.nrrd"), DrawnScene.Sample("Colin27.seg.nrrd"), DrawnScene.Sample("Colin27.vp"),
                        DrawnScene.Sample("demo.carving.json"));
                    drawn.Renderer.Quality = RenderQuality.Best();
                    break;
            }
        }
    }
}
