using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using Random = System.Random;
using Range = NUnit.Framework.RangeAttribute;

namespace AnatomyCarve.Tests.Kernels
{
    public sealed class SobelNormalsTests
    {
        /// <summary>The largest error of an octahedral direction in two bytes, degrees (Cigolle et al. 2014, table 2: 0.94).</summary>
        const double StorageDegrees = 0.95;

        /// <summary>Smaller gradients have no direction.</summary>
        const double NoGradient = 1e-5;

        [Test]
        public void SobelNormals_RandomVolumes_MatchTheTwinToOneDegree([Range(1, 4)] int seed)
        {
            var random = new Random(seed);
            double worst = 0;
            int compared = 0, missing = 0, invented = 0;
            for (int scene = 0; scene < 20; scene++)
            {
                KernelGrid grid = KernelGrid.Random(random, 1, 20);
                byte[] codes = OpacityFields.Random(grid, random);
                byte[] normals = Run(grid, GraphicsFormat.R8_UNorm, codes);
                grid.ForEach((i, j, k) =>
                {
                    double[] gradient = SobelNormalsTwin.Gradient(grid, v => codes[v] / 255.0, i, j, k);
                    double[] normal = NormalAt(normals, grid.Index(i, j, k));
                    double size = SobelNormalsTwin.Length(gradient);
                    if (size < 0.99 * NoGradient && normal != null)
                        invented++;
                    if (size > 1.01 * NoGradient && normal == null)
                        missing++;
                    if (size > 4 / 255.0 && normal != null)
                    {
                        compared++;
                        worst = Math.Max(worst, OctahedralTwin.DegreesBetween(normal, SobelNormalsTwin.Normal(grid, gradient)));
                    }
                });
            }
            Assert.That(compared, Is.GreaterThan(1000));
            Assert.That(worst, Is.LessThanOrEqualTo(1), "degrees, seed " + seed + "; observed: 0.94, all of it storage");
            Assert.That(missing, Is.EqualTo(0), "voxels with a gradient and no normal, seed " + seed);
            Assert.That(invented, Is.EqualTo(0), "voxels without a gradient that got a normal, seed " + seed);
        }

        [TestCase(1, 1, 1)]
        [TestCase(2, 2, 2)]
        [TestCase(5, 5, 5)]
        [TestCase(1, 2, 5)]
        [TestCase(5, 1, 2)]
        [TestCase(0.001, 0.002, 0.005)]
        [TestCase(1000, 500, 100)]
        public void SobelNormals_LinearField_IsExactInMillimetres(double spacingI, double spacingJ, double spacingK)
        {
            var random = new Random(23);
            for (int trial = 0; trial < 10; trial++)
            {
                KernelGrid grid = KernelGrid.Aligned(9, 10, 11, spacingI, spacingJ, spacingK);
                AssertLinearField(grid, RayScene.RandomDirection(random));
            }
        }

        [Test]
        public void SobelNormals_LinearFieldOnRotatedAndShearedGrids_IsExactInMillimetres()
        {
            var random = new Random(29);
            for (int trial = 0; trial < 20; trial++)
                AssertLinearField(KernelGrid.Random(random, 7, 14), RayScene.RandomDirection(random));
        }

        [Test]
        public void SobelNormals_AxisFaces_AreExact()
        {
            KernelGrid grid = KernelGrid.Aligned(17, 17, 17, 1, 2, 3);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => i >= 4 && i < 13 && j >= 4 && j < 13 && k >= 4 && k < 13 ? 255 : 0);
            byte[] normals = Run(grid, GraphicsFormat.R8_UNorm, codes);
            Assert.That(NormalAt(normals, grid.Index(4, 8, 8)), Is.EqualTo(new double[] { -1, 0, 0 }));
            Assert.That(NormalAt(normals, grid.Index(12, 8, 8)), Is.EqualTo(new double[] { 1, 0, 0 }));
            Assert.That(NormalAt(normals, grid.Index(8, 4, 8)), Is.EqualTo(new double[] { 0, -1, 0 }));
            Assert.That(NormalAt(normals, grid.Index(8, 12, 8)), Is.EqualTo(new double[] { 0, 1, 0 }));
            Assert.That(NormalAt(normals, grid.Index(8, 8, 12)), Is.EqualTo(new double[] { 0, 0, 1 }));
            Assert.That(NormalAt(normals, grid.Index(8, 8, 4)), Is.EqualTo(new double[] { 0, 0, -1 }), "the direction whose code means none");
        }

        [TestCase(-1, -1)]
        [TestCase(-1, 1)]
        [TestCase(1, -1)]
        [TestCase(1, 1)]
        public void SobelNormals_DirectionsAroundMinusZ_AreNotTakenForNone(int signX, int signY)
        {
            foreach (double tilt in new[] { 1e-5, 1e-3, 3e-3, 1e-2 })
                AssertLinearField(KernelGrid.Aligned(9, 9, 9), new[] { signX * tilt, signY * tilt, -1 });
        }

        [Test]
        public void SobelNormals_ConstantVolume_HasNormalsOnlyAtItsBorder()
        {
            KernelGrid grid = KernelGrid.Aligned(10, 9, 17);
            byte[] normals = Run(grid, GraphicsFormat.R8_UNorm, OpacityFields.Fill(grid, (i, j, k) => 77));
            int wrong = 0;
            grid.ForEach((i, j, k) =>
            {
                bool atBorder = i < 3 || j < 3 || k < 3 || i >= grid.SizeI - 3 || j >= grid.SizeJ - 3 || k >= grid.SizeK - 3;
                if (atBorder != (NormalAt(normals, grid.Index(i, j, k)) != null))
                    wrong++;
            });
            Assert.That(wrong, Is.EqualTo(0));
            Assert.That(NormalAt(normals, grid.Index(0, 4, 8)), Is.EqualTo(new double[] { -1, 0, 0 }), "out of the volume");
        }

        [Test]
        public void SobelNormals_EmptyAndOneVoxelVolumes_HaveNoGradient()
        {
            KernelGrid grid = KernelGrid.Aligned(9, 8, 7);
            Assert.That(Run(grid, GraphicsFormat.R8_UNorm, new byte[grid.VoxelCount]), Is.All.EqualTo(0));
            KernelGrid single = KernelGrid.Aligned(1, 1, 1);
            Assert.That(Run(single, GraphicsFormat.R8_UNorm, new byte[] { 255 }), Is.All.EqualTo(0), "alike on all sides");
        }

        /// <summary>An opacity that falls along a direction has that direction for a normal everywhere.</summary>
        static void AssertLinearField(KernelGrid grid, double[] direction)
        {
            double[] down = OctahedralTwin.Normalized(direction);
            double low = double.PositiveInfinity, high = double.NegativeInfinity;
            var field = new double[grid.VoxelCount];
            grid.ForEach((i, j, k) =>
            {
                double[] p = grid.PositionOf(i, j, k);
                double value = -(down[0] * p[0] + down[1] * p[1] + down[2] * p[2]);
                field[grid.Index(i, j, k)] = value;
                low = Math.Min(low, value);
                high = Math.Max(high, value);
            });
            float[] opacities = Array.ConvertAll(field, value => (float)((value - low) / (high - low)));
            byte[] normals = Run(grid, GraphicsFormat.R32_SFloat, opacities);
            double worst = 0;
            for (int k = 3; k < grid.SizeK - 3; k++)
                for (int j = 3; j < grid.SizeJ - 3; j++)
                    for (int i = 3; i < grid.SizeI - 3; i++)
                    {
                        double[] normal = NormalAt(normals, grid.Index(i, j, k));
                        worst = Math.Max(worst, normal == null ? 180 : OctahedralTwin.DegreesBetween(normal, down));
                    }
            Assert.That(worst, Is.LessThanOrEqualTo(0.5 + StorageDegrees), "degrees, " + grid);
        }

        static double[] NormalAt(byte[] normals, int voxel) => OctahedralTwin.Decode(normals[2 * voxel], normals[2 * voxel + 1]);

        static byte[] Run<T>(KernelGrid grid, GraphicsFormat format, T[] opacities)
            where T : struct
        {
            using (KernelRig rig = KernelRig.SobelNormals())
            {
                rig.Set(grid);
                rig.SetUncarved(grid);
                rig.SetVolume("_OpacityAA", format, grid, opacities);
                RenderTexture target = rig.VolumeTarget("_NormalsOut", GraphicsFormat.R8G8_UNorm, grid);
                rig.DispatchBricks(grid);
                return KernelRig.Read<byte>(target);
            }
        }
    }
}
