using System;
using System.Linq;
using System.Threading;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Error;
using AnatomyCarve.Headless.Cli.Bench.Error.Reference;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Bench
{
    /// <summary>What errors are measured against is right itself, where an answer is known without it.</summary>
    sealed class ReferenceTests
    {
        const int Size = 16;
        static readonly VolumeGeometry Grid = Grids.Centred(Size, Size, Size, 1, 1.5, 2);
        static readonly PictureRays Aslant = ParallelViews.Along(new VectorMm(0.1, -0.2, 1).Normalized(), Grid.CentreLps, 4, 4, 100);

        [Test]
        public void Reference_OfAUniformSlab_HasItsAlphaAndDepth()
        {
            const double opacity = 51 / 255.0;
            var picture = Render(PhantomVolumes.OfOpacities(Grid, Filled(51)));
            for (var pixel = 0; pixel < picture.Colors.Length; pixel++)
            {
                var ray = Aslant.RayThroughPixel(pixel % 4, pixel / 4);
                var length = Size * 2 / ray.Direction.Z; // reference lengths of 1 mm
                var enter = (-Size - ray.Origin.Z) / ray.Direction.Z;
                Assert.That(picture.Colors[pixel].A, Is.EqualTo(1 - Math.Pow(1 - opacity, length)).Within(1e-9));
                Assert.That(picture.DepthsMm[pixel], Is.EqualTo(enter + Math.Log(0.5) / Math.Log(1 - opacity)).Within(1e-9));
                Assert.That(picture.Segments[pixel], Is.EqualTo(1));
            }
        }

        [Test]
        public void Reference_OfALinearRamp_HasItsNormalInMillimetres()
        {
            var opacities = Filled(0);
            Grids.ForEach(Grid, (i, j, k, voxel) => opacities[voxel] = (byte)(100 + 2 * (i - 8) - 3 * (j - 8)));
            var field = Field(PhantomVolumes.OfOpacities(Grid, opacities));
            var expected = new VectorMm(-2, 3 / 1.5, 0).Normalized(); // out of matter, codes per mm
            Assert.That((field.NormalOf(8, 8, 8) - expected).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void Reference_OfASmoothCut_TakesTheShareInsideTheSphere()
        {
            var sphere = new ClipSphere(new PointMm(0.5, 0.75, 20), 20, SegmentMask.All(2)); // its surface's lowest point lies in a voxel's centre
            var volume = PhantomVolumes.OfOpacities(Grid, Filled(255));
            var field = new ReferenceField(volume, PhantomVolumes.EightBits, volume.Segments, [sphere], CutMode.Smooth);
            var k = (Size - 1) / 2; // at -1 mm: 21 mm from the sphere's centre, half a voxel beyond its surface
            Assert.That(field.OpacityOf(8, 8, k), Is.EqualTo(1).Within(1e-12));
            Assert.That(field.OpacityOf(8, 8, k + 1), Is.EqualTo(0).Within(1e-12));
        }

        [Test]
        public void Reference_OfEightBits_IsTheFieldOfThePointer()
        {
            var volume = TranslucentOrgans.Make();
            var sphere = new ClipSphere(new PointMm(-14, -22, 12), 17, SegmentMask.All(volume.Segments.Count));
            var reference = new ReferenceField(
                volume, TranslucentOrgans.TransferFunction, volume.Segments, [sphere], CutMode.Binary, OpacityPrecision.EightBits);
            var field = new CarvedField(volume);
            field.Update([sphere], TranslucentOrgans.TransferFunction, volume.Segments, CutMode.Binary, AntiAliasSettings.Default);
            var random = new Random(3);
            double largest = 0;
            for (var n = 0; n < 20000; n++)
            {
                var (i, j, k) = (random.Next(96), random.Next(96), random.Next(64));
                Assert.That(255 * reference.OpacityOf(i, j, k), Is.EqualTo(field.OpacityCode(i, j, k)).Within(1.0001), $"({i}, {j}, {k})");
                largest = Math.Max(largest, Math.Abs(255 * reference.AntiAliasedOf(i, j, k) - field.AntiAliasedCode(i, j, k)));
            }

            TestContext.Out.WriteLine(largest);
            Assert.That(largest, Is.LessThan(0.51), "codes"); // 0.499
        }

        [Test]
        public void SeenNormals_OfAFlatFace_AreItsNormal()
        {
            var stage = BenchSetUp.Stage;
            stage.Show(PhantomVolumes.OfSegments(Grid, 1, place => place.Z > 0 ? 1 : 0));
            stage.Renderer.TransferFunction = PhantomVolumes.Everything;
            var seen = SeenNormals.Look(stage.Renderer, Aslant);
            Assert.That(seen.Normals.Max(normal => (normal - new VectorMm(0, 0, -1)).Length), Is.LessThan(2e-3)); // 16-bit floats
        }

        [Test]
        public void Octahedral_OfEveryCode_ComesBack()
        {
            for (var code = 1; code < 255 * 255; code++)
            {
                var (first, second) = ((byte)(code % 255), (byte)(code / 255));
                var direction = Octahedral.Decode(first, second);
                var (a, b) = Octahedral.Encode(direction);
                Assert.That((Octahedral.Decode(a, b) - direction).Length, Is.LessThan(1e-12), $"{first}, {second}");
            }
        }

        [Test]
        public void Ssim_OfEqualPictures_IsOne()
        {
            var picture = Noise(1);
            Assert.That(StructuralSimilarity.Of(picture, picture, 20, 255), Is.EqualTo(1).Within(1e-12));
        }

        [Test]
        public void Ssim_OfTwoGreys_IsTheTermOfTheirMeans()
        {
            var c1 = 0.01 * 255 * 0.01 * 255;
            var expected = (2 * 100 * 150.0 + c1) / (100 * 100.0 + 150 * 150 + c1);
            Assert.That(StructuralSimilarity.Of(Grey(100), Grey(150), 20, 255), Is.EqualTo(expected).Within(1e-12));
        }

        [Test]
        public void Ssim_OfUnrelatedNoise_IsNearZero() =>
            Assert.That(StructuralSimilarity.Of(Noise(1), Noise(2), 20, 255), Is.EqualTo(0).Within(0.2));

        [Test]
        public void Quantity_WithGoalsOfBothKinds_HoldsWhereAllDo()
        {
            var quantity = new Quantity("P0", "", "1", [40, 0.1]) { AtLeastEach = [true, false] };
            Assert.That(quantity.Holds([41, 0.05]), Is.True);
            Assert.That(quantity.Holds([39, 0.05]), Is.False);
            Assert.That(quantity.Holds([41, 0.2]), Is.False);
            Assert.That(quantity.Holds([double.NaN, 0.05]), Is.False);
        }

        static byte[] Filled(byte opacity)
        {
            var opacities = new byte[Grid.VoxelCount];
            Array.Fill(opacities, opacity);
            return opacities;
        }

        static ReferenceField Field(SegmentedVolume volume) => new(volume, PhantomVolumes.EightBits, volume.Segments, [], CutMode.Binary);

        static ReferencePicture Render(SegmentedVolume volume) =>
            new ReferenceRenderer(Field(volume), new LightSettings()).Render(Aslant, CancellationToken.None);

        static double[] Grey(double value) => [.. Enumerable.Repeat(value, 400)];

        static double[] Noise(int seed)
        {
            var random = new Random(seed);
            return [.. Enumerable.Range(0, 400).Select(_ => 255 * random.NextDouble())];
        }
    }
}
