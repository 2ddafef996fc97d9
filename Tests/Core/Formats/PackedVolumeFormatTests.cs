using System;
using System.Linq;
using System.Text;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    /// <summary>Version 1 is what it is: files that were packed once have to be read by every later version, or be refused.</summary>
    public sealed class PackedVolumeFormatTests
    {
        /// <summary>The volume of <see cref="Reference"/> as version 1 packs it.</summary>
        static readonly string[] ReferenceBytes =
        {
            "QUNWT0xVTUUBAAAAXwIAAIMHAAAAAAAAFAAAAA0AAAAGAAAAAAAAAAAA4L8AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADgP5qZmZmZmbk/AAAAAAAAAAAAAAAAAAAA",
            "AAAAAAAAAABAAAAAAAAAJEAAAAAAAAA0wAAAAAAAAD5AAAAAAAAAQI/AAAAAAAAA4D8AAAAA4AXfQAMAAADzBAAAAAAAADEAAAAAAAAAAgAAAAAA4HXAAAAAAAAAAAAAAAAA",
            "AMBiwAAAAAAAAPA/AAAAAABAj8AAAAAAAObeQAAAAAAA4F9AgAICBrUEd9kBkgMBAQIBAAEBAQEBAQEBAQEAAQIBAQEBAQEBAQEBAQEBAQEBAQEAAQEBAgEBAQEBAQABAQEB",
            "AQECAQEBAAEBAQECAQEBAQABAQEBAQEBAQIBAAEBAQEBAQIBAQEAAQEBAQEBAQEBAQEBAQEBAQEBAQEAAQEBAgEBAQEBAQABAgEBAQEBAQEBAAEBAQECAQEBAQABAQECAQEB",
            "AQIBAAEBAQEBAQIBAQEAAQEBAQEBAQEBAAIBAQEBAQEBAgEAAQEBAQEBAQEBAQABAgEBAQEBAQEBAAEBAQECAQEBAQABAQECAQEBAQEBAAEBAQEBAQIBAQEAAQEBAQIBAQEB",
            "AApVbmxhYmVsbGVkAQIDAACAP84CDQ1IaXBwb2NhbXB1c19M+gCAAACAPvEH2AQIR3Jv3wFoaXJuCQgHAAAAANkBAQtzY2FuLm5paTogYQEBYQAA8wksJH3bfnBkOAExSxnQ",
            "r7BmYCtGNZmDRvBVxQD//////////wCANx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43",
            "HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43Hjce",
            "Nx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43",
            "HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43Hjce",
            "Nx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43",
            "HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceNx43HjceBP8AAAAAAAAAiEvM4czhzOHC4czhzOHM4czhzOHM4czhzOHM4czhzOHM4czhzOHM4UQWAIAAgACAAIAA",
            "gACAAIAAgACAAIAAgAFVVVVVVVVVVVxrPjONMNI8udZ8ZhphpHlyrfnMNMJI8+Ra85lphJHmybXmM9MII82Ta81nphFGmifXms9MI4w0T641n5lGGGmeXGs+M40w0jy51nxm",
            "GmGkeXKt+cw0wkjz5FrzmWmEkebJteYz0wgjzZNrzWemEUaaJ9eaz0wjjDRPrjWfmUYYaZ5caz4zjTDSPLnWfGYaYaR5cq35zDTCSPPkWvOZaYQCVVVVVVVVVVWPnUaMIe2w",
            "Bx87jRhD2mEPPnYaMYa0wx587DRiDGmHPfjYacQY0g578LHTiDGkHfbgY6cRY0g77MHHTiPGkHbYg4+dRowh7bAHHzuNGEPaYQ8+dhoxhrTDHnzsNGIMaYc9+NhpxBjSDnvw",
            "sdOIMaQd9uBjpxFjSDvswcdOI8aQdtiDj51GjCHtsAcfO40YQ9phDz52GjGGtMMefOw0YgxpA6uIiZmIiYiYQPkRlPiErEX1ykyYkpagThWkfZEoWYz8gsYfH/on45nwleja",
            "eBeGVp2CaUjSW5AZ+S23lh+piBLxJa+Ow0yBtT9zqIdmRc8D4mwg/3lDK88kLHIZm7K0BfQjKsSRcE+EuJchq4oT89JbOm/5AhmtrefHa09jpbSRbScyIDiK81DG2vnmKbaG",
            "7Jb98zbxaLSCD+4irIsV9H5d5xulhLhCdqs0aZ18W+Vvo4JhlnVU3mccSxXONVSkVXAUk0o7CKlYPpeNwUt/tJNyUdsPmXisNmqffrLncKUuY5chVYppSNJbkBn5LbeWH6mI",
            "EvElr47DTIG1P3Ooh2ZFzwPibKB/XuhyJmGRy9iUpS2gH1EhjgjvGUGcgQCIAAAAAAAAAHCnZciysshlp3BPRE9wp2XIsrLIZadwT4CAgICAgICAAAAAAAAAAADeAN4B3gLe",
            "AN4B3gLeAN4B3gLeAN4B3gLeAN4B3gLeAN4B3gLeAN4B3gLeANEBP5wG",
        };

        [TestCase("", 0xEF46DB3751D8E999UL)]
        [TestCase("a", 0xD24EC4F1A98C6E5BUL)]
        [TestCase("abc", 0x44BC2CF5AD770999UL)]
        [TestCase("Nobody inspects the spammish repetition", 0xFBCEA83C8A378BF1UL)]
        public void Checksum_OfTheTests_IsThePublishedOne(string text, ulong expected)
        {
            byte[] bytes = Encoding.ASCII.GetBytes(text);
            Assert.That(PackedBytes.Xxh64(bytes, 0, bytes.Length), Is.EqualTo(expected));
        }

        [TestCase(1)]
        [TestCase(7)]
        [TestCase(300)]
        public void Checksums_OfPackedVolumes_AreXxh64(int size)
        {
            byte[] packed = PackedVolume.Write(SampleVolumes.Scan(size, 3, 5, 3, 1));
            byte[] sealedAgain = (byte[])packed.Clone();
            PackedBytes.SealBlocks(sealedAgain);
            Assert.That(sealedAgain, Is.EqualTo(packed));
        }

        [Test]
        public void Version1_IsReadAsItAlwaysWas()
        {
            byte[] packed = Convert.FromBase64String(string.Concat(ReferenceBytes));
            SegmentedVolumeAssert.AreSame(PackedVolume.Read(packed, "reference"), Reference());
        }

        /// <summary>Seven tiles of intensities: every predictor, one exact, one of full width; labels in runs.</summary>
        static SegmentedVolume Reference()
        {
            const int row = 20, slice = row * 13;
            var geometry = new VolumeGeometry(
                row, 13, 6, Affine.FromColumns(new VectorMm(-0.5, 0, 0), new VectorMm(0, 0.5, 0.1), new VectorMm(0, 0, 2), new PointMm(10, -20, 30)));
            var codes = new ushort[geometry.VoxelCount];
            var indices = new ushort[codes.Length];
            for (int n = 0; n < codes.Length; n++)
            {
                int noise = n * n % 13;
                int code = n < 256 ? n * 40503
                    : n < 512 ? (3 * (n % row)) + (50 * (n / row))
                    : n < 768 ? codes[n - row] + noise
                    : n < 1024 ? codes[n - slice] - noise
                    : n < 1280 ? 500 + (n * n * 31 % 171)
                    : n < 1536 ? codes[n - row]
                    : codes[n - 1] + (noise * 11) - 60;
                codes[n] = (ushort)code;
                indices[n] = (ushort)(n >= 1100 ? indices[n - slice] : n >= 700 ? indices[n - row] : n / 31 % 3);
            }

            var table = new SegmentTable(new[]
            {
                new Segment(0, 0, "Unlabelled", new SegmentColor(1, 2, 3)),
                new Segment(1, -7, "Hippocampus_L", new SegmentColor(250, 0, 128), 0.25f),
                new Segment(2, 300, "Gro\u00DFhirn", new SegmentColor(9, 8, 7), 0f),
            });
            return new SegmentedVolume(
                new IntensityVolume(geometry, codes, -1000, 0.5, 31767.5, new[] { "a" }), new LabelMap(geometry, indices, table), new[] { "scan.nii: a" });
        }
    }
}
