using System;
using System.Linq;
using System.Threading;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class IntensityVolumeTests
    {
        const int Seed = 77;

        [Test]
        public void WholeNumbersThatFit_AreKeptExactly()
        {
            var values = new short[] { -1024, 0, 3071, -1, 7, 7 };
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            Assert.That(volume.CodeScale, Is.EqualTo(1));
            Assert.That(volume.Codes.Select(volume.ValueOf), Is.EqualTo(values));
            Assert.That(volume.ValueMin, Is.EqualTo(-1024));
            Assert.That(volume.ValueMax, Is.EqualTo(3071));
        }

        [Test]
        public void WholeNumbersOfTheFullRange_AreKeptExactly()
        {
            var values = new[] { -32768f, 32767f, 0f };
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            Assert.That(volume.Codes.Select(volume.ValueOf), Is.EqualTo(values));
        }

        [TestCase(2.5, -10.25)]
        [TestCase(-0.5, 3)]
        public void ScaledIntegers_AreKeptExactly(double slope, double intercept)
        {
            var stored = new byte[] { 0, 1, 255, 100 };
            VolumeData data = Line(stored, slope, intercept);
            IntensityVolume volume = IntensityVolume.FromVolumeData(data);
            Assert.That(volume.CodeScale, Is.EqualTo(Math.Abs(slope)));
            for (int n = 0; n < stored.Length; n++)
                Assert.That(volume.ValueOf(volume.Codes[n]), Is.EqualTo(data.Value(n)).Within(1e-12));
        }

        [Test]
        public void OtherNumbers_AreRoundedToTheNearestOf65536Steps()
        {
            var random = new Random(Seed);
            double[] values = Enumerable.Range(0, 1000).Select(n => (random.NextDouble() * 3000) - 1000).ToArray();
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            double halfStep = (values.Max() - values.Min()) / 65535 / 2;
            for (int n = 0; n < values.Length; n++)
                Assert.That(volume.ValueOf(volume.Codes[n]), Is.EqualTo(values[n]).Within(halfStep * 1.0001), "seed " + Seed);
            Assert.That(volume.Codes.Max(), Is.EqualTo(ushort.MaxValue));
            Assert.That(volume.Codes.Min(), Is.EqualTo(0));
        }

        [Test]
        public void NanTakesTheMinimum_AndInfinitiesTheNearestFiniteValue()
        {
            var values = new[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity, 5f, 9f };
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            Assert.That(volume.Codes.Select(volume.ValueOf), Is.EqualTo(new[] { 5f, 9f, 5f, 5f, 9f }));
        }

        [Test]
        public void VolumeWithoutFiniteValues_IsZero()
        {
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(new[] { float.NaN, float.PositiveInfinity }));
            Assert.That(volume.Codes.Select(volume.ValueOf), Is.EqualTo(new[] { 0f, 0f }));
            Assert.That(volume.ValueMax, Is.EqualTo(0));
        }

        [TestCase(0.125)]
        [TestCase(-7.0)]
        public void ConstantVolume_KeepsItsValue(double value)
        {
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(new[] { value, value }));
            Assert.That(volume.Codes, Is.EqualTo(new ushort[] { 0, 0 }));
            Assert.That(volume.ValueOf(0), Is.EqualTo(value));
            Assert.That(volume.ValueMax, Is.EqualTo(value));
        }

        [Test]
        public void LargeIntegers_AreScaledToTheirRange()
        {
            var values = new[] { ulong.MinValue, ulong.MaxValue, ulong.MaxValue / 2 };
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            Assert.That(volume.Codes, Is.EqualTo(new ushort[] { 0, 65535, 32768 }).Within(1));
        }

        [Test]
        public void PaddingFarBelowAScan_LeavesTheScanItsSteps()
        {
            int[] values = Enumerable.Range(0, 2000).Select(n => n < 60 ? int.MinValue : n - 1000).ToArray();
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            Assert.That(volume.Codes.Skip(60).Select(volume.ValueOf), Is.EqualTo(values.Skip(60).Select(v => (double)v)).Within(1.0));
            Assert.That(volume.Codes.Take(60), Is.All.EqualTo(0), "padding is darker than all else");
            Assert.That(volume.Warnings, Has.Count.EqualTo(1));
            Assert.That(volume.Warnings[0], Does.StartWith("60 voxels"));
        }

        [Test]
        public void OutliersInABackgroundThatFillsMost_LeaveTheRestItsSteps()
        {
            float[] values = Enumerable.Range(0, 10000).Select(n => n < 9700 ? 0f : n % 100).ToArray();
            values[5] = 1e9f;
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            Assert.That(volume.ValueOf(volume.Codes[9950]), Is.EqualTo(50).Within(0.1));
            Assert.That(volume.ValueOf(volume.Codes[5]), Is.EqualTo(volume.ValueMax).Within(0.1));
            Assert.That(volume.Warnings[0], Does.StartWith("1 voxels"));
        }

        [Test]
        public void WholeNumbersWithOutliersThatFit_StayExact()
        {
            int[] values = Enumerable.Range(0, 2000).Select(n => n == 7 ? 65000 : n % 10).ToArray();
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            Assert.That(volume.Codes.Select(volume.ValueOf), Is.EqualTo(values.Select(v => (double)v)));
            Assert.That(volume.Warnings, Is.Empty);
        }

        [Test]
        public void ValuesThatSpanMoreThanDoublesHold_AreRefused()
        {
            VolumeData data = Line(new[] { -double.MaxValue, double.MaxValue });
            Assert.That(() => IntensityVolume.FromVolumeData(data), Throws.TypeOf<AnatomyCarveException>());
        }

        [TestCase(ComponentOrder.Fastest)]
        [TestCase(ComponentOrder.Slowest)]
        public void Component_IsTakenFromItsPlace(ComponentOrder order)
        {
            byte[] values = order == ComponentOrder.Fastest ? new byte[] { 1, 10, 2, 20, 3, 30 } : new byte[] { 1, 2, 3, 10, 20, 30 };
            var data = new VolumeData(new VolumeGeometry(3, 1, 1, Affine.Identity), values, 2, order);
            IntensityVolume volume = IntensityVolume.FromVolumeData(data, 1);
            Assert.That(volume.Codes.Select(volume.ValueOf), Is.EqualTo(new[] { 10, 20, 30 }));
            Assert.That(() => IntensityVolume.FromVolumeData(data, 2), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        [Test]
        public void LongVolume_IsWalkedThroughInBlocksToItsEnd()
        {
            int[] values = Enumerable.Range(0, 100003).Select(n => n % 50021).ToArray();
            IntensityVolume volume = IntensityVolume.FromVolumeData(Line(values));
            Assert.That(volume.Codes.Select(code => (int)code), Is.EqualTo(values));
        }

        [Test]
        public void CancelledToken_StopsTheWork()
        {
            using (var source = new CancellationTokenSource())
            {
                source.Cancel();
                VolumeData data = Line(new byte[10]);
                Assert.That(() => IntensityVolume.FromVolumeData(data, 0, source.Token), Throws.InstanceOf<OperationCanceledException>());
            }
        }

        static VolumeData Line(Array values, double slope = 1, double intercept = 0) =>
            new VolumeData(new VolumeGeometry(values.Length, 1, 1, Affine.Identity), values, 1, ComponentOrder.Fastest, slope, intercept);
    }
}
