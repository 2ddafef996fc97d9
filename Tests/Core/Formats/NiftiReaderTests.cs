using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    public sealed class NiftiReaderTests
    {
        static IEnumerable<Array> VoxelArrays() => new Array[]
        {
            new sbyte[] { -128, 0, 1, 127 }, new byte[] { 0, 1, 254, 255 }, new short[] { -32768, -1, 258, 32767 }, new ushort[] { 0, 1, 258, 65535 },
            new[] { int.MinValue, -1, 66051, int.MaxValue }, new[] { 0u, 1u, 66051u, uint.MaxValue },
            new[] { long.MinValue, -1, 72623859790382856, long.MaxValue }, new[] { 0ul, 1ul, 72623859790382856ul, ulong.MaxValue },
            new[] { -1.5f, 0, float.Epsilon, float.MaxValue }, new[] { -1.5, 0, double.Epsilon, double.MaxValue },
        };

        [Test]
        public void EveryTypeInBothByteOrders_PlainOrGzipped_IsReadAsItIs(
            [ValueSource(nameof(VoxelArrays))] Array voxels, [Values(false, true)] bool bigEndian, [Values(false, true)] bool gzip)
        {
            byte[] file = new NiftiFile(2, 1, 2, voxels) { BigEndian = bigEndian }.ToBytes();
            VolumeData data = Read(gzip ? VoxelBytes.Gzip(file) : file);
            Assert.That(data.Voxels.GetType(), Is.EqualTo(voxels.GetType()));
            Assert.That(data.Voxels, Is.EqualTo(voxels));
            Assert.That(data.Warnings, Is.Empty);
            Assert.That(data.Format, Is.EqualTo("NIfTI-1"));
        }

        [TestCase(128, 3)]
        [TestCase(2304, 4)]
        public void Colours_AreComponentsSideBySide_AndNeverScaled(short datatype, int components)
        {
            byte[] voxels = Enumerable.Range(0, 2 * components).Select(n => (byte)n).ToArray();
            VolumeData data = Read(new NiftiFile(2, 1, 1, voxels) { Datatype = datatype, Slope = 2 }.ToBytes());
            Assert.That(data.Components, Is.EqualTo(components));
            Assert.That(data.ComponentOrder, Is.EqualTo(ComponentOrder.Fastest));
            Assert.That(data.Value(1, 0, 0, 1), Is.EqualTo(components + 1));
        }

        [Test]
        public void Vectors_OfTheFifthDimension_AreComponentsBehindEachOther()
        {
            var file = new NiftiFile(2, 1, 1, new short[] { 1, 2, 3, 4, 5, 6 }) { Dim = new short[] { 5, 2, 1, 1, 1, 3, 1, 1 } };
            VolumeData data = Read(file.ToBytes());
            Assert.That(data.Components, Is.EqualTo(3));
            Assert.That(data.Value(1, 0, 0, 2), Is.EqualTo(6));
        }

        [Test]
        public void FlatImage_HasOneSlice()
        {
            var file = new NiftiFile(2, 2, 0, new byte[] { 1, 2, 3, 4 }) { Dim = new short[] { 2, 2, 2, 0, 0, 0, 0, 0 } };
            Assert.That(Read(file.ToBytes()).Geometry.SizeK, Is.EqualTo(1));
        }

        [TestCase(1, 1000)]
        [TestCase(2, 1)]
        [TestCase(3, 0.001)]
        [TestCase(0, 1)]
        [TestCase(10, 1)]
        public void Units_AreTurnedIntoMillimetres(byte units, double factor)
        {
            VolumeData data = Read(new NiftiFile(1, 1, 1, new byte[1]) { Units = units }.ToBytes());
            Assert.That(data.Geometry.SpacingMm.X, Is.EqualTo(factor).Within(1e-9));
        }

        [Test]
        public void QformAlone_PlacesTheVoxels()
        {
            // A quarter turn about S (quaternion (cos 45, 0, 0, sin 45)): i runs to anterior, j to the left.
            var file = new NiftiFile(2, 2, 2, new byte[8])
            {
                Sform = null, QformCode = 1, Quaternion = new[] { 0, 0, (float)Math.Sqrt(0.5), 5, 6, 7 }, Pixdim = new float[] { -1, 2, 3, 4, 1, 1, 1, 1 },
            };
            VolumeGeometry geometry = Read(file.ToBytes()).Geometry;
            Assert.That(geometry.OrientationCode, Is.EqualTo("ALI"));
            Assert.That(geometry.SpacingMm.X, Is.EqualTo(2).Within(1e-6));
            Assert.That(geometry.IjkToLps.Origin, Is.EqualTo(new PointMm(-5, -6, 7)));
        }

        [Test]
        public void WithoutOrientation_SpacingIsKept_AndAWarningSaysSo()
        {
            var file = new NiftiFile(2, 2, 2, new byte[8]) { Sform = null, Pixdim = new float[] { 1, 2, -3, 4, 1, 1, 1, 1 } };
            VolumeData data = Read(file.ToBytes());
            Assert.That(data.Geometry.SpacingMm, Is.EqualTo(new VectorMm(2, 3, 4)));
            Assert.That(data.Warnings, Has.Some.Contains("no orientation"));
        }

        [Test]
        public void SformAndQformThatDiffer_GiveAWarning()
        {
            var file = new NiftiFile(2, 2, 2, new byte[8]) { QformCode = 1, Quaternion = new float[] { 0, 0, 1, 0, 0, 0.5f } };
            Assert.That(Read(file.ToBytes()).Warnings, Has.Some.Contains("0.5 mm apart"));
        }

        [Test]
        public void Extensions_BeforeTheVoxels_AreSkipped()
        {
            VolumeData data = Read(VoxelBytes.Gzip(new NiftiFile(2, 1, 1, new byte[] { 8, 9 }) { VoxelOffset = 5000 }.ToBytes()));
            Assert.That(data.Voxels, Is.EqualTo(new byte[] { 8, 9 }));
        }

        [TestCase(float.NaN, 5f)]
        [TestCase(0f, 5f)]
        [TestCase(float.PositiveInfinity, 5f)]
        public void SlopeThatIsNoNumber_MeansNoScaling(float slope, float intercept)
        {
            VolumeData data = Read(new NiftiFile(1, 1, 1, new byte[] { 3 }) { Slope = slope, Intercept = intercept }.ToBytes());
            Assert.That(data.HasScaling, Is.False);
            Assert.That(data.Value(0), Is.EqualTo(3));
        }

        [Test]
        public void CompressedVoxels_LargerThanAnyFirstGuess_AreReadWhole()
        {
            // 50 MB: the array grows once on the way.
            var voxels = new short[25_000_000];
            for (int n = 0; n < voxels.Length; n += 1000)
                voxels[n] = (short)(n / 1000);
            byte[] file = VoxelBytes.Gzip(new NiftiFile(500, 500, 100, voxels).ToBytes());
            long before = GC.GetAllocatedBytesForCurrentThread();
            VolumeData data = Read(file);
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(1.6 * 50_000_000), "1.5 times the voxels, and a little");
            Assert.That(((short[])data.Voxels).AsSpan().SequenceEqual(voxels), Is.True);
        }

        [Test]
        public void CompressedFileThatClaimsMoreThanItHolds_IsRefusedBeforeMemoryIsTaken()
        {
            // Noise keeps the file large enough for its claim of 600 MB to be possible; 11 MB come out of it.
            var noise = new byte[1_000_000];
            new Random(3).NextBytes(noise);
            byte[] file = new NiftiFile(1, 1, 1, VoxelBytes.Join(noise, new byte[10_000_000])) { Dim = new short[] { 3, 1000, 1000, 600, 1, 1, 1, 1 } }.ToBytes();
            byte[] compressed = VoxelBytes.Gzip(file);
            long before = GC.GetAllocatedBytesForCurrentThread();
            var refusal = Assert.Throws<VolumeFormatException>(() => Read(compressed));
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(64L << 20));
            Assert.That(refusal.FoundValue, Does.Contain("11000000 bytes"));
        }

        [Test]
        public void ReadUnderACultureWithDecimalComma_GivesTheSame()
        {
            CultureInfo before = Thread.CurrentThread.CurrentCulture;
            try
            {
                Thread.CurrentThread.CurrentCulture = new CultureInfo("de-DE");
                VolumeData data = Read(new NiftiFile(2, 1, 1, new[] { 0.5f, 1.5f }) { Slope = 2.5f }.ToBytes());
                Assert.That(data.Value(1), Is.EqualTo(3.75));
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [Test]
        public void CancelledToken_StopsReading()
        {
            byte[] file = new NiftiFile(2, 1, 1, new byte[2]).ToBytes();
            Assert.That(() => NiftiReader.Read(new MemoryStream(file), "test", new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
        }

        [Test]
        public void Progress_RisesToOne()
        {
            var reports = new List<float>();
            byte[] file = new NiftiFile(200, 200, 100, new short[4_000_000]).ToBytes();
            NiftiReader.Read(new MemoryStream(file), "test", default, new Recorder(reports));
            Assert.That(reports, Is.Ordered);
            Assert.That(reports.Last(), Is.EqualTo(1f));
            Assert.That(reports, Has.Count.GreaterThan(3));
        }

        [Test]
        public void StreamThatCannotBePositioned_IsRefused()
        {
            using (var pipe = new System.IO.Compression.GZipStream(new MemoryStream(new byte[10]), System.IO.Compression.CompressionMode.Decompress))
                Assert.That(() => NiftiReader.Read(pipe, "test"), Throws.ArgumentException);
        }

        static VolumeData Read(byte[] file) => NiftiReader.Read(new MemoryStream(file), "test");

        sealed class Recorder : IProgress<float>
        {
            readonly List<float> reports;

            public Recorder(List<float> reports)
            {
                this.reports = reports;
            }

            public void Report(float value) => reports.Add(value);
        }
    }
}
