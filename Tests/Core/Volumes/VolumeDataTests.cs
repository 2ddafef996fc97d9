using System;
using System.Threading;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class VolumeDataTests
    {
        static readonly VolumeGeometry Geometry = new VolumeGeometry(2, 3, 2, Affine.Identity);

        [TestCase(ComponentOrder.Fastest, 19)]
        [TestCase(ComponentOrder.Slowest, 21)]
        public void Value_OfAComponent_IsFoundInEitherOrder(ComponentOrder order, int stored)
        {
            var voxels = new int[24];
            for (int n = 0; n < voxels.Length; n++)
                voxels[n] = n;

            // Voxel (1, 1, 1) is number 9 of 12: its component 1 is number 9 * 2 + 1, or 12 + 9.
            var data = new VolumeData(Geometry, voxels, 2, order, 2, -3);
            Assert.That(data.Value(1, 1, 1, 1), Is.EqualTo((2 * stored) - 3));
        }

        [Test]
        public void Statistics_LeaveNonFiniteValuesOut()
        {
            var data = new VolumeData(Geometry, new[] { 1f, 2f, float.NaN, float.PositiveInfinity, 3f, 0f, 0f, 0f, 0f, 0f, 0f, 6f });
            VolumeStatistics statistics = data.Statistics();
            Assert.That(statistics.Minimum, Is.EqualTo(0));
            Assert.That(statistics.Maximum, Is.EqualTo(6));
            Assert.That(statistics.Mean, Is.EqualTo(1.2).Within(1e-15));
            Assert.That(statistics.NonFiniteCount, Is.EqualTo(2));
            Assert.That(statistics.Count, Is.EqualTo(12));
        }

        [Test]
        public void Statistics_WithoutFiniteValues_AreNan()
        {
            var data = new VolumeData(new VolumeGeometry(1, 1, 1, Affine.Identity), new[] { double.NaN });
            Assert.That(data.Statistics().Mean, Is.NaN);
            Assert.That(data.Statistics().Minimum, Is.NaN);
        }

        [Test]
        public void Statistics_AreThoseOfScaledValues_AndStoredOnesOfStoredValues()
        {
            var data = new VolumeData(new VolumeGeometry(2, 1, 1, Affine.Identity), new byte[] { 0, 10 }, 1, ComponentOrder.Fastest, -2, 5);
            Assert.That(data.Statistics().Minimum, Is.EqualTo(-15));
            Assert.That(data.Statistics().Maximum, Is.EqualTo(5));
            Assert.That(data.StoredStatistics().Maximum, Is.EqualTo(10));
        }

        [Test]
        public void Sha256_IsThatOfLittleEndianDoubles()
        {
            // sha256sum of the sixteen bytes 0000000000000000 000000000000F03F.
            var data = new VolumeData(new VolumeGeometry(2, 1, 1, Affine.Identity), new short[] { 0, 1 });
            Assert.That(data.Statistics().Sha256, Is.EqualTo("fc62429c3e69001d65972cdeb94fb9aa18a7d9c16bc449e1e474e7e41bb95a7d"));
        }

        [Test]
        public void BadArguments_AreRefused()
        {
            Assert.That(() => new VolumeData(Geometry, new byte[11]), Throws.ArgumentException);
            Assert.That(() => new VolumeData(Geometry, new char[12]), Throws.ArgumentException);
            Assert.That(() => new VolumeData(Geometry, new byte[12], 1, ComponentOrder.Fastest, 0), Throws.ArgumentException);
            Assert.That(() => new VolumeData(Geometry, new byte[12], 1, ComponentOrder.Fastest, 1, double.NaN), Throws.ArgumentException);
            Assert.That(() => new VolumeData(Geometry, new byte[12]).Value(2, 0, 0), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        [Test]
        public void VoxelType_IsThatOfTheArray()
        {
            var geometry = new VolumeGeometry(1, 1, 1, Affine.Identity);
            Assert.That(new VolumeData(geometry, new sbyte[] { -1 }).VoxelType, Is.EqualTo(VoxelType.Int8));
            Assert.That(new VolumeData(geometry, new sbyte[] { -1 }).Value(0), Is.EqualTo(-1));
            Assert.That(new VolumeData(geometry, new uint[] { uint.MaxValue }).Value(0), Is.EqualTo(4294967295d));
        }

        [Test]
        public void CancelledToken_StopsTheStatistics()
        {
            var data = new VolumeData(Geometry, new byte[12]);
            Assert.That(() => data.Statistics(new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
        }
    }
}
