using System;
using AnatomyCarve.Editor;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Where the preview looks from, what its letters and its scale say.</summary>
    sealed class PreviewTests
    {
        static readonly VolumeGeometry Volume = new VolumeGeometry(100, 50, 80, Affine.FromColumns(
            new VectorMm(1, 0, 0), new VectorMm(0, 3, 0), new VectorMm(0, 0, 1), new PointMm(-50, 20, 7)));

        [Test]
        public void Rays_FromAnySide_ShowTheWholeVolumeAndLittleMore([Values(0f, 37f, 120f, 300f)] float turn, [Values(-90f, 0f, 70f)] float tilt)
        {
            var orbit = new PreviewOrbit();
            orbit.Drag(new Vector2(turn, tilt), 180f);
            PictureRays rays = orbit.Rays(Volume, 300, 200);
            double widest = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                VectorMm offset = Volume.IjkToLps.TransformPoint(new PointMm(
                    (corner & 1) * 100 - 0.5, (corner >> 1 & 1) * 50 - 0.5, (corner >> 2 & 1) * 80 - 0.5)) - rays.Origin;
                double x = offset.Dot(rays.OriginDx) / rays.OriginDx.LengthSquared, y = offset.Dot(rays.OriginDy) / rays.OriginDy.LengthSquared;
                Assert.That(offset.Dot(rays.Direction), Is.GreaterThan(0), "in front of the eye");
                Assert.That(x, Is.InRange(0, 300));
                Assert.That(y, Is.InRange(0, 200));
                widest = Math.Max(widest, Math.Max(Math.Abs(x - 150) / 150, Math.Abs(y - 100) / 100));
            }
            Assert.That(widest, Is.GreaterThan(0.9));
        }

        [Test]
        public void Rays_WhileNothingChanges_AreTheSameObject()
        {
            var orbit = new PreviewOrbit();
            PictureRays rays = orbit.Rays(Volume, 300, 200);
            Assert.That(orbit.Rays(Volume, 300, 200), Is.SameAs(rays));
            orbit.Drag(new Vector2(1f, 0f), 180f);
            _ = orbit.RightLps;
            Assert.That(orbit.Rays(Volume, 300, 200), Is.Not.SameAs(rays));
        }

        [Test]
        public void Drag_ToTheRight_BringsThePatientsRightSideToTheFront()
        {
            var orbit = new PreviewOrbit();
            double before = orbit.Camera.TowardsEyeLps.X;
            orbit.Drag(new Vector2(40f, 0f), 180f);
            Assert.That(orbit.Camera.TowardsEyeLps.X, Is.LessThan(before), "the eye goes to the patient's right, which is at the viewer's left");
        }

        [Test]
        public void Drag_Downwards_LooksFromFurtherAboveButNotPastTheTop()
        {
            var orbit = new PreviewOrbit();
            double before = orbit.Camera.ElevationDegrees;
            orbit.Drag(new Vector2(0f, 10f), 180f);
            Assert.That(orbit.Camera.ElevationDegrees, Is.EqualTo(before + 10).Within(1e-9));
            orbit.Drag(new Vector2(0f, 1000f), 180f);
            Assert.That(orbit.Camera.ElevationDegrees, Is.EqualTo(90));
        }

        [Test]
        public void Scroll_Nearer_ShowsFewerMillimetres()
        {
            var orbit = new PreviewOrbit();
            double before = PreviewOrbit.MmPerPixel(orbit.Rays(Volume, 300, 200));
            orbit.Scroll(-3f);
            double ratio = PreviewOrbit.MmPerPixel(orbit.Rays(Volume, 300, 200)) / before;
            Assert.That(ratio, Is.EqualTo(1 / orbit.Zoom).Within(1e-9));
            Assert.That(ratio, Is.LessThan(1));
            orbit.Scroll(-1000f);
            Assert.That(orbit.Zoom, Is.EqualTo(PreviewOrbit.LargestZoom));
            orbit.Reset();
            Assert.That(orbit.Zoom, Is.EqualTo(1));
        }

        [TestCase(1, 0, 0, "L")]
        [TestCase(-2, 0, 0, "R")]
        [TestCase(0, 5, 0.5, "P")]
        [TestCase(0, -1, 0, "A")]
        [TestCase(0, 0, 1, "S")]
        [TestCase(0, 0, -1, "I")]
        [TestCase(1, -0.9, 0, "LA")]
        [TestCase(-0.9, 1, 0.1, "PR")]
        [TestCase(1, 1.1, -1.2, "IPL")]
        [TestCase(0, 0, 0, "")]
        public void Letters_OfADirection_AreThoseOfTheAxesItLeansTo(double x, double y, double z, string expected) =>
            Assert.That(OrientationLetters.Of(new VectorMm(x, y, z)), Is.EqualTo(expected));

        [Test]
        public void Letters_OfAFrontView_ShowThePatientsLeftAtTheRight()
        {
            var camera = new OrbitCamera(0, 0);
            Assert.That(OrientationLetters.Of(camera.UpLps.Cross(camera.TowardsEyeLps)), Is.EqualTo("L"));
            Assert.That(OrientationLetters.Of(camera.UpLps), Is.EqualTo("S"));
        }

        [TestCase(1, 100, 100, 100f, "100 mm")]
        [TestCase(1, 99, 50, 50f, "50 mm")]
        [TestCase(0.5, 99, 20, 40f, "20 mm")]
        [TestCase(0.001, 30, 0.02, 20f, "0.02 mm")]
        [TestCase(10, 750, 5000, 500f, "5000 mm")]
        public void Scale_OfAPicture_IsTheLongestRoundLength(double mmPerPixel, double room, double length, float pixels, string text)
        {
            var bar = new ScaleBar(mmPerPixel, room);
            Assert.That(bar.LengthMm, Is.EqualTo(length).Within(1e-9));
            Assert.That(bar.Pixels, Is.EqualTo(pixels).Within(1e-3f));
            Assert.That(bar.Text, Is.EqualTo(text));
        }

        [TestCase(0, 100)]
        [TestCase(1, double.NaN)]
        public void Scale_WithoutRoom_IsRefused(double mmPerPixel, double room) => Assert.That(() => new ScaleBar(mmPerPixel, room), Throws.ArgumentException);
    }
}
