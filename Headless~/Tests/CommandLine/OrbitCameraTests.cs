using AnatomyCarve.Headless.Cli.Commands;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine;

sealed class OrbitCameraTests
{
    static readonly VolumeGeometry Volume = new(40, 60, 50, new Affine(1, 0, 0, -10, 0, 1, 0, 20, 0, 0, 2, 30));

    static PictureRays Rays(string angles, PictureSize size) => OrbitCamera.TryParse(angles).Around(Volume, size).Rays(size);

    [TestCase("0,0", 0, -1, 0)]
    [TestCase("90,0", 1, 0, 0)]
    [TestCase("-90,0", -1, 0, 0)]
    [TestCase("180,0", 0, 1, 0)]
    [TestCase("0,90", 0, 0, 1)]
    [TestCase("25,-90", 0, 0, -1)]
    public void Orbit_OfAngles_LooksFromThere(string angles, double x, double y, double z)
    {
        var rays = Rays(angles, new PictureSize(101, 101));

        var towardsEye = (rays.Origin - Volume.CentreLps).Normalized();
        Assert.That((towardsEye - new VectorMm(x, y, z)).Length, Is.LessThan(1e-12));
        var centre = rays.Ray(50.5, 50.5);
        Assert.That((centre.Direction + towardsEye).Length, Is.LessThan(1e-12), "the middle ray goes through the volume's centre");
    }

    [Test]
    public void Orbit_FromTheFront_ShowsThePatientsLeftAtTheRight()
    {
        var rays = Rays("0,0", new PictureSize(100, 100));

        Assert.That(rays.Ray(99.5, 50).Direction.X, Is.Positive, "LPS +x is the patient's left");
        Assert.That(rays.Ray(50, 99.5).Direction.Z, Is.Positive, "y grows upwards");
    }

    [TestCase("0,0", 200, 100)]
    [TestCase("37,21,50", 100, 200)]
    [TestCase("200,-63,10", 64, 64)]
    public void Orbit_OfAnyAngles_KeepsAllCornersInThePicture(string angles, int width, int height)
    {
        var rays = Rays(angles, new PictureSize(width, height));

        var bottomLeft = rays.Ray(0, 0).Direction;
        var topRight = rays.Ray(width, height).Direction;
        var right = (rays.Ray(width, 0).Direction - bottomLeft).Normalized();
        var up = (rays.Ray(0, height).Direction - bottomLeft).Normalized();
        var forward = (Volume.CentreLps - rays.Origin).Normalized();
        var (tanX, tanY) = (topRight.Dot(right) / topRight.Dot(forward), topRight.Dot(up) / topRight.Dot(forward));
        for (var corner = 0; corner < 8; corner++)
        {
            var offset = Volume.IjkToLps.TransformPoint(new PointMm(
                (corner & 1) * Volume.SizeI - 0.5, (corner >> 1 & 1) * Volume.SizeJ - 0.5, (corner >> 2) * Volume.SizeK - 0.5)) - rays.Origin;
            Assert.That(offset.Dot(right) / offset.Dot(forward), Is.InRange(-tanX, tanX), $"corner {corner}");
            Assert.That(offset.Dot(up) / offset.Dot(forward), Is.InRange(-tanY, tanY), $"corner {corner}");
        }
    }

    [TestCase("")]
    [TestCase("1")]
    [TestCase("1,2,3,4")]
    [TestCase("1;2")]
    [TestCase("1,infinity")]
    public void Orbit_OfOtherText_IsNone(string text) => Assert.That(OrbitCamera.TryParse(text), Is.Null);
}
