using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Picking
{
    public sealed class OrbitCameraTests
    {
        static readonly VolumeGeometry Volume = new VolumeGeometry(40, 60, 50, new Affine(1, 0, 0, -10, 0, 1, 0, 20, 0, 0, 2, 30));

        [TestCase(0, 0, 0, -1, 0)]
        [TestCase(90, 0, 1, 0, 0)]
        [TestCase(-90, 0, -1, 0, 0)]
        [TestCase(180, 0, 0, 1, 0)]
        [TestCase(0, 90, 0, 0, 1)]
        [TestCase(25, -90, 0, 0, -1)]
        public void Orbit_OfAngles_LooksFromThere(double azimuth, double elevation, double x, double y, double z)
        {
            PictureRays rays = new OrbitCamera(azimuth, elevation).RaysAround(Volume, 101, 101);

            VectorMm towardsEye = (rays.Origin - Volume.CentreLps).Normalized();
            Assert.That((towardsEye - new VectorMm(x, y, z)).Length, Is.LessThan(1e-12));
            Assert.That((rays.RayThroughPixel(50, 50).Direction + towardsEye).Length, Is.LessThan(1e-12), "the middle ray goes through the volume's centre");
        }

        [Test]
        public void Orbit_FromTheFront_ShowsThePatientsLeftAtTheRight()
        {
            PictureRays rays = new OrbitCamera(0, 0).RaysAround(Volume, 100, 100);

            Assert.That(rays.Ray(99.5, 50).Direction.X, Is.Positive, "LPS +x is the patient's left");
            Assert.That(rays.Ray(50, 99.5).Direction.Z, Is.Positive, "y grows upwards");
        }

        [TestCase(0, 0, 30, 200, 100)]
        [TestCase(37, 21, 50, 100, 200)]
        [TestCase(200, -63, 10, 64, 64)]
        public void Orbit_OfAnyAngles_KeepsAllCornersInThePictureAndTouchesItsEdge(double azimuth, double elevation, double fov, int width, int height)
        {
            PictureRays rays = new OrbitCamera(azimuth, elevation, fov).RaysAround(Volume, width, height);

            VectorMm forward = rays.Direction + width * 0.5 * rays.DirectionDx + height * 0.5 * rays.DirectionDy;
            double furthest = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                VectorMm offset = Volume.IjkToLps.TransformPoint(new PointMm(
                    (corner & 1) * Volume.SizeI - 0.5, (corner >> 1 & 1) * Volume.SizeJ - 0.5, (corner >> 2) * Volume.SizeK - 0.5)) - rays.Origin;
                double depth = offset.Dot(forward);
                double perPixel = rays.DirectionDx.Length * rays.DirectionDx.Length;
                furthest = Math.Max(furthest, Math.Abs(offset.Dot(rays.DirectionDx) / depth / perPixel) / (width * 0.5));
                furthest = Math.Max(furthest, Math.Abs(offset.Dot(rays.DirectionDy) / depth / perPixel) / (height * 0.5));
            }
            Assert.That(furthest, Is.InRange(0.95, 1.0), "of the way from the middle to an edge");
        }

        [Test]
        public void VerticalFov_LeftOut_Is30Degrees() => Assert.That(new OrbitCamera(1, 2).VerticalFovDegrees, Is.EqualTo(30));

        [TestCase(double.NaN, 0, 30, "azimuthDegrees")]
        [TestCase(0, 90.5, 30, "elevationDegrees")]
        [TestCase(0, double.NaN, 30, "elevationDegrees")]
        [TestCase(0, 0, 0, "verticalFovDegrees")]
        [TestCase(0, 0, 180, "verticalFovDegrees")]
        public void Orbit_OfAngleOutOfRange_Throws(double azimuth, double elevation, double fov, string parameter) =>
            Assert.That(
                () => new OrbitCamera(azimuth, elevation, fov),
                Throws.TypeOf<ArgumentOutOfRangeException>().With.Property("ParamName").EqualTo(parameter));

        [Test]
        public void EyeAround_NoVolumeOrNoAspect_Throws()
        {
            Assert.That(() => new OrbitCamera(0, 0).EyeAround(null, 1), Throws.ArgumentNullException);
            Assert.That(() => new OrbitCamera(0, 0).EyeAround(Volume, 0), Throws.TypeOf<ArgumentOutOfRangeException>());
        }
    }
}
