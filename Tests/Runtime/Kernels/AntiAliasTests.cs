using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using Random = System.Random;
using Range = NUnit.Framework.RangeAttribute;

namespace AnatomyCarve.Tests.Kernels
{
    public sealed class AntiAliasTests
    {
        [Test]
        public void AntiAlias_RandomVolumes_MatchTheTwinToOneCode([Range(1, 4)] int seed)
        {
            var random = new Random(seed);
            double worst = 0;
            for (int scene = 0; scene < 25; scene++)
            {
                KernelGrid grid = KernelGrid.Random(random, 1, 20);
                byte[] codes = OpacityFields.Random(grid, random);
                var twin = new AntiAliasTwin(grid, codes);
                byte[] result = Run(grid, codes, twin);
                grid.ForEach((i, j, k) => worst = Math.Max(worst, Math.Abs(result[grid.Index(i, j, k)] - 255 * twin.Opacity(i, j, k))));
            }
            Assert.That(worst, Is.LessThanOrEqualTo(0.51), "codes; half a code is the storage's rounding; seed " + seed);
        }

        [TestCase(0.3, 0, 0.06, 1)]
        [TestCase(0, 0, 0, 1)]
        [TestCase(0.0625, 0.5, 0.1, 0.5)]
        public void AntiAlias_OtherSettings_MatchTheTwinToOneCode(double absolute, double relative, double gradient, double strength)
        {
            var random = new Random(17);
            KernelGrid grid = KernelGrid.Aligned(19, 12, 14);
            byte[] codes = OpacityFields.Balls(grid, random);
            var twin = new AntiAliasTwin(grid, codes) { ThresholdAbsolute = absolute, ThresholdRelative = relative, GradientMinimum = gradient, Strength = strength };
            byte[] result = Run(grid, codes, twin);
            double worst = 0;
            grid.ForEach((i, j, k) => worst = Math.Max(worst, Math.Abs(result[grid.Index(i, j, k)] - 255 * twin.Opacity(i, j, k))));
            Assert.That(worst, Is.LessThanOrEqualTo(0.51));
        }

        [Test]
        public void AntiAlias_StrengthZero_ChangesNothing()
        {
            KernelGrid grid = KernelGrid.Aligned(13, 9, 10);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => (i * 37 + j * 91 + k * 53) % 256);
            Assert.That(Run(grid, codes, new AntiAliasTwin(grid, codes) { Strength = 0 }), Is.EqualTo(codes));
        }

        [Test]
        public void AntiAlias_ConstantVolume_StaysBitIdentical([Values(0, 1, 127, 254, 255)] int code)
        {
            KernelGrid grid = KernelGrid.Aligned(10, 9, 17);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => code);
            Assert.That(Run(grid, codes, new AntiAliasTwin(grid, codes)), Is.EqualTo(codes));
        }

        [Test]
        public void AntiAlias_BelowTheContrastThreshold_StaysBitIdentical()
        {
            var random = new Random(8);
            KernelGrid grid = KernelGrid.Aligned(12, 12, 12);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => 100 + random.Next(15)); // 14 codes of contrast, the threshold is 15.9
            Assert.That(Run(grid, codes, new AntiAliasTwin(grid, codes)), Is.EqualTo(codes));
        }

        [Test]
        public void AntiAlias_FlatFacesOfABox_StayAsTheyAre()
        {
            KernelGrid grid = KernelGrid.Aligned(20, 20, 20);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => i >= 4 && i < 16 && j >= 4 && j < 16 && k >= 4 && k < 16 ? 255 : 0);
            byte[] result = Run(grid, codes, new AntiAliasTwin(grid, codes));
            Assert.That(result[grid.Index(4, 10, 10)], Is.EqualTo(255), "inside the face");
            Assert.That(result[grid.Index(3, 10, 10)], Is.EqualTo(0), "outside the face");
        }

        [Test]
        public void AntiAlias_StepsOfAnObliqueFace_AreSoftened()
        {
            KernelGrid grid = KernelGrid.Aligned(24, 24, 8);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => i + 3 * j < 48 ? 255 : 0);
            byte[] result = Run(grid, codes, new AntiAliasTwin(grid, codes));
            int softened = 0, steps = 0;
            for (int i = 3; i < 21; i++)
                for (int j = 1; j < 23; j++)
                    if (codes[grid.Index(i, j, 4)] != codes[grid.Index(i + 1, j, 4)])
                    {
                        steps++;
                        softened += result[grid.Index(i, j, 4)] < 255 || result[grid.Index(i + 1, j, 4)] > 0 ? 1 : 0;
                    }
            Assert.That(steps, Is.GreaterThan(4));
            Assert.That(softened, Is.EqualTo(steps));
        }

        [Test]
        public void AntiAlias_AnyVolume_StaysInTheRangeOfTheNeighbourhood([Range(1, 3)] int seed)
        {
            var random = new Random(seed);
            KernelGrid grid = KernelGrid.Random(random, 8, 20);
            byte[] codes = OpacityFields.Fill(grid, (i, j, k) => random.Next(256));
            byte[] result = Run(grid, codes, new AntiAliasTwin(grid, codes) { ThresholdAbsolute = 0, ThresholdRelative = 0, GradientMinimum = 0 });
            int outside = 0;
            grid.ForEach((i, j, k) =>
            {
                byte low = 255, high = 0, value = result[grid.Index(i, j, k)];
                for (int n = 0; n < 27; n++)
                {
                    byte o = codes[grid.Index(
                        Mathf.Clamp(i + n % 3 - 1, 0, grid.SizeI - 1), Mathf.Clamp(j + n / 3 % 3 - 1, 0, grid.SizeJ - 1), Mathf.Clamp(k + n / 9 - 1, 0, grid.SizeK - 1))];
                    low = Math.Min(low, o);
                    high = Math.Max(high, o);
                }
                if (value < low || value > high)
                    outside++;
            });
            Assert.That(outside, Is.EqualTo(0), "seed " + seed);
        }

        [Test]
        public void AntiAlias_The48SymmetriesOfTheCube_CommuteWithItToOneCode()
        {
            KernelGrid grid = KernelGrid.Aligned(12, 12, 12);
            byte[] codes = OpacityFields.Balls(grid, new Random(4));
            byte[] result = Run(grid, codes, new AntiAliasTwin(grid, codes));
            int worst = 0;
            for (int symmetry = 0; symmetry < 48; symmetry++)
            {
                byte[] turnedResult = Run(grid, Turn(grid, codes, symmetry), new AntiAliasTwin(grid, codes));
                byte[] expected = Turn(grid, result, symmetry);
                for (int v = 0; v < expected.Length; v++)
                    worst = Math.Max(worst, Math.Abs(turnedResult[v] - expected[v]));
            }
            Assert.That(worst, Is.LessThanOrEqualTo(1), "codes; observed: 0");
        }

        /// <summary>A cube of voxels under one of the cube's 48 symmetries: 6 orders of the axes, 8 reflections.</summary>
        static byte[] Turn(KernelGrid cube, byte[] codes, int symmetry)
        {
            int[][] orders = { new[] { 0, 1, 2 }, new[] { 0, 2, 1 }, new[] { 1, 0, 2 }, new[] { 1, 2, 0 }, new[] { 2, 0, 1 }, new[] { 2, 1, 0 } };
            int[] order = orders[symmetry % 6];
            int mirrored = symmetry / 6, last = cube.SizeI - 1;
            var turned = new byte[codes.Length];
            cube.ForEach((i, j, k) =>
            {
                int[] from = { i, j, k };
                var to = new int[3];
                for (int axis = 0; axis < 3; axis++)
                    to[axis] = (mirrored >> axis & 1) == 0 ? from[order[axis]] : last - from[order[axis]];
                turned[cube.Index(to[0], to[1], to[2])] = codes[cube.Index(i, j, k)];
            });
            return turned;
        }

        static byte[] Run(KernelGrid grid, byte[] codes, AntiAliasTwin settings)
        {
            using (KernelRig rig = KernelRig.AntiAlias())
            {
                rig.Set(grid);
                rig.Set("_AntiAlias", new Vector4((float)settings.ThresholdAbsolute, (float)settings.ThresholdRelative, (float)settings.GradientMinimum, (float)settings.Strength));
                rig.SetVolume("_Opacity", GraphicsFormat.R8_UNorm, grid, codes);
                RenderTexture target = rig.VolumeTarget("_OpacityAAOut", GraphicsFormat.R8_UNorm, grid);
                rig.DispatchBricks(grid);
                return KernelRig.Read<byte>(target);
            }
        }
    }
}
