using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using Random = System.Random;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>
    /// Volumes of 1 to 17 voxels along each axis: around bricks of 8, skip cells of 4 and their neighbours. The GPU holds what the CPU says, and rays that
    /// skip see what rays that do not skip see.
    /// </summary>
    sealed class VolumeSizeTests : StressScene
    {
        const int Largest = 17;

        /// <summary>Coprime to 17, so that each size along each axis comes up.</summary>
        const int Stride = 115;

        [Test]
        public void Volume_OfASizeOutOfAll_IsCutAndShownExactly([Range(0, 3)] int part) =>
            Check(Enumerable.Range(0, Largest * Largest * Largest / Stride + 1).Where(n => n % 4 == part).Select(n => n * Stride), part);

        [TestCase(1, 1, 1)]
        [TestCase(17, 1, 1)]
        [TestCase(1, 17, 1)]
        [TestCase(1, 1, 17)]
        [TestCase(8, 8, 8)]
        [TestCase(9, 9, 9)]
        [TestCase(16, 16, 16)]
        public void Volume_OfASizeAtALimit_IsCutAndShownExactly(int sizeI, int sizeJ, int sizeK) =>
            Check(new[] { sizeI - 1 + Largest * (sizeJ - 1 + Largest * (sizeK - 1)) }, sizeI);

        [Test, Explicit("4,913 sizes take minutes"), Category("Long")]
        public void Volume_OfAnySize_IsCutAndShownExactly([Range(1, Largest)] int sizeK) =>
            Check(Enumerable.Range(Largest * Largest * (sizeK - 1), Largest * Largest), sizeK);

        void Check(IEnumerable<int> sizes, int seed)
        {
            var random = new Random(seed);
            CarvedVolumeRenderer renderer = null;
            int visible = 0, seen = 0;
            foreach (int n in sizes)
            {
                int sizeI = n % Largest + 1, sizeJ = n / Largest % Largest + 1, sizeK = n / Largest / Largest + 1;
                SegmentedVolume volume = Noise(Grid(sizeI, sizeJ, sizeK, 1, 1.2, 1.7), random);
                if (renderer == null)
                    renderer = MakeRamp(volume);
                else
                {
                    LeaveTextures();
                    renderer.Loader.SetVolume(volume);
                }
                string what = $"{sizeI} x {sizeJ} x {sizeK}, seed {seed}";
                renderer.Quality.CutMode = (CutMode)random.Next(2);
                renderer.Stack.Carving.SetActive(
                    volume.Geometry.IjkToLps.TransformPoint(new PointMm(sizeI * random.NextDouble(), sizeJ * random.NextDouble(), sizeK * random.NextDouble())),
                    0.7 * Radius(volume.Geometry) * random.NextDouble());
                renderer.Stack.ToggleSegment(random.Next(SegmentCount));
                PictureRays rays = RandomMatter.Rays(volume.Geometry, random, 8);
                renderer.Quality.SkipEmptySpace = true;
                PictureData skipping = renderer.Render(rays).Read();
                renderer.Quality.SkipEmptySpace = false;
                PictureData complete = renderer.Render(rays).Read();
                AssertSane(skipping, SegmentCount, what);
                AssertIdentical(complete, skipping, "with skipping, " + what);
                visible += AssertTexturesAreTheFields(renderer, what);
                seen += CountSeen(skipping);
            }
            Assert.That(visible, Is.GreaterThan(0));
            TestContext.WriteLine($"{visible} visible voxels, {seen} pixels that show a segment, seed {seed}");
        }

        /// <summary>Empty, solid and noisy parts, of five segments.</summary>
        static SegmentedVolume Noise(VolumeGeometry geometry, Random random)
        {
            var codes = new ushort[geometry.VoxelCount];
            var indices = new ushort[geometry.VoxelCount];
            double nx = random.NextDouble() - 0.5, ny = random.NextDouble() - 0.5, nz = random.NextDouble() - 0.5;
            int v = 0;
            for (int k = 0; k < geometry.SizeK; k++)
                for (int j = 0; j < geometry.SizeJ; j++)
                    for (int i = 0; i < geometry.SizeI; i++, v++)
                    {
                        double along = nx * (2 * i + 1 - geometry.SizeI) + ny * (2 * j + 1 - geometry.SizeJ) + nz * (2 * k + 1 - geometry.SizeK);
                        codes[v] = (ushort)(along < -0.5 ? 0 : along > 3 ? 1000 : random.Next(1001));
                        indices[v] = (ushort)random.Next(SegmentCount);
                    }
            return Volume(geometry, codes, indices, SegmentCount);
        }
    }
}
