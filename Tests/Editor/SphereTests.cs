using System.Globalization;
using System.Threading;
using AnatomyCarve.Carving;
using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>What the Editor writes about spheres, and the numbers that it lets through.</summary>
    sealed class SphereTests
    {
        static readonly ClipSphere Sphere = new ClipSphere(new PointMm(60.04, -4, 20.26), 47.126, SegmentMask.FromIndices(118, new[] { 1, 2, 3 }));

        [Test]
        public void Texts_OfASphere_AreTheSameInEachCulture()
        {
            CultureInfo before = Thread.CurrentThread.CurrentCulture;
            try
            {
                Thread.CurrentThread.CurrentCulture = CultureInfo.GetCultureInfo("de-DE");
                Assert.That(SphereTexts.Radius(Sphere), Is.EqualTo("47.13 mm"));
                Assert.That(SphereTexts.Centre(Sphere), Is.EqualTo("60 L, 4 A, 20.3 S"));
                Assert.That(SphereTexts.Clipped(Sphere), Is.EqualTo("3 of 118"));
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [TestCase(0, false, "Sphere 1")]
        [TestCase(4, true, "Active")]
        public void Title_OfASphere_CountsFromOne(int index, bool isActive, string expected) =>
            Assert.That(SphereTexts.Title(index, isActive), Is.EqualTo(expected));

        [TestCase(12.5, 12.5)]
        [TestCase(-1, 0)]
        [TestCase(double.NaN, 0)]
        [TestCase(double.PositiveInfinity, ClipSphere.LargestMm)]
        public void Radius_ThatWasTyped_IsOneThatASphereCanHave(double typed, double expected) => Assert.That(SphereLimits.Radius(typed), Is.EqualTo(expected));

        [TestCase(-12.5, -12.5)]
        [TestCase(double.NegativeInfinity, -ClipSphere.LargestMm)]
        public void Coordinate_ThatWasTyped_IsOneThatASphereCanHave(double typed, double expected) =>
            Assert.That(SphereLimits.Coordinate(typed), Is.EqualTo(expected));
    }
}
