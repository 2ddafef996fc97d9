using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>Spacings, origins and object scales far from the usual: pictures stay finite, and they do not change when everything is scaled.</summary>
    sealed class ScaleTests : StressScene
    {
        static readonly VectorMm TowardsEye = new VectorMm(0.6, -0.7, 0.39).Normalized();

        [Test]
        public void Picture_OfAVolumeAtAnySpacing_IsTheSame([Values(1e-3, 1e-2, 0.1, 10, 100, 1e3)] double spacing)
        {
            PictureData usual = Cut(Grid(20, 18, 16, 1, 1.5, 2)), scaled = Cut(Grid(20, 18, 16, spacing, 1.5 * spacing, 2 * spacing));
            AssertSamePictureAtScale(usual, scaled, spacing);
        }

        [TestCase(1, 1, 100)]
        [TestCase(1, 100, 1)]
        [TestCase(100, 1, 1)]
        [TestCase(0.01, 1, 0.1)]
        [TestCase(1e-3, 0.1, 0.1)]
        [TestCase(1e3, 10, 1e3)]
        public void Volume_WhoseSpacingsDifferAHundredfold_IsShownAsItIs(double spacingI, double spacingJ, double spacingK)
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(16, 17, 18, spacingI, spacingJ, spacingK)));
            CutOpen(renderer, TowardsEye);
            int seen = 0;
            foreach (VectorMm towardsEye in new[] { TowardsEye, new VectorMm(0, -1, 0), new VectorMm(-0.99, 0.1, 0.1).Normalized() })
            {
                PictureRays rays = Look(renderer.Volume.Geometry, towardsEye, 33); // one passes through the centre, however thin the volume looks
                PictureData picture = renderer.Render(rays).Read();
                AssertSane(picture, SegmentCount, towardsEye.ToString());
                seen += CountSeen(picture);
            }
            Assert.That(seen, Is.GreaterThan(0));
            Assert.That(AssertTexturesAreTheFields(renderer, "binary cut"), Is.GreaterThan(0));
        }

        [TestCase(1e6, 0, 0)]
        [TestCase(-1e6, 1e6, -1e6)]
        public void Picture_OfAVolumeFarFromTheOrigin_IsTheSame(double x, double y, double z)
        {
            PictureData near = Cut(Grid(20, 18, 16, 1, 1.5, 2)), far = Cut(Grid(20, 18, 16, 1, 1.5, 2, new PointMm(x, y, z)));
            AssertSamePictureAtScale(near, far, 1);
        }

        [Test]
        public void CameraPicture_OfAnObjectAtAnyScale_IsTheSame([Values(1e-3f, 1e-2f, 0.1f, 10f, 100f, 1e3f)] float scale)
        {
            PictureData usual = FromCamera(1f), scaled = FromCamera(scale);
            AssertSamePictureAtScale(usual, scaled, 1); // depth is in the patient's millimetres
        }

        [Test]
        public void CameraPicture_OfAnObjectScaledUnevenly_IsSane()
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(20, 18, 16, 1, 1.5, 2)));
            renderer.transform.localScale = new Vector3(1e-3f, 1f, 1e3f);
            Camera camera = MakeCamera(new Vector3(0.01f, 0.02f, -60f), Vector3.up);
            camera.farClipPlane = 1e4f;
            AssertSane(renderer.Render(camera, 32, 32).Read(), SegmentCount, "scaled unevenly");
        }

        PictureData Cut(VolumeGeometry geometry)
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(geometry));
            CutOpen(renderer, TowardsEye);
            return renderer.Render(Look(geometry, TowardsEye)).Read();
        }

        PictureData FromCamera(float scale)
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(20, 18, 16, 1, 1.5, 2)));
            renderer.transform.localScale = scale * Vector3.one;
            renderer.Stack.SetActive(scale * new Vector3(0f, 0f, -0.012f), scale * 0.008f);
            Camera camera = MakeCamera(scale * new Vector3(0.01f, 0.02f, -0.06f), Vector3.up);
            camera.nearClipPlane = scale * 0.001f;
            camera.farClipPlane = scale * 10f;
            return renderer.Render(camera, 32, 32).Read();
        }

        static void AssertSamePictureAtScale(PictureData usual, PictureData scaled, double scale)
        {
            AssertSane(usual, SegmentCount, "usual");
            AssertSane(scaled, SegmentCount, "scaled");
            int otherSegment = 0;
            double worstDepth = 0;
            for (int p = 0; p < usual.Segments.Length; p++)
                if (usual.Segments[p] != scaled.Segments[p])
                    otherSegment++;
                else if (usual.Segments[p] != PictureData.NoSegment)
                    worstDepth = Math.Max(worstDepth, Math.Abs(scaled.DepthMm[p] / scale - usual.DepthMm[p]));
            float worst = WorstColor(usual, scaled);
            string figures = FormattableString.Invariant(
                $"colour {255 * worst:g3} codes, depth {worstDepth:g2} mm, {otherSegment} other segments of {CountSeen(usual)} seen");
            TestContext.WriteLine(figures);
            Assert.That(CountSeen(usual), Is.GreaterThan(100));
            Assert.That(worst, Is.LessThanOrEqualTo(Code), figures);
            Assert.That(worstDepth, Is.LessThanOrEqualTo(0.01), figures);
            Assert.That(otherSegment, Is.LessThanOrEqualTo(1), figures);
        }
    }
}
