using System;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class AffineTests
    {
        const int Seed = 20240611;

        [Test]
        public void Inverse_OfAnyRegularMap_UndoesIt()
        {
            var random = new Random(Seed);
            for (int n = 0; n < 500; n++)
            {
                Affine map = RandomMap(random);
                PointMm point = RandomPoint(random);
                PointMm back = map.Inverse().TransformPoint(map.TransformPoint(point));
                Assert.That(back.DistanceTo(point), Is.LessThan(1e-8), "seed " + Seed + ", map " + n);
            }
        }

        [Test]
        public void Product_OfTwoMaps_AppliesTheRightOneFirst()
        {
            var random = new Random(Seed);
            for (int n = 0; n < 100; n++)
            {
                Affine a = RandomMap(random);
                Affine b = RandomMap(random);
                PointMm point = RandomPoint(random);
                Assert.That((a * b).TransformPoint(point).DistanceTo(a.TransformPoint(b.TransformPoint(point))), Is.LessThan(1e-9), "seed " + Seed + ", pair " + n);
            }
        }

        [Test]
        public void TransformVector_IgnoresTheTranslation()
        {
            Affine map = Affine.FromColumns(new VectorMm(0, 2, 0), new VectorMm(3, 0, 0), new VectorMm(0, 0, -1), new PointMm(10, 20, 30));
            Assert.That(map.TransformVector(new VectorMm(1, 1, 1)), Is.EqualTo(new VectorMm(3, 2, -1)));
            Assert.That(map.TransformPoint(new PointMm(1, 1, 1)), Is.EqualTo(new PointMm(13, 22, 29)));
        }

        [Test]
        public void Indexer_ReadsRowsAndColumns()
        {
            var map = new Affine(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);
            for (int element = 0; element < 12; element++)
                Assert.That(map[element / 4, element % 4], Is.EqualTo(element + 1));
            Assert.That(() => map[3, 0], Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => map[0, 4], Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        [Test]
        public void Inverse_OfASingularMap_Throws()
        {
            Affine flat = Affine.FromColumns(new VectorMm(1, 0, 0), new VectorMm(2, 0, 0), new VectorMm(0, 0, 1), new PointMm(0, 0, 0));
            Assert.That(() => flat.Inverse(), Throws.ArgumentException);
            Assert.That(() => default(Affine).Inverse(), Throws.ArgumentException);
        }

        [Test]
        public void Determinant_OfAMirror_IsNegative()
        {
            Affine mirror = Affine.FromColumns(new VectorMm(-2, 0, 0), new VectorMm(0, 3, 0), new VectorMm(0, 0, 4), new PointMm(0, 0, 0));
            Assert.That(mirror.Determinant, Is.EqualTo(-24));
            Assert.That(Affine.Identity.Determinant, Is.EqualTo(1));
        }

        static PointMm RandomPoint(Random random) => new PointMm(0, 0, 0) + RandomVector(random, 200);

        static VectorMm RandomVector(Random random, double size) =>
            new VectorMm((random.NextDouble() - 0.5) * size, (random.NextDouble() - 0.5) * size, (random.NextDouble() - 0.5) * size);

        static Affine RandomMap(Random random)
        {
            while (true)
            {
                Affine map = Affine.FromColumns(RandomVector(random, 6), RandomVector(random, 6), RandomVector(random, 6), RandomPoint(random));
                if (Math.Abs(map.Determinant) > 0.1)
                    return map;
            }
        }
    }
}
