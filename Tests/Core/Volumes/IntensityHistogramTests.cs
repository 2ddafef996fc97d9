using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class IntensityHistogramTests
    {
        [Test]
        public void EveryVoxel_IsCountedInTheBinOfItsValue([Values(1, 2, 3, 255, 256, 257, 65536)] int bins, [Values(1, 254, 255, 256, 4095, 65535)] int largest)
        {
            IntensityVolume volume = SampleVolumes.Of(40, 30, 20, voxel => voxel == 7 ? largest : voxel * 31 % (largest + 1), _ => 0, 1).Intensity;
            IntensityHistogram histogram = IntensityHistogram.Of(volume, bins);
            var expected = new long[histogram.BinCount];
            foreach (ushort code in volume.Codes)
                expected[histogram.BinOf(volume.ValueOf(code))]++;
            Assert.That(histogram.Counts, Is.EqualTo(expected));
            Assert.That(histogram.Total, Is.EqualTo(volume.Codes.Length));
            Assert.That(histogram.BinCount, Is.LessThanOrEqualTo(bins));
            Assert.That(histogram.MaxCount, Is.EqualTo(expected.Max()));
        }

        [TestCase(255, 256)]
        [TestCase(299, 150)]
        [TestCase(4095, 256)]
        public void Bins_AreWholeNumbersOfCodes_SoThatAnEvenScanGivesAnEvenHistogram(int largest, int expectedBins)
        {
            int codes = largest + 1;
            IntensityVolume volume = SampleVolumes.Of(codes, 3, 1, voxel => voxel % codes, _ => 0, 1).Intensity;
            IntensityHistogram histogram = IntensityHistogram.Of(volume);
            Assert.That(histogram.BinCount, Is.EqualTo(expectedBins));
            Assert.That(histogram.Counts.Distinct().Count(), Is.EqualTo(1));
        }

        [Test]
        public void Values_OutsideOfTheRange_CountToTheEnds()
        {
            var histogram = new IntensityHistogram(-10, 29, 10, new long[] { 1, 2, 3, 4 });
            Assert.That(new[] { -11, -10, -0.001, 0, 29, 30, 1e300 }.Select(histogram.BinOf), Is.EqualTo(new[] { 0, 0, 0, 1, 3, 3, 3 }));
            Assert.That(new[] { double.NaN, double.NegativeInfinity, double.PositiveInfinity }.Select(histogram.BinOf), Is.EqualTo(new[] { 0, 0, 3 }));
            Assert.That(Enumerable.Range(0, 5).Select(histogram.StartOf), Is.EqualTo(new[] { -10, 0, 10, 20, 30 }));
            Assert.That(() => histogram.StartOf(5), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        [TestCase(new long[] { 5, 900, 40, 7, 30, 12 }, 30)]
        [TestCase(new long[] { 3, 8, 2, 1, 20, 500, 100, 100, 20 }, 8)]
        [TestCase(new long[] { 0, 0, 77, 0 }, 77)]
        [TestCase(new long[] { 9 }, 9)]
        [TestCase(new long[] { 1, 2, 3, 4 }, 4)]
        public void MaxCountBesideBackground_LeavesTheHighestPeakOut(long[] counts, long expected) =>
            Assert.That(new IntensityHistogram(0, 10, 3, counts).MaxCountBesideBackground, Is.EqualTo(expected));

        [Test]
        public void OneValue_IsOneBin()
        {
            IntensityHistogram histogram = IntensityHistogram.Of(SampleVolumes.Of(2, 2, 2, _ => 0, _ => 0, 1).Intensity);
            Assert.That(histogram.Counts, Is.EqualTo(new[] { 8 }));
            Assert.That(new[] { histogram.ValueMin, histogram.BinWidth }, Is.EqualTo(new[] { -1024.0, 1 }));
        }

        [Test]
        public void NumbersThatMakeNoHistogram_AreRefused()
        {
            var counts = new long[] { 1 };
            Assert.That(() => new IntensityHistogram(double.NaN, 1, 1, counts), Throws.ArgumentException);
            Assert.That(() => new IntensityHistogram(1, 0, 1, counts), Throws.ArgumentException);
            Assert.That(() => new IntensityHistogram(0, 1, 0, counts), Throws.ArgumentException);
            Assert.That(() => new IntensityHistogram(0, 1, double.PositiveInfinity, counts), Throws.ArgumentException);
            Assert.That(() => new IntensityHistogram(0, 1, 1, new long[0]), Throws.ArgumentException);
            Assert.That(() => new IntensityHistogram(0, 1, 1, new long[] { -1 }), Throws.ArgumentException);
            Assert.That(() => new IntensityHistogram(0, 1, 1, null), Throws.ArgumentNullException);
            Assert.That(() => IntensityHistogram.Of(null), Throws.ArgumentNullException);
            IntensityVolume volume = SampleVolumes.Of(1, 1, 1, _ => 0, _ => 0, 1).Intensity;
            Assert.That(() => IntensityHistogram.Of(volume, 0), Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => IntensityHistogram.Of(volume, 65537), Throws.TypeOf<ArgumentOutOfRangeException>());
        }

        [Test]
        public void Counts_AreNotTheCallersArray()
        {
            var counts = new long[] { 1, 2 };
            var histogram = new IntensityHistogram(0, 1, 1, counts);
            counts[0] = 100;
            Assert.That(histogram.Counts, Is.EqualTo(new[] { 1, 2 }));
        }

        [Test]
        public void Volume_AskedTwice_GivesTheSameObject()
        {
            SegmentedVolume volume = SampleVolumes.Scan(5, 5, 5, 3, 1);
            IntensityHistogram first = volume.Histogram;
            Assert.That(volume.Histogram, Is.SameAs(first));
            SegmentedVolumeAssert.AreSame(volume.Histogram, IntensityHistogram.Of(volume.Intensity));
        }

        [Test]
        public void VoxelCounts_AskedTwice_AreTheSameObject_AndCountVoxelsIsACopy()
        {
            LabelMap labels = SampleVolumes.Of(4, 3, 2, _ => 0, voxel => voxel % 4, 6).Labels;
            Assert.That(labels.VoxelCounts, Is.EqualTo(new[] { 6, 6, 6, 6, 0, 0 }));
            IReadOnlyList<long> first = labels.VoxelCounts;
            Assert.That(labels.VoxelCounts, Is.SameAs(first));
            labels.CountVoxels()[0] = 100;
            Assert.That(labels.CountVoxels(), Is.EqualTo(first));
        }
    }
}
