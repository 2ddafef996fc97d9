using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using Random = System.Random;
using Range = NUnit.Framework.RangeAttribute;

namespace AnatomyCarve.Tests.Kernels
{
    public sealed class ClipVoxelsTests
    {
        [Test]
        public void ClipVoxels_RandomOpaqueScenes_AreClippedExactlyByEq1([Range(1, 4)] int seed) => CheckRandomScenes(seed, 50, 24);

        [Test, Explicit("10,000 scenes take minutes"), Category("Long")]
        public void ClipVoxels_TenThousandRandomOpaqueScenes_AreClippedExactlyByEq1([Range(101, 150)] int seed) => CheckRandomScenes(seed, 200, 32);

        static void CheckRandomScenes(int seed, int scenes, int largest)
        {
            var random = new Random(seed);
            for (int scene = 0; scene < scenes; scene++)
            {
                CarveScene carve = CarveScene.Opaque(KernelGrid.Random(random, 1, largest), 1 + random.Next(60), random);
                for (int count = random.Next(12); count > 0; count--)
                    carve.AddRandomSphere(random);
                AssertEq1(carve, "seed " + seed + ", scene " + scene);
            }
        }

        [Test]
        public void ClipVoxels_SpheresThroughVoxelCentres_AreClippedExactlyByEq1([Range(1, 4)] int seed)
        {
            var random = new Random(seed);
            for (int scene = 0; scene < 20; scene++)
            {
                CarveScene carve = CarveScene.Opaque(KernelGrid.Random(random, 2, 20), 8, random);
                for (int count = 0; count < 6; count++)
                    carve.AddBoundarySphere(random);
                AssertEq1(carve, "seed " + seed + ", scene " + scene);
            }
        }

        [Test]
        public void ClipVoxels_IntegerGridAndRadius_IncludesTheBoundary()
        {
            var random = new Random(5);
            CarveScene carve = CarveScene.Opaque(KernelGrid.Aligned(17, 17, 17), 1, random);
            carve.AddSphere(0, 0, 0, 5, random).Clips[0] = true;
            AssertEq1(carve, "radius 5 around the middle voxel");
            byte[] codes = Run(carve);
            Assert.That(codes[carve.Grid.Index(8 + 3, 8 + 4, 8)], Is.EqualTo(0), "3-4-5: on the boundary");
            Assert.That(codes[carve.Grid.Index(8 + 5, 8, 8)], Is.EqualTo(0), "on the boundary");
            Assert.That(codes[carve.Grid.Index(8 + 5, 8 + 1, 8)], Is.EqualTo(255), "outside");
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(32)]
        [TestCase(33)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(1024)]
        [TestCase(1025)]
        [TestCase(65535)]
        public void ClipVoxels_AnyNumberOfSegments_IsClippedExactlyByEq1(int segments)
        {
            var random = new Random(segments);
            CarveScene carve = CarveScene.Opaque(KernelGrid.Random(random, 9, 20), segments, random);
            for (int count = 0; count < 5; count++)
                carve.AddRandomSphere(random);
            carve.Labels[0] = (ushort)(segments - 1);
            AssertEq1(carve, segments + " segments");
        }

        [TestCase(63)]
        [TestCase(64)]
        [TestCase(65)]
        [TestCase(4096)]
        public void ClipVoxels_ManySpheres_AreClippedExactlyByEq1(int spheres)
        {
            var random = new Random(spheres);
            CarveScene carve = CarveScene.Opaque(KernelGrid.Random(random, 12, 16), 40, random);
            for (int count = 0; count < spheres; count++)
                carve.AddRandomSphere(random).Radius *= spheres > 1000 ? 0.1f : 0.4f;
            AssertEq1(carve, spheres + " spheres");
        }

        [Test]
        public void ClipVoxels_SizesAroundTheBrick_AreClippedExactlyByEq1([Values(1, 7, 8, 9)] int sizeI, [Values(1, 8, 9)] int sizeJ, [Values(1, 7, 17)] int sizeK)
        {
            var random = new Random(100 * sizeI + 10 * sizeJ + sizeK);
            CarveScene carve = CarveScene.Opaque(KernelGrid.Aligned(sizeI, sizeJ, sizeK, 0.5, 1, 2), 3, random);
            carve.AddRandomSphere(random);
            carve.AddBoundarySphere(random);
            AssertEq1(carve, carve.Grid.ToString());
        }

        [Test]
        public void ClipVoxels_DegenerateAndHugeSpheres_AreClippedExactlyByEq1()
        {
            var random = new Random(11);
            double[] radii = { 0, 1e-6, 1e-3, 1e3, 1e6, 1e18, 1e25 };
            double[] distances = { 0, 1e3, 1e6, 1e18 };
            foreach (double radius in radii)
                foreach (double distance in distances)
                {
                    CarveScene carve = CarveScene.Opaque(KernelGrid.Aligned(9, 9, 9), 2, random);
                    Array.Clear(carve.Labels, 0, carve.Labels.Length);
                    carve.AddSphere(distance, 0, 0, radius, random).Clips[0] = true;
                    AssertEq1(carve, "radius " + radius + ", distance " + distance);
                }
        }

        [Test]
        public void ClipVoxels_RandomTranslucentScenes_MatchTheTwinToOneCode([Range(1, 4)] int seed, [Values] bool smoothCut)
        {
            var random = new Random(seed);
            double worst = 0;
            for (int scene = 0; scene < 15; scene++)
            {
                CarveScene carve = CarveScene.Opaque(KernelGrid.Random(random, 1, 20), 1 + random.Next(30), random);
                carve.MakeTranslucent(random);
                carve.SmoothCut = smoothCut;
                for (int count = random.Next(8); count > 0; count--)
                    carve.AddRandomSphere(random);
                byte[] codes = Run(carve);
                carve.Grid.ForEach((i, j, k) => worst = Math.Max(
                    worst, Math.Abs(codes[carve.Grid.Index(i, j, k)] - 255 * ClipVoxelsTwin.Opacity(carve, i, j, k))));
            }
            Assert.That(worst, Is.LessThanOrEqualTo(0.51), "codes; half a code is the storage's rounding; seed " + seed);
        }

        [Test]
        public void ClipVoxels_SmoothCut_ReachesBricksThatOnlyTheVoxelsEdgesTouch()
        {
            var random = new Random(3);
            CarveScene carve = CarveScene.Opaque(KernelGrid.Aligned(16, 8, 8, 3, 3, 3), 1, random);
            carve.SmoothCut = true;
            double[] brickFace = carve.Grid.PositionOf(7.4, 3, 3); // the sphere ends inside the first layer of voxels of brick 0
            carve.AddSphere(brickFace[0] + 30, brickFace[1], brickFace[2], 30, random).Clips[0] = true;
            byte[] codes = Run(carve);
            Assert.That(codes[carve.Grid.Index(7, 3, 3)], Is.InRange(200, 254));
        }

        static void AssertEq1(CarveScene carve, string what)
        {
            byte[] codes = Run(carve);
            int wrong = 0;
            string first = "";
            carve.Grid.ForEach((i, j, k) =>
            {
                byte expected = ClipVoxelsTwin.IsClipped(carve, i, j, k) ? (byte)0 : (byte)255;
                if (codes[carve.Grid.Index(i, j, k)] != expected && wrong++ == 0)
                    first = FormattableString.Invariant($"({i}, {j}, {k}): {codes[carve.Grid.Index(i, j, k)]} instead of {expected}");
            });
            Assert.That(wrong, Is.EqualTo(0), what + ", " + carve.Grid + ", " + first);
        }

        static byte[] Run(CarveScene carve)
        {
            using (KernelRig rig = KernelRig.ClipVoxels())
            {
                carve.Bind(rig);
                RenderTexture target = rig.VolumeTarget("_OpacityOut", GraphicsFormat.R8_UNorm, carve.Grid);
                rig.DispatchBricks(carve.Grid);
                return KernelRig.Read<byte>(target);
            }
        }
    }
}
