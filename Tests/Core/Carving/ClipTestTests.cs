using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>Eq. 1 in float against a plain double-precision oracle, and on boundaries that are known exactly.</summary>
    public sealed class ClipTestTests
    {
        const int SegmentCount = 40;

        [Test]
        public void IsClipped_RandomScenes_AgreesWithDoublePrecisionAwayFromTheBoundary()
        {
            var scenes = new RandomScenes(20261);
            int compared = 0, onBoundary = 0;
            for (int scene = 0; scene < 400; scene++)
            {
                SegmentedVolume volume = scenes.Volume(11, SegmentCount);
                var grid = new CentredGrid(volume.Geometry);
                List<ClipSphere> spheres = scenes.Spheres(volume.Geometry, SegmentCount, 5);
                Phantoms.Map(volume.Geometry, (i, j, k) =>
                {
                    int segment = volume.Labels.Indices[i + volume.Geometry.SizeI * (j + volume.Geometry.SizeJ * k)];
                    bool? expected = Oracle(volume.Geometry, spheres, i, j, k, segment);
                    if (expected == null)
                    {
                        onBoundary++;
                        return 0;
                    }
                    compared++;
                    Assert.That(ClipTest.IsClipped(grid, spheres, i, j, k, segment), Is.EqualTo(expected.Value), $"scene {scene}, voxel {i} {j} {k}");
                    return 0;
                });
            }
            Assert.That(compared, Is.GreaterThan(50000));
            Assert.That(onBoundary, Is.LessThan(compared / 1000));
        }

        [Test]
        public void Inside_LargestSpheres_AreDecidedInFloatWithoutOverflow([Values(-1, 1)] int sign)
        {
            const double Largest = ClipSphere.LargestMm;
            var grid = new CentredGrid(new VolumeGeometry(3, 3, 3, Affine.Identity));
            SegmentMask all = SegmentMask.All(1);
            var far = new PointMm(sign * Largest, sign * Largest, sign * Largest);
            Assert.That(ClipTest.IsClipped(grid, new[] { new ClipSphere(far, Largest, all) }, 1, 1, 1, 0), Is.False, "its surface is 0.7e18 mm away");
            var beside = new PointMm(sign * 0.5 * Largest, 0, 0);
            Assert.That(ClipTest.IsClipped(grid, new[] { new ClipSphere(beside, Largest, all) }, 1, 1, 1, 0), Is.True);
        }

        [TestCase(3, 4, 0, 5)]
        [TestCase(2, 3, 6, 7)]
        [TestCase(-1, 4, -8, 9)]
        [TestCase(0, 0, -6, 6)]
        [TestCase(6, 6, 7, 11)]
        public void IsClipped_VoxelExactlyOnTheSurface_IsInside(int i, int j, int k, double radius)
        {
            var grid = new CentredGrid(new VolumeGeometry(25, 25, 25, Affine.Identity));
            var centre = new PointMm(12, 12, 12);
            SegmentMask mask = SegmentMask.All(1);

            Assert.That(ClipTest.IsClipped(grid, new[] { new ClipSphere(centre, radius, mask) }, 12 + i, 12 + j, 12 + k, 0), Is.True);
            double justLess = Math.Round(radius, 6) - 1e-6;
            Assert.That(ClipTest.IsClipped(grid, new[] { new ClipSphere(centre, justLess, mask) }, 12 + i, 12 + j, 12 + k, 0), Is.False);
        }

        [Test]
        public void Inside_RadiusZeroAtTheCentre_IsOutside()
        {
            Assert.That(ClipTest.Inside(new SphereF(1, 2, 3, 0), 1, 2, 3), Is.False);
            Assert.That(ClipTest.Inside(new SphereF(1, 2, 3, 1e-6f), 1, 2, 3), Is.True);
        }

        [Test]
        public void Position_HalfMillimetreGrid_IsExact()
        {
            var geometry = new VolumeGeometry(4, 5, 6, Affine.FromColumns(
                new VectorMm(0, 0.5, 0), new VectorMm(-2, 0, 0), new VectorMm(0, 0, 1), new PointMm(1000.25, -7, 3)));
            var grid = new CentredGrid(geometry);

            grid.Position(3, 0, 5, out float x, out float y, out float z);

            Assert.That(new[] { x, y, z }, Is.EqualTo(new[] { 4f, 0.75f, 2.5f }));
        }

        [Test]
        public void ToCentred_FarFromTheOrigin_SubtractsBeforeRounding()
        {
            var geometry = new VolumeGeometry(11, 11, 11, Affine.FromColumns(
                new VectorMm(1, 0, 0), new VectorMm(0, 1, 0), new VectorMm(0, 0, 1), new PointMm(1e6, -1e6, 1e6)));
            var grid = new CentredGrid(geometry);

            SphereF sphere = grid.ToCentred(new ClipSphere(new PointMm(1e6 + 5.1, -1e6 + 5, 1e6 + 5), 2, SegmentMask.All(1)));

            Assert.That(sphere.X, Is.EqualTo(0.1f).Within(1e-6f));
            Assert.That(sphere.Y, Is.EqualTo(0f));
        }

        static bool? Oracle(VolumeGeometry geometry, IEnumerable<ClipSphere> spheres, int i, int j, int k, int segment)
        {
            PointMm voxel = geometry.IjkToLps.TransformPoint(new PointMm(i, j, k));
            bool clipped = false;
            foreach (ClipSphere sphere in spheres.Where(sphere => sphere.Mask[segment]))
            {
                double distance = voxel.DistanceTo(sphere.CentreLps);
                if (Math.Abs(distance - sphere.RadiusMm) < 1e-5 * (1 + distance))
                    return null;
                clipped |= sphere.RadiusMm > 0 && distance <= sphere.RadiusMm;
            }
            return clipped;
        }
    }
}
