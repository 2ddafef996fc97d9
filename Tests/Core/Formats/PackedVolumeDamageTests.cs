using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    /// <summary>
    /// The law: damaged bytes are refused by the package's own exception. Where somebody makes the checksums fit, the result is a refusal or a volume, and
    /// no memory is taken on the bytes' word.
    /// </summary>
    public sealed class PackedVolumeDamageTests
    {
        const string Name = "damaged";

        const int VersionPlace = 8, HeaderLengthPlace = 12, FileLengthPlace = 16, SizesPlace = 24;

        const int Rounds = 3000;

        static byte[] Small() => PackedVolume.Write(SampleVolumes.Scan(11, 7, 5, 6, 1));

        [Test]
        public void EveryByte_Changed_IsRefused([Values(0x01, 0x80, 0xFF)] int change)
        {
            byte[] packed = Small();
            for (int place = 0; place < packed.Length; place++)
            {
                byte[] damaged = (byte[])packed.Clone();
                damaged[place] ^= (byte)change;
                Assert.That(() => PackedVolume.Read(damaged, Name), Throws.TypeOf<VolumeFormatException>().With.Property("File").EqualTo(Name), "byte " + place);
            }
        }

        [Test]
        public void AnyLength_CutOff_IsRefused()
        {
            byte[] packed = Small();
            for (int length = 0; length < packed.Length; length++)
            {
                byte[] cut = VoxelBytes.Part(packed, 0, length);
                Assert.That(() => PackedVolume.Read(cut, Name), Throws.TypeOf<VolumeFormatException>(), "cut after " + length);
                Assert.That(() => PackedVolume.ReadInfo(cut, Name), Throws.TypeOf<VolumeFormatException>(), "cut after " + length);
            }

            Assert.That(() => PackedVolume.Read(VoxelBytes.Join(packed, new byte[1]), Name), Throws.TypeOf<VolumeFormatException>());
        }

        [Test]
        public void Header_Changed_IsRefusedByReadInfoToo()
        {
            byte[] packed = Small();
            int headerBytes = PackedVolume.ReadInfo(packed, Name).HeaderBytes;
            for (int place = 0; place < headerBytes; place++)
            {
                byte[] damaged = (byte[])packed.Clone();
                damaged[place] ^= 0x10;
                Assert.That(() => PackedVolume.ReadInfo(damaged, Name), Throws.TypeOf<VolumeFormatException>(), "byte " + place);
            }
        }

        [Test]
        public void HeaderBytes_ChangedWithTheirChecksum_AreReadOrRefused_WithoutMuchMemory([Range(1, 8)] int seed)
        {
            byte[] packed = Small();
            int headerBytes = PackedVolume.ReadInfo(packed, Name).HeaderBytes;
            Forge(packed, seed, damaged => PackedBytes.SealHeader(damaged), SizesPlace, headerBytes - 8);
        }

        [Test]
        public void BlockBytes_ChangedWithTheirChecksums_AreReadOrRefused_WithoutMuchMemory([Range(1, 8)] int seed)
        {
            byte[] packed = Small();
            int headerBytes = PackedVolume.ReadInfo(packed, Name).HeaderBytes;
            Forge(packed, seed, damaged => PackedBytes.SealBlocks(damaged), headerBytes, packed.Length);
        }

        [TestCase(int.MaxValue, 1, 1)]
        [TestCase(2048, 2048, 2048)]
        [TestCase(100000, 100000, 100000)]
        [TestCase(1000, 1000, 1000)]
        [TestCase(0, 1, 1)]
        [TestCase(-1, -1, 1)]
        [TestCase(512, 512, 1)]
        public void Sizes_ThatTheBytesCannotHold_AreRefusedBeforeMemoryIsTaken(int sizeI, int sizeJ, int sizeK)
        {
            byte[] forged = Small();
            BitConverter.GetBytes(sizeI).CopyTo(forged, SizesPlace);
            BitConverter.GetBytes(sizeJ).CopyTo(forged, SizesPlace + 4);
            BitConverter.GetBytes(sizeK).CopyTo(forged, SizesPlace + 8);
            PackedBytes.SealHeader(forged);
            long before = GC.GetAllocatedBytesForCurrentThread();
            Assert.That(() => PackedVolume.Read(forged, Name), Throws.TypeOf<VolumeFormatException>());
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(1 << 20));
        }

        [TestCase(0)]
        [TestCase(2)]
        [TestCase(257)]
        [TestCase(-1)]
        public void Version_ThatIsNotKnown_IsRefusedWithASentence(int version)
        {
            byte[] packed = Small();
            BitConverter.GetBytes(version).CopyTo(packed, VersionPlace);
            var refusal = Assert.Throws<VolumeFormatException>(() => PackedVolume.ReadInfo(packed, Name));
            Assert.That(refusal.Message, Is.EqualTo(
                "damaged: the version is " + version + "; expected 1: another version of AnatomyCarve packed it; pack the scan again."));
        }

        [Test]
        public void OtherContent_IsRefusedBySayingWhatItStartsWith()
        {
            byte[] nifti = new NiftiFile(1, 1, 1, new byte[] { 4 }).ToBytes();
            Assert.That(() => PackedVolume.Read(nifti, Name), Throws.TypeOf<VolumeFormatException>().With.Message.Contains("expected \"ACVOLUME\""));
            Assert.That(() => PackedVolume.Read(default, Name), Throws.TypeOf<VolumeFormatException>());
        }

        [TestCase(HeaderLengthPlace, 0)]
        [TestCase(HeaderLengthPlace, 24)]
        [TestCase(HeaderLengthPlace, 40)]
        [TestCase(HeaderLengthPlace, int.MaxValue)]
        [TestCase(HeaderLengthPlace, -5)]
        [TestCase(FileLengthPlace, 24)]
        public void Lengths_ThatDoNotFit_AreRefused(int place, int length)
        {
            byte[] packed = Small();
            BitConverter.GetBytes(length).CopyTo(packed, place);
            Assert.That(() => PackedVolume.Read(packed, Name), Throws.TypeOf<VolumeFormatException>().With.Message.Contains("length").Or.Message.Contains("checksum"));
        }

        [Test]
        public void Refusal_NamesTheBlock()
        {
            byte[] packed = PackedVolume.Write(SampleVolumes.Scan(97, 89, 61, 9, 1));
            PackedVolumeInfo info = PackedVolume.ReadInfo(packed, Name);
            packed[packed.Length - 1] ^= 1;
            var refusal = Assert.Throws<VolumeFormatException>(() => PackedVolume.Read(packed, Name));
            long blocks = (info.Geometry.VoxelCount + 131071) / 131072;
            Assert.That(refusal.Message, Is.EqualTo(
                FormattableString.Invariant($"damaged: block {blocks - 1} of the labels is damaged; expected bytes that agree with their checksum.")));
        }

        [Test]
        public void Refusal_OnAnyThread_IsThePackagesOwn([Values(1, 2, 4)] int threads)
        {
            byte[] packed = PackedVolume.Write(SampleVolumes.Scan(97, 89, 61, 9, 1));
            int headerBytes = PackedVolume.ReadInfo(packed, Name).HeaderBytes;
            for (int place = headerBytes; place < packed.Length; place++)
                packed[place] ^= 1;
            Assert.That(() => PackedVolume.Read(packed, Name, threads), Throws.TypeOf<VolumeFormatException>());
        }

        /// <summary>Changes a few bytes, makes the checksums fit, and reads.</summary>
        static void Forge(byte[] packed, int seed, Action<byte[]> seal, int first, int end)
        {
            var random = new Random(seed);
            int read = 0;
            for (int round = 0; round < Rounds; round++)
            {
                var forged = (byte[])packed.Clone();
                for (int change = random.Next(1, 4); change > 0; change--)
                    forged[random.Next(first, end)] = (byte)(random.Next(4) == 0 ? 255 : random.Next(256));
                seal(forged);
                long before = GC.GetAllocatedBytesForCurrentThread();
                try
                {
                    SegmentedVolume volume = PackedVolume.Read(forged, Name);
                    Assert.That(volume.Labels.Indices.All(index => index < volume.Segments.Count));
                    read++;
                }
                catch (VolumeFormatException)
                {
                    // Refused, as it may be.
                }
                catch (Exception problem) when (!(problem is AssertionException))
                {
                    Assert.Fail("seed " + seed + ", round " + round + ": " + problem);
                }

                Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(4 << 20), "seed " + seed + ", round " + round);
            }

            Assert.That(read, Is.GreaterThan(0).And.LessThan(Rounds), "some damage is harmless, some is not");
        }
    }
}
