using AnatomyCarve.Headless.Cli.Commands;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    sealed class OrbitTextTests
    {
        [TestCase("30,15", 30, 15, 30)]
        [TestCase("-200.5, 7,50", -200.5, 7, 50)]
        public void Angles_AreRead(string text, double azimuth, double elevation, double fov)
        {
            var (camera, problem) = OrbitText.Read(text);

            Assert.That(problem, Is.Null);
            Assert.That((camera.AzimuthDegrees, camera.ElevationDegrees, camera.VerticalFovDegrees), Is.EqualTo((azimuth, elevation, fov)));
        }

        [TestCase("0,91", "The elevation must lie between -90 and 90 degrees.")]
        [TestCase("0,0,180", "The field of view must lie between 0 and 180 degrees.")]
        public void Angles_OutOfRange_AreNamed(string text, string problem) => Assert.That(OrbitText.Read(text), Is.EqualTo(((object)null, problem)));

        [TestCase("")]
        [TestCase("1")]
        [TestCase("1,2,3,4")]
        [TestCase("1;2")]
        [TestCase("1,infinity")]
        public void OtherText_IsNeitherCameraNorProblem(string text) => Assert.That(OrbitText.Read(text), Is.EqualTo(((object)null, (string)null)));
    }
}
