using System;
using System.Collections.Generic;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class VolumeGeometryTests
    {
        static readonly VectorMm Spacing = new VectorMm(0.5, 1.5, 3);

        static IEnumerable<string> Codes() => Orientations.Codes();

        [TestCaseSource(nameof(Codes))]
        public void OrientationCode_OfEachOfTheFortyEight_NamesItsAxes(string code)
        {
            var geometry = new VolumeGeometry(4, 5, 6, Orientations.Grid(code, Spacing, new PointMm(1, 2, 3)));
            Assert.That(geometry.OrientationCode, Is.EqualTo(code));
        }

        [TestCaseSource(nameof(Codes))]
        public void OrientationCode_OfATiltedGrid_NamesTheClosestAxes(string code)
        {
            double cos = Math.Cos(0.5);
            double sin = Math.Sin(0.5);
            Affine tilt = Affine.FromColumns(new VectorMm(cos, sin, 0), new VectorMm(-sin, cos, 0), new VectorMm(0, 0, 1), new PointMm(0, 0, 0));
            var geometry = new VolumeGeometry(4, 5, 6, tilt * Orientations.Grid(code, new VectorMm(1, 1, 1), new PointMm(1, 2, 3)));
            Assert.That(geometry.OrientationCode, Is.EqualTo(code));
        }

        [Test]
        public void CornerOffset_LiesHalfAVoxelBeyondTheCentresOfVoxels()
        {
            // 4 x 3 x 2 voxels; i runs along -y with 2 mm, j along x with 1 mm, k along z with 5 mm; far from the origin.
            var geometry = new VolumeGeometry(4, 3, 2, Affine.FromColumns(new VectorMm(0, -2, 0), new VectorMm(1, 0, 0), new VectorMm(0, 0, 5), new PointMm(1e6, 7, -9)));
            Assert.That(geometry.CornerOffset(0), Is.EqualTo(new VectorMm(-1.5, 4, -5)));
            Assert.That(geometry.CornerOffset(1), Is.EqualTo(new VectorMm(-1.5, -4, -5)));
            Assert.That(geometry.CornerOffset(2), Is.EqualTo(new VectorMm(1.5, 4, -5)));
            Assert.That(geometry.CornerOffset(7), Is.EqualTo(new VectorMm(1.5, -4, 5)));
        }

        [Test]
        public void Centre_IsTheMiddleOfTheFirstAndLastVoxelsCentres()
        {
            var geometry = new VolumeGeometry(3, 4, 5, Orientations.Grid("RAS", Spacing, new PointMm(10, 20, 30)));
            Assert.That(geometry.CentreLps, Is.EqualTo(new PointMm(10 - 0.5, 20 - 2.25, 30 + 6)));
            Assert.That(geometry.IjkToCentredMm.TransformPoint(new PointMm(1, 1.5, 2)), Is.EqualTo(new PointMm(0, 0, 0)));
        }

        [Test]
        public void Spacing_OfAGrid_IsTheLengthOfItsColumns()
        {
            var geometry = new VolumeGeometry(3, 4, 5, Orientations.Grid("SLA", Spacing, new PointMm(0, 0, 0)));
            Assert.That(geometry.SpacingMm, Is.EqualTo(new VectorMm(3, 0.5, 1.5)));
            Assert.That(geometry.ReferenceLengthMm, Is.EqualTo(0.5));
            Assert.That(geometry.VoxelCount, Is.EqualTo(60));
        }

        [Test]
        public void LpsToIjk_FindsEveryVoxelAgain()
        {
            var geometry = new VolumeGeometry(3, 4, 5, Orientations.Grid("PIR", Spacing, new PointMm(-7, 8, 9)));
            PointMm lps = geometry.IjkToLps.TransformPoint(new PointMm(2, 3, 4));
            Assert.That(geometry.LpsToIjk.TransformPoint(lps).DistanceTo(new PointMm(2, 3, 4)), Is.LessThan(1e-12));
        }

        [Test]
        public void Direction_HasUnitColumns()
        {
            var geometry = new VolumeGeometry(3, 4, 5, Orientations.Grid("RAS", Spacing, new PointMm(0, 0, 0)));
            Assert.That(geometry.Direction(), Is.EqualTo(new double[,] { { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 } }));
        }

        [Test]
        public void IsSheared_OnlyWhenAxesAreNotAtRightAngles()
        {
            Affine tilted = Affine.FromColumns(new VectorMm(1, 0, 0), new VectorMm(0, 1, 0), new VectorMm(0, 0.3, 1), new PointMm(0, 0, 0));
            Assert.That(new VolumeGeometry(2, 2, 2, tilted).IsSheared(), Is.True);
            Assert.That(new VolumeGeometry(2, 2, 2, Orientations.Grid("LPS", Spacing, new PointMm(0, 0, 0))).IsSheared(), Is.False);
        }

        [Test]
        public void Matches_WithinTheToleranceAtTheFarthestCorner()
        {
            VolumeGeometry grid = Cube(100, 1);
            Assert.That(grid.Matches(Cube(100, 1.00005), 0.01, out string small), Is.True);
            Assert.That(small, Is.Null);
            Assert.That(grid.Matches(Cube(100, 1.001), 0.01, out string large), Is.False);
            Assert.That(large, Does.Contain("0.171 mm"));
            Assert.That(grid.Matches(Cube(99, 1), out string sizes), Is.False);
            Assert.That(sizes, Does.Contain("99 x 99 x 99"));
        }

        [Test]
        public void BadSizesAndMaps_AreRefused()
        {
            Assert.That(() => new VolumeGeometry(0, 1, 1, Affine.Identity), Throws.ArgumentException);
            Assert.That(() => new VolumeGeometry(1, 1, 1, default), Throws.ArgumentException);
            Assert.That(() => Cube(2, double.NaN), Throws.ArgumentException);
            Assert.That(() => Cube(2, double.PositiveInfinity), Throws.ArgumentException);
            Affine parallel = Affine.FromColumns(new VectorMm(1, 0, 0), new VectorMm(1, 1e-9, 0), new VectorMm(0, 0, 1), new PointMm(0, 0, 0));
            Assert.That(() => new VolumeGeometry(2, 2, 2, parallel), Throws.ArgumentException);
        }

        static VolumeGeometry Cube(int size, double spacing) =>
            new VolumeGeometry(size, size, size, Orientations.Grid("LPS", new VectorMm(spacing, spacing, spacing), new PointMm(0, 0, 0)));
    }
}
