using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Picking
{
    public sealed class PictureRaysTests
    {
        static readonly VectorMm Superior = new VectorMm(0, 0, 1);

        [Test]
        public void Perspective_LookingAtTheFace_ShowsThePatientsRightOnTheLeftAndTheHeadOnTop()
        {
            PictureRays rays = PictureRays.Perspective(new PointMm(0, -500, 0), default, Superior, 40, 100, 80);

            Assert.That(rays.RayThroughPixel(0, 40).Direction.X, Is.LessThan(-0.1), "LPS: negative x is the patient's right");
            Assert.That(rays.RayThroughPixel(99, 40).Direction.X, Is.GreaterThan(0.1));
            Assert.That(rays.RayThroughPixel(50, 0).Direction.Z, Is.LessThan(-0.1), "row 0 is the bottom row");
            Assert.That(rays.RayThroughPixel(50, 79).Direction.Z, Is.GreaterThan(0.1));
        }

        [Test]
        public void Perspective_MiddleAndEdges_SpanTheFieldOfView()
        {
            var eye = new PointMm(10, 20, 30);
            var target = new PointMm(-40, 80, 10);
            PictureRays rays = PictureRays.Perspective(eye, target, Superior, 50, 640, 480);
            VectorMm forward = (target - eye).Normalized();

            Assert.That((rays.Ray(320, 240).Direction - forward).Length, Is.EqualTo(0).Within(1e-12));
            Assert.That(AngleDegrees(rays.Ray(320, 0).Direction, rays.Ray(320, 480).Direction), Is.EqualTo(50).Within(1e-9));
            double perPixel = rays.DirectionDx.Length;
            Assert.That(rays.DirectionDy.Length, Is.EqualTo(perPixel).Within(1e-15), "pixels are square");
            Assert.That((rays.Direction + 320 * rays.DirectionDx + 240 * rays.DirectionDy).Length, Is.EqualTo(1).Within(1e-12), "t is the depth in mm");
            Assert.That(rays.RayThroughPixel(3, 4).Direction, Is.EqualTo(rays.Ray(3.5, 4.5).Direction));
            Assert.That(rays.Ray(17, 400).Origin, Is.EqualTo(eye));
        }

        [Test]
        public void Orthographic_AnyPixel_LooksForwardFromThePlaneOfTheEye()
        {
            var eye = new PointMm(0, -100, 0);
            PictureRays rays = PictureRays.Orthographic(eye, default, Superior, 60, 40, 30);

            RayMm corner = rays.Ray(0, 0);

            Assert.That(corner.Direction, Is.EqualTo(new VectorMm(0, 1, 0)));
            Assert.That(corner.Origin.DistanceTo(new PointMm(-40, -100, -30)), Is.EqualTo(0).Within(1e-12));
            Assert.That(rays.Ray(20, 15).Origin.DistanceTo(eye), Is.EqualTo(0).Within(1e-12));
        }

        [Test]
        public void Perspective_OnePixel_IsTheViewsAxis()
        {
            PictureRays rays = PictureRays.Perspective(default, new PointMm(0, 0, -3), new VectorMm(0, 5, 0), 120, 1, 1);
            Assert.That((rays.RayThroughPixel(0, 0).Direction - new VectorMm(0, 0, -1)).Length, Is.EqualTo(0).Within(1e-12));
        }

        [Test]
        public void Perspective_BadArguments_Throw()
        {
            var target = new PointMm(0, 10, 0);
            Assert.That(() => PictureRays.Perspective(default, default, Superior, 40, 10, 10), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Perspective(default, target, new VectorMm(0, -2, 0), 40, 10, 10), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Perspective(default, target, default, 40, 10, 10), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Perspective(default, target, Superior, 180, 10, 10), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Perspective(default, target, Superior, double.NaN, 10, 10), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Perspective(default, target, Superior, 40, 0, 10), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Perspective(default, target, Superior, 40, 10, 20000), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Perspective(new PointMm(double.NaN, 0, 0), target, Superior, 40, 10, 10), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Perspective(default, target, Superior, 40, 10, 10).WithRange(5, 4), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureRays.Orthographic(default, target, Superior, 0, 10, 10), Throws.InstanceOf<ArgumentException>());
        }

        [TestCase(1e-200, 0, 0)]
        [TestCase(1e200, 1e200, 1e200)]
        [TestCase(0, -4, 3)]
        public void Ray_DirectionOfAnyLength_IsNormalised(double x, double y, double z) =>
            Assert.That(new RayMm(default, new VectorMm(x, y, z)).Direction.Length, Is.EqualTo(1).Within(1e-15));

        [TestCase(0, 0, 0)]
        [TestCase(double.NaN, 1, 0)]
        [TestCase(double.PositiveInfinity, 1, 0)]
        public void Ray_NoDirection_Throws(double x, double y, double z) =>
            Assert.That(() => new RayMm(default, new VectorMm(x, y, z)), Throws.InstanceOf<ArgumentException>());

        [Test]
        public void RaySettings_OutsideTheirRange_Throw()
        {
            var settings = new RaySettings();
            foreach (double bad in new[] { 0, -1, double.NaN, double.PositiveInfinity })
            {
                Assert.That(() => settings.StepReference = bad, Throws.InstanceOf<ArgumentOutOfRangeException>());
                Assert.That(() => settings.FirstVisibleAlpha = bad, Throws.InstanceOf<ArgumentOutOfRangeException>());
                Assert.That(() => settings.OpaqueAlpha = bad, Throws.InstanceOf<ArgumentOutOfRangeException>());
            }
            Assert.That(settings.StepReference, Is.EqualTo(0.5));
        }

        static double AngleDegrees(VectorMm a, VectorMm b) => Math.Atan2(a.Cross(b).Length, a.Dot(b)) * 180 / Math.PI;
    }
}
