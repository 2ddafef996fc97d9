using System;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Tests.Kernels;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using Random = System.Random;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>Spheres of any size, anywhere, and thousands of them: the GPU cuts exactly what the CPU says, and pictures stay finite.</summary>
    sealed class ExtremeSphereTests : StressScene
    {
        static readonly VectorMm TowardsEye = new VectorMm(0.6, -0.7, 0.39).Normalized();

        [Test]
        public void Sphere_OfAnyRadius_CutsWhatTheFieldSays([Values(1e-6, 1e-3, 0.5, 1e2, 1e4, 1e6)] double radius, [Values] CutMode cut)
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(19, 18, 17, 1, 1, 1.5)));
            renderer.Quality.CutMode = cut;
            VolumeGeometry geometry = renderer.Volume.Geometry;
            renderer.Stack.Carving.SetActive(geometry.IjkToLps.TransformPoint(new PointMm(9, 9, 3)), radius);
            Check(renderer, "in the volume");
        }

        [Test]
        public void Sphere_WhoseSurfacePassesFromAfar_CutsWhatTheFieldSays([Values(1e2, 1e3, 1e4, 1e5, 1e6)] double distance, [Values] CutMode cut)
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(19, 18, 17, 1, 1, 1.5)));
            renderer.Quality.CutMode = cut;
            int whole = Check(renderer, "whole");
            renderer.Stack.Carving.SetActive(renderer.Volume.Geometry.CentreLps + distance * TowardsEye, distance - 2);
            int left = Check(renderer, "cut");
            Assert.That(left, Is.InRange(whole / 10, 9 * whole / 10), "voxels of " + whole);
        }

        [Test]
        public void Sphere_AtTheLargestNumbers_CutsNothingOrAll([Values(1e9, ClipSphere.LargestMm)] double size, [Values] CutMode cut)
        {
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(9, 10, 11, 1, 1, 1.5)));
            renderer.Quality.CutMode = cut;
            int whole = Check(renderer, "whole");
            renderer.Stack.Carving.SetActive(new PointMm(size, -size, size), 1);
            Assert.That(Check(renderer, "far away"), Is.EqualTo(whole));
            renderer.Stack.Carving.SetActive(renderer.Volume.Geometry.CentreLps, size);
            Assert.That(Check(renderer, "everything inside"), Is.Zero);
        }

        [Test]
        public void Spheres_FourThousand_CutWhatTheFieldSays([Values] CutMode cut)
        {
            var random = new Random(5);
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(25, 24, 23, 1, 1, 1.5)));
            renderer.Quality.CutMode = cut;
            VolumeGeometry geometry = renderer.Volume.Geometry;
            renderer.Stack.Carving.Replace(Enumerable.Range(0, 4096).Select(_ => new ClipSphere(
                geometry.IjkToLps.TransformPoint(new PointMm(26 * random.NextDouble() - 1, 25 * random.NextDouble() - 1, 24 * random.NextDouble() - 1)),
                1.5 * random.NextDouble(), SegmentMask.FromIndices(SegmentCount, new[] { random.Next(SegmentCount) }))));
            Assert.That(Check(renderer, "4,096 spheres"), Is.GreaterThan(100));
        }

        [Test]
        public void Spheres_OfAllSizesAtOnce_CutWhatTheFieldSays([Values] CutMode cut)
        {
            var random = new Random(6);
            CarvedVolumeRenderer renderer = MakeRamp(Ball(Grid(17, 18, 19, 1, 1, 1.5)));
            renderer.Quality.CutMode = cut;
            renderer.Stack.Carving.Replace(Enumerable.Range(0, 60).Select(_ =>
            {
                double radius = Math.Pow(10, 12 * random.NextDouble() - 6);
                double[] d = RayScene.RandomDirection(random);
                PointMm centre = renderer.Volume.Geometry.CentreLps + (radius + 8 * random.NextDouble()) * new VectorMm(d[0], d[1], d[2]);
                return new ClipSphere(centre, radius, SegmentMask.FromIndices(SegmentCount, new[] { random.Next(1, SegmentCount) }));
            }));
            Assert.That(Check(renderer, "60 spheres"), Is.GreaterThan(0));
        }

        /// <returns>Visible voxels.</returns>
        int Check(CarvedVolumeRenderer renderer, string what)
        {
            AssertSane(renderer.Render(Look(renderer.Volume.Geometry, TowardsEye, 16)).Read(), SegmentCount, what);
            return AssertTexturesAreTheFields(renderer, what);
        }
    }
}
