using System;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>What edits may cost, in bricks, spheres and texels read, so that a loss of speed fails a test without a clock.</summary>
    sealed class WorkTests : StressScene
    {
        const int Size = 96;

        /// <summary>The share of a cube of 96 voxels of matter that a sphere costs which moves 2.5 voxels.</summary>
        [TestCase(20, 0.07, 0.09, 0.13, TestName = "Move_OfALargeSphere_ComputesTheBricksThatItsSurfaceCrosses")] // observed: 6.9, 8.8, 12.7 %
        [TestCase(10, 0.02, 0.025, 0.04, TestName = "Move_OfAMiddlingSphere_ComputesTheBricksThatItsSurfaceCrosses")] // observed: 1.9, 2.3, 3.7 %
        [TestCase(4, 0.005, 0.005, 0.008, TestName = "Move_OfASmallSphere_ComputesTheBricksThatItsSurfaceCrosses")] // observed: 0.46, 0.46, 0.69 %
        public void Move_OfASphere_ComputesAShare(double radius, double limitClip, double limitSmooth, double limitNormals)
        {
            CarvedVolumeRenderer renderer = MakeCube();
            VolumeGeometry geometry = renderer.Volume.Geometry;
            double bricks = Math.Pow((Size + 7) / 8, 3);
            renderer.Stack.Carving.SetActive(geometry.CentreLps, radius);
            RenderTiny(renderer);
            renderer.Statistics.Reset();
            renderer.Stack.Carving.SetActive(geometry.CentreLps + new VectorMm(2.5, 0, 0), radius);
            RenderTiny(renderer);
            RenderStatistics done = renderer.Statistics;
            double clip = done.ClipVoxels.Bricks / bricks, smooth = done.AntiAlias.Bricks / bricks, normals = done.SobelNormals.Bricks / bricks;
            string figures = FormattableString.Invariant($"ClipVoxels {clip:p2}, AntiAlias {smooth:p2}, SobelNormals {normals:p2} of {bricks} bricks");
            TestContext.WriteLine(figures);
            Assert.That(clip, Is.GreaterThan(0));
            Assert.That(clip, Is.LessThanOrEqualTo(limitClip), figures);
            Assert.That(smooth, Is.LessThanOrEqualTo(limitSmooth), figures);
            Assert.That(normals, Is.LessThanOrEqualTo(limitNormals), figures);
        }

        [Test]
        public void Move_AmongThousandsOfSpheresElsewhere_CostsWhatItCostsAlone()
        {
            (long bricks, long spheres, long tests) alone = CostOfAMove(0), among = CostOfAMove(4096);
            string figures = $"alone {alone}, among 4,096 spheres {among} (bricks, spheres in bricks, spheres tested against bricks)";
            TestContext.WriteLine(figures);
            Assert.That(alone.bricks * alone.spheres, Is.GreaterThan(0));
            Assert.That(among.bricks, Is.LessThanOrEqualTo(1.2 * alone.bricks), figures);
            Assert.That(among.spheres, Is.LessThanOrEqualTo(1.2 * alone.spheres), figures);
        }

        [Test]
        public void AntiAlias_OfAVoxel_ReadsFewOpacities()
        {
            CarvedVolumeRenderer renderer = MakeCube();
            renderer.Stack.Carving.SetActive(renderer.Volume.Geometry.CentreLps, 10);
            RenderTiny(renderer);
            using (var counts = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, sizeof(uint)))
            {
                counts.SetData(new uint[4]);
                renderer.Statistics.Reset();
                renderer.Statistics.WorkCounts = counts;
                renderer.Stack.Carving.SetActive(renderer.Volume.Geometry.CentreLps, 11);
                RenderTiny(renderer);
                renderer.Statistics.WorkCounts = null;
                var n = new uint[4];
                counts.GetData(n);
                TestContext.WriteLine($"{n[0]} voxels, {n[1]} that agree with their neighbours, {n[2]} blended, {n[3]} opacities read");
                Assert.That(n[0], Is.EqualTo(renderer.Statistics.AntiAlias.Elements).And.LessThan(renderer.Statistics.AntiAlias.Bricks * 512L), "voxels: parts of bricks");
                Assert.That((double)n[3] / n[0], Is.LessThanOrEqualTo(4), "opacities read per voxel; observed: 3.04; 1.95 of whole bricks");
                Assert.That(n[2], Is.GreaterThan(0).And.LessThan(n[0] / 2), "only those at the surface are blended; observed: 0.41, because little else is worked on");
                Assert.That(n[1] + n[2], Is.LessThanOrEqualTo(n[0]));
            }
        }

        [Test]
        public void EraserStroke_OfAThousandSpheres_CostsAtItsEndWhatItCostsAtItsBeginning()
        {
            const int steps = 1000;
            CarvedVolumeRenderer renderer = MakeCube();
            CarvingStack carving = renderer.Stack.Carving;
            carving.ActiveRadiusFactor = 1;
            RenderTiny(renderer);
            (long bricks, long spheres) tenth = default, last = default;
            for (int step = 1; step <= steps; step++)
            {
                // Lines along x, two bricks apart. The tenth and the last step lie alike in their bricks: 30 x 1.6 is six bricks.
                int column = (step - 1) % 40, row = (step - 1) / 40 % 5, layer = (step - 1) / 200;
                bool isMeasured = step == 10 || step == steps;
                if (isMeasured)
                    RenderTiny(renderer); // what went before
                renderer.Statistics.Reset();
                carving.SetActive(renderer.Volume.Geometry.CentreLps + new VectorMm(1.6 * column - 32, 16 * row - 32, 16 * layer - 32), 2.5);
                carving.FixActive();
                if (!isMeasured)
                    continue;
                RenderTiny(renderer);
                (long, long) cost = (renderer.Statistics.AntiAlias.Bricks, renderer.Statistics.SpheresInBricks);
                if (step == 10)
                    tenth = cost;
                else
                    last = cost;
            }
            string figures = $"tenth {tenth}, last {last} (bricks, spheres in bricks)";
            TestContext.WriteLine(figures);
            Assert.That(carving.Fixed.Count, Is.EqualTo(steps));
            Assert.That(tenth.bricks, Is.GreaterThan(0));
            Assert.That(last.bricks, Is.LessThanOrEqualTo(1.2 * tenth.bricks), figures);
            Assert.That(last.spheres, Is.LessThanOrEqualTo(1.5 * tenth.spheres), figures);
        }

        CarvedVolumeRenderer MakeCube()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Cube(Size, "matter"));
            renderer.Quality.SkipEmptySpace = true;
            return renderer;
        }

        (long bricks, long spheres, long tests) CostOfAMove(int others)
        {
            CarvedVolumeRenderer renderer = MakeCube();
            CarvingStack carving = renderer.Stack.Carving;
            PointMm centre = renderer.Volume.Geometry.CentreLps;
            carving.Replace(Enumerable.Range(0, others).Select(n => new ClipSphere(
                centre + new VectorMm(n % 16 - 45, n / 16 % 16 * 2 - 45, n / 256 * 2 - 45), 0.9, SegmentMask.All(carving.SegmentCount))));
            carving.SetActive(centre + new VectorMm(20, 20, 20), 10);
            RenderTiny(renderer);
            renderer.Statistics.Reset();
            carving.SetActive(centre + new VectorMm(22.5, 20, 20), 10);
            RenderTiny(renderer);
            return (renderer.Statistics.AntiAlias.Bricks, renderer.Statistics.SpheresInBricks, renderer.Statistics.SphereBrickTests);
        }

        static void RenderTiny(CarvedVolumeRenderer renderer) => renderer.Render(PictureRays.Orthographic(
            renderer.Volume.Geometry.CentreLps + new VectorMm(0, -100, 0), renderer.Volume.Geometry.CentreLps, Superior, 100, 2, 2));
    }
}
