using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.Carving;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    /// <summary>The law: what is packed and unpacked is the volume that it was, bit by bit, whatever it holds.</summary>
    public sealed class PackedVolumeTests
    {
        const string Name = "a volume";

        [Test]
        public void RoundTrip_OfRandomVolumes_ChangesNothing([Range(1, 60)] int seed)
        {
            var random = new RandomScenes(seed);
            VolumeGeometry geometry = random.Geometry(17);
            int segments = random.Between(1, 300);
            int noise = 1 << random.Between(0, 16);
            int run = random.Between(1, 40);
            int code = 0, index = 0;
            CheckRoundTrip(SampleVolumes.Of(
                geometry,
                voxel => code = random.Chance(1.0 / run) ? random.Next(65536) : (ushort)(code + random.Next(noise)),
                voxel => index = random.Chance(1.0 / run) ? random.Next(segments) : index,
                segments));
        }

        [Test]
        public void RoundTrip_OfEverySizeOfALine_ChangesNothing([Values(0, 1, 2)] int axis)
        {
            for (int size = 1; size <= 40; size++)
            {
                int length = size * size;
                CheckRoundTrip(SampleVolumes.Scan(axis == 0 ? length : 1, axis == 1 ? length : 1, axis == 2 ? length : 1, 5, size));
            }
        }

        [TestCase(1, 1, 1)]
        [TestCase(255, 1, 1)]
        [TestCase(257, 3, 2)]
        [TestCase(131072, 1, 1)]
        [TestCase(131073, 1, 1)]
        [TestCase(512, 256, 3)]
        [TestCase(200000, 2, 1)]
        [TestCase(1, 1, 300000)]
        [TestCase(97, 89, 61)]
        public void RoundTrip_AtTheEdgesOfTilesAndBlocks_ChangesNothing(int sizeI, int sizeJ, int sizeK) =>
            CheckRoundTrip(SampleVolumes.Scan(sizeI, sizeJ, sizeK, 9, sizeI + sizeK));

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(65535)]
        public void RoundTrip_OfOneValue_ChangesNothingAndTakesNextToNothing(int code)
        {
            SegmentedVolume volume = SampleVolumes.Of(160, 160, 160, _ => code, _ => 2, 3);
            byte[] packed = CheckRoundTrip(volume);
            Assert.That(packed.Length, Is.LessThan(2000), "bytes of " + volume.Geometry.VoxelCount + " voxels");
        }

        [Test]
        public void RoundTrip_OfNoise_ChangesNothingAndTakesLittleMoreThanTheVoxels()
        {
            var random = new Random(3);
            SegmentedVolume volume = SampleVolumes.Of(64, 64, 64, _ => random.Next(65536), _ => random.Next(65535), 65535);
            CheckRoundTrip(volume);
            PackedVolumeInfo info = PackedVolume.ReadInfo(PackedVolume.Write(volume), Name);
            Assert.That(info.IntensityBytes + info.LabelBytes, Is.LessThan(1.02 * info.UnpackedBytes));
        }

        [Test]
        public void RoundTrip_OfEveryWidthOfDifferences_ChangesNothing([Range(0, 16)] int bits, [Values(1, 2, 3)] int seed)
        {
            var random = new Random(seed);
            int span = 1 << bits;
            CheckRoundTrip(SampleVolumes.Of(23, 29, 5, _ => (ushort)(20000 + random.Next(span)), _ => random.Next(Math.Min(span, 65535)), Math.Min(span, 65535)));
        }

        [Test]
        public void RoundTrip_OfTheSteepestSteps_ChangesNothing()
        {
            int[] steps = { 0, 65535, 32767, 32768, 1, 16384, 49151, 65534 };
            CheckRoundTrip(SampleVolumes.Of(8, 9, 40, voxel => steps[voxel * voxel % 8], _ => 0, 1));
        }

        [Test]
        public void RoundTrip_OfRunsThatRepeatRowsAndSlices_ChangesNothing()
        {
            CheckRoundTrip(SampleVolumes.Of(130, 70, 20, voxel => voxel % 130 / 9, voxel => voxel / 130 % 70 / 5, 14));
            CheckRoundTrip(SampleVolumes.Of(1, 70, 200, voxel => voxel / 31 % 3, voxel => voxel / 70 % 5, 5));
        }

        [Test]
        public void RoundTrip_OfALabelMapOnAnotherGridByARounding_KeepsBothGrids()
        {
            var place = new PointMm(-0.0, 12.3, 1e-300);
            var grid = new VolumeGeometry(2, 3, 4, Affine.FromColumns(new VectorMm(0.7, 0, -0.0), new VectorMm(0, 0.7, 0), new VectorMm(0.1, 0, 3), place));
            var other = new VolumeGeometry(2, 3, 4, Affine.FromColumns(new VectorMm(0.7000001, 0, 0), new VectorMm(0, 0.7, 0), new VectorMm(0.1, 0, 3), place));
            var volume = new SegmentedVolume(
                new IntensityVolume(grid, new ushort[24], 0.1, 1 / 3.0, 0.1), new LabelMap(other, new ushort[24], SegmentTable.UnlabelledOnly()));
            CheckRoundTrip(volume);
        }

        [Test]
        public void RoundTrip_OfNamesAndWarnings_KeepsEveryLetter()
        {
            string[] names = { "Unlabelled", "", "Großhirn links", "脳", "\U0001F9E0", "\uD800 alone", new string('x', 5000), "a\0b\n" };
            long[] labels = { 0, long.MinValue, -5, 1, 2, 700, 1L << 53, long.MaxValue };
            var table = new SegmentTable(names.Select((name, n) => new Segment(n, labels[n], name, new SegmentColor(1, 2, (byte)n), n / 7f)));
            var geometry = new VolumeGeometry(2, 2, 2, Affine.Identity);
            CheckRoundTrip(new SegmentedVolume(
                new IntensityVolume(geometry, new ushort[] { 0, 1, 2, 3, 4, 5, 6, 7 }, -1e9, 1e-3, 1e12, new[] { "Ä", "" }),
                new LabelMap(geometry, new ushort[] { 7, 6, 5, 4, 3, 2, 1, 0 }, table, new[] { "ß\u0301" }),
                new[] { "scan.nii: wörtlich" }));
        }

        [Test]
        public void Bytes_DependOnTheVolumeAlone()
        {
            byte[] first = PackedVolume.Write(SampleVolumes.Scan(97, 89, 61, 9, 1));
            byte[] again = PackedVolume.Write(SampleVolumes.Scan(97, 89, 61, 9, 1));
            Assert.That(first.AsSpan().SequenceEqual(again));
            byte[] repacked = PackedVolume.Write(PackedVolume.Read(first, Name));
            Assert.That(first.AsSpan().SequenceEqual(repacked), "packed again after unpacking");
        }

        [TestCase("de-DE")]
        [TestCase("ar-SA")]
        [TestCase("tr-TR")]
        public void Bytes_DoNotDependOnTheCulture(string culture)
        {
            SegmentedVolume volume = SampleVolumes.Scan(9, 8, 7, 5, 1);
            byte[] expected = PackedVolume.Write(volume);
            CultureInfo before = CultureInfo.CurrentCulture;
            CultureInfo.CurrentCulture = CultureInfo.GetCultureInfo(culture);
            try
            {
                Assert.That(PackedVolume.Write(volume), Is.EqualTo(expected));
                CheckRoundTrip(volume);
                byte[] other = (byte[])expected.Clone();
                other[8] = 77;
                Assert.That(() => PackedVolume.Read(other, Name), Throws.TypeOf<VolumeFormatException>().With.Message.Contains("the version is 77; expected 1"));
            }
            finally
            {
                CultureInfo.CurrentCulture = before;
            }
        }

        [Test]
        public void WhatWouldBeComputed_IsTakenFromTheBytes()
        {
            SegmentedVolume volume = SampleVolumes.Scan(20, 20, 20, 4, 1);
            byte[] packed = PackedVolume.Write(volume);
            SegmentedVolume read = PackedVolume.Read(packed, Name);

            // Whoever changes the arrays afterwards, against their documentation, would see it in anything that is computed now.
            Array.Clear(read.Intensity.Codes, 0, read.Intensity.Codes.Length);
            Array.Clear(read.Labels.Indices, 0, read.Labels.Indices.Length);
            SegmentedVolumeAssert.AreSame(read.Histogram, volume.Histogram);
            Assert.That(read.AutomaticTransferFunction.Points, Is.EqualTo(volume.AutomaticTransferFunction.Points));
            Assert.That(read.Labels.VoxelCounts, Is.EqualTo(volume.Labels.VoxelCounts));
        }

        [Test]
        public void Info_SaysWhatTheVolumeIs()
        {
            var geometry = new VolumeGeometry(30, 20, 10, Orientations.Grid("RAS", new VectorMm(0.5, 0.75, 3), new PointMm(1, 2, 3)));
            SegmentedVolume volume = SampleVolumes.Of(geometry, voxel => voxel % 9, voxel => voxel % 4, 4);
            byte[] packed = PackedVolume.Write(volume);
            PackedVolumeInfo info = PackedVolume.ReadInfo(packed, Name);
            Assert.That(new[] { info.SizeI, info.SizeJ, info.SizeK }, Is.EqualTo(new[] { 30, 20, 10 }));
            Assert.That(info.SpacingMm, Is.EqualTo(geometry.SpacingMm));
            Assert.That(info.OrientationCode, Is.EqualTo("RAS"));
            Assert.That(info.Geometry.IjkToLps, Is.EqualTo(geometry.IjkToLps));
            Assert.That(new[] { info.ValueMin, info.ValueMax }, Is.EqualTo(new[] { volume.Intensity.ValueMin, volume.Intensity.ValueMax }));
            Assert.That(info.SegmentCount, Is.EqualTo(4));
            Assert.That(info.Version, Is.EqualTo(1));
            Assert.That(info.PackedBytes, Is.EqualTo(packed.Length));
            Assert.That(info.HeaderBytes + info.IntensityBytes + info.LabelBytes, Is.EqualTo(packed.Length));
            Assert.That(info.UnpackedBytes, Is.EqualTo(30 * 20 * 10 * 4));
            Assert.That(PackedVolume.IsPacked(packed) && !PackedVolume.IsPacked(new byte[] { 1, 2, 3 }) && !PackedVolume.IsPacked(new byte[20]));
        }

        [Test]
        public void Threads_OfAnyNumber_GiveTheSameVolume([Values(1, 2, 3, 16)] int threads)
        {
            SegmentedVolume volume = SampleVolumes.Scan(97, 89, 61, 9, 1);
            SegmentedVolumeAssert.AreSame(PackedVolume.Read(PackedVolume.Write(volume), Name, threads), volume);
        }

        [Test]
        public void Threads_FewerThanOne_AreRefused() =>
            Assert.That(() => PackedVolume.Read(new byte[9], Name, 0), Throws.TypeOf<ArgumentOutOfRangeException>());

        [Test]
        public void Volume_Missing_IsRefused() => Assert.That(() => PackedVolume.Write(null), Throws.ArgumentNullException);

        [Test]
        public void Memory_InsideAnotherArray_IsReadFromItsPlace()
        {
            SegmentedVolume volume = SampleVolumes.Scan(9, 8, 7, 5, 1);
            byte[] packed = PackedVolume.Write(volume);
            byte[] around = VoxelBytes.Join(new byte[13], packed, new byte[5]);
            SegmentedVolumeAssert.AreSame(PackedVolume.Read(around.AsMemory(13, packed.Length), Name), volume);
        }

        [Test]
        public void Progress_Ascends_AndEndsAtOne([Values(1, 2)] int threads)
        {
            SegmentedVolume volume = SampleVolumes.Scan(97, 89, 61, 9, 1);
            var told = new Recorder();
            byte[] packed = PackedVolume.Write(volume, default, told);
            told.Check();
            told = new Recorder();
            PackedVolume.Read(packed, Name, threads, default, told);
            told.Check();
        }

        [Test]
        public void Cancellation_BeforeAndMeanwhile_EndsTheWork([Values(1, 2)] int threads)
        {
            SegmentedVolume volume = SampleVolumes.Scan(97, 89, 61, 9, 1);
            byte[] packed = PackedVolume.Write(volume);
            var cancelled = new CancellationToken(true);
            Assert.That(() => PackedVolume.Write(volume, cancelled), Throws.InstanceOf<OperationCanceledException>());
            Assert.That(() => PackedVolume.Read(packed, Name, threads, cancelled), Throws.InstanceOf<OperationCanceledException>());
            using (var source = new CancellationTokenSource())
                Assert.That(() => PackedVolume.Write(volume, source.Token, new Canceller(source)), Throws.InstanceOf<OperationCanceledException>());
            using (var source = new CancellationTokenSource())
                Assert.That(() => PackedVolume.Read(packed, Name, threads, source.Token, new Canceller(source)), Throws.InstanceOf<OperationCanceledException>());
        }

        static byte[] CheckRoundTrip(SegmentedVolume volume)
        {
            byte[] packed = PackedVolume.Write(volume);
            SegmentedVolumeAssert.AreSame(PackedVolume.Read(packed, Name), volume);
            return packed;
        }

        sealed class Recorder : IProgress<float>
        {
            readonly List<float> values = new List<float>();
            readonly Thread thread = Thread.CurrentThread;

            public void Report(float value)
            {
                Assert.That(Thread.CurrentThread, Is.SameAs(thread));
                values.Add(value);
            }

            public void Check()
            {
                Assert.That(values, Is.Ordered.Ascending);
                Assert.That(values.Count, Is.GreaterThan(1));
                Assert.That(values[0], Is.GreaterThanOrEqualTo(0));
                Assert.That(values.Last(), Is.EqualTo(1));
            }
        }

        sealed class Canceller : IProgress<float>
        {
            readonly CancellationTokenSource source;

            public Canceller(CancellationTokenSource source) => this.source = source;

            public void Report(float value) => source.Cancel();
        }
    }
}
