using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    public sealed class NrrdReaderTests
    {
        static readonly short[] Numbers = { -32768, -1, 0, 258, 513, 32767 };

        static IEnumerable<Array> VoxelArrays() => new Array[]
        {
            new sbyte[] { -128, 0, 1, 127 }, new byte[] { 0, 1, 254, 255 }, new short[] { -32768, -1, 258, 32767 }, new ushort[] { 0, 1, 258, 65535 },
            new[] { int.MinValue, -1, 66051, int.MaxValue }, new[] { 0u, 1u, 66051u, uint.MaxValue },
            new[] { long.MinValue, -1, 72623859790382856, long.MaxValue }, new[] { 0ul, 1ul, 72623859790382856ul, ulong.MaxValue },
            new[] { -1.5f, 0, 0.1f, float.MaxValue }, new[] { -1.5, 0, 0.1, double.MaxValue },
        };

        [Test]
        public void EveryTypeInEveryEncoding_IsReadAsItIs(
            [ValueSource(nameof(VoxelArrays))] Array voxels, [Values("raw", "gzip", "gz", "ascii", "text", "txt", "hex")] string encoding, [Values("little", "big")] string endian)
        {
            var file = new NrrdFile(voxels, 2, 1, 2) { ["encoding"] = encoding, ["endian"] = endian };
            VolumeData data = Read(file.ToBytes());
            Assert.That(data.Voxels.GetType(), Is.EqualTo(voxels.GetType()));
            Assert.That(data.Voxels, Is.EqualTo(voxels));
            Assert.That(data.Warnings, Is.Empty);
        }

        [TestCase("signed char", VoxelType.Int8)]
        [TestCase("int8_t", VoxelType.Int8)]
        [TestCase("uchar", VoxelType.UInt8)]
        [TestCase("unsigned char", VoxelType.UInt8)]
        [TestCase("uint8", VoxelType.UInt8)]
        [TestCase("short int", VoxelType.Int16)]
        [TestCase("signed short int", VoxelType.Int16)]
        [TestCase("int16_t", VoxelType.Int16)]
        [TestCase("unsigned short int", VoxelType.UInt16)]
        [TestCase("uint16", VoxelType.UInt16)]
        [TestCase("signed int", VoxelType.Int32)]
        [TestCase("int32", VoxelType.Int32)]
        [TestCase("unsigned int", VoxelType.UInt32)]
        [TestCase("uint32_t", VoxelType.UInt32)]
        [TestCase("long long int", VoxelType.Int64)]
        [TestCase("signed long long", VoxelType.Int64)]
        [TestCase("int64", VoxelType.Int64)]
        [TestCase("unsigned long long int", VoxelType.UInt64)]
        [TestCase("ulonglong", VoxelType.UInt64)]
        [TestCase("float", VoxelType.Float32)]
        [TestCase("double", VoxelType.Float64)]
        public void TypeSynonym_IsUnderstood(string name, VoxelType type)
        {
            var file = new NrrdFile(new byte[type.SizeOf()], 1, 1, 1) { ["type"] = name };
            Assert.That(Read(file.ToBytes()).VoxelType, Is.EqualTo(type));
        }

        [TestCase("none")]
        [TestCase("(nan,nan,nan)")]
        public void ComponentsFirst_RunFastest(string none)
        {
            var file = Placed(new NrrdFile(new byte[] { 1, 2, 3, 4 }, 2, 2, 1, 1), none + " (1,0,0) ( 0, 1, 0 ) (0,0,1)");
            VolumeData data = Read(file.ToBytes());
            Assert.That(data.ComponentOrder, Is.EqualTo(ComponentOrder.Fastest));
            Assert.That(data.Value(1, 0, 0, 0), Is.EqualTo(3));
        }

        [Test]
        public void ComponentsLast_RunSlowest()
        {
            var file = Placed(new NrrdFile(new byte[] { 1, 2, 3, 4 }, 2, 1, 1, 2), "(1,0,0) (0,1,0) (0,0,1) none");
            VolumeData data = Read(file.ToBytes());
            Assert.That(data.ComponentOrder, Is.EqualTo(ComponentOrder.Slowest));
            Assert.That(data.Value(1, 0, 0, 1), Is.EqualTo(4));
        }

        [Test]
        public void ComponentsBetweenSpatialAxes_AreRefused()
        {
            var file = Placed(new NrrdFile(new byte[4], 2, 2, 1, 1), "(1,0,0) none (0,1,0) (0,0,1)");
            Assert.That(() => Read(file.ToBytes()), Throws.TypeOf<VolumeFormatException>());
        }

        [Test]
        public void KindsAlone_TellComponents()
        {
            var file = new NrrdFile(new byte[6], 3, 2, 1, 1) { ["kinds"] = "RGB-color domain domain domain", ["spacings"] = "nan 1 2 3" };
            VolumeData data = Read(file.ToBytes());
            Assert.That(data.Components, Is.EqualTo(3));
            Assert.That(data.Geometry.SpacingMm, Is.EqualTo(new VectorMm(1, 2, 3)));
        }

        [Test]
        public void TwoSpatialAxes_AreOneSlice()
        {
            var file = Placed(new NrrdFile(new byte[4], 2, 2), "(0,2,0) (0,0,3)");
            VolumeGeometry geometry = Read(file.ToBytes()).Geometry;
            Assert.That(geometry.SizeK, Is.EqualTo(1));
            Assert.That(geometry.OrientationCode, Is.EqualTo("PSL"));
        }

        [Test]
        public void LineSkipAndByteSkip_AreAppliedInThisOrder()
        {
            var file = new NrrdFile(Numbers, 6, 1, 1) { ["line skip"] = "2", ["byte skip"] = "3" };
            byte[] bytes = VoxelBytes.Join(file.HeaderBytes(), Encoding.ASCII.GetBytes("one\ntwo\nxyz"), file.DataBytes());
            Assert.That(Read(bytes).Voxels, Is.EqualTo(Numbers));
        }

        [Test]
        public void ByteSkipOfMinusOne_TakesTheLastBytes([Values("raw", "gzip")] string encoding)
        {
            var file = new NrrdFile(Numbers, 6, 1, 1) { ["encoding"] = encoding, ["byteskip"] = "-1" };
            byte[] data = VoxelBytes.Join(new byte[77], VoxelBytes.Of(Numbers, false));
            byte[] bytes = VoxelBytes.Join(file.HeaderBytes(), encoding == "raw" ? data : VoxelBytes.Gzip(data));
            Assert.That(Read(bytes).Voxels, Is.EqualTo(Numbers));
        }

        [Test]
        public void ByteSkipOfGzip_CountsInflatedBytes()
        {
            var file = new NrrdFile(Numbers, 6, 1, 1) { ["encoding"] = "gzip", ["byte skip"] = "10" };
            byte[] bytes = VoxelBytes.Join(file.HeaderBytes(), VoxelBytes.Gzip(VoxelBytes.Join(new byte[10], VoxelBytes.Of(Numbers, false))));
            Assert.That(Read(bytes).Voxels, Is.EqualTo(Numbers));
        }

        [Test]
        public void SeveralGzipMembers_AreReadAsOne()
        {
            var file = new NrrdFile(Numbers, 6, 1, 1) { ["encoding"] = "gzip" };
            byte[] data = VoxelBytes.Of(Numbers, false);
            byte[] bytes = VoxelBytes.Join(
                file.HeaderBytes(), VoxelBytes.Gzip(VoxelBytes.Part(data, 0, 5)), VoxelBytes.Gzip(new byte[0]), VoxelBytes.Gzip(VoxelBytes.Part(data, 5, 7)));
            Assert.That(Read(bytes).Voxels, Is.EqualTo(Numbers));
        }

        [Test]
        public void WrongChecksum_IsRefused()
        {
            byte[] bytes = new NrrdFile(Numbers, 6, 1, 1) { ["encoding"] = "gzip" }.ToBytes();
            bytes[bytes.Length - 8] ^= 1;
            var refusal = Assert.Throws<VolumeFormatException>(() => Read(bytes));
            Assert.That(refusal.Field, Is.EqualTo("the gzip data"));
        }

        [Test]
        public void KeyValues_KeepColonsAndResolveEscapes()
        {
            var file = new NrrdFile(Numbers, 6, 1, 1) { LineEnd = "\r\n" };
            file.FurtherLines.AddRange(new[] { "# a comment: of no matter", "a:=b:=c: d", "one: two:=three", "path:=c:\\\\new\\nline\\t", "leer:=", "Größe:=ä" });
            IReadOnlyDictionary<string, string> metadata = Read(file.ToBytes()).Metadata;
            Assert.That(metadata, Has.Count.EqualTo(5));
            Assert.That(metadata["a"], Is.EqualTo("b:=c: d"));
            Assert.That(metadata["one: two"], Is.EqualTo("three"));
            Assert.That(metadata["path"], Is.EqualTo("c:\\new\nline\\t"));
            Assert.That(metadata["leer"], Is.Empty);
            Assert.That(metadata["Größe"], Is.EqualTo("ä"));
        }

        [Test]
        public void SpecialFloatsInText_AreRead()
        {
            var file = new NrrdFile(new float[5], 5, 1, 1) { ["encoding"] = "ascii" };
            byte[] bytes = VoxelBytes.Join(file.HeaderBytes(), Encoding.ASCII.GetBytes("nan -inf\tinf, 1e3\r\n-0.5"));
            Assert.That(Read(bytes).Voxels, Is.EqualTo(new[] { float.NaN, float.NegativeInfinity, float.PositiveInfinity, 1000f, -0.5f }));
        }

        [TestCase("1 2 3 4 5 6.5")]
        [TestCase("1 2 3 4 5 70000")]
        [TestCase("1 2 3 4 5 six")]
        [TestCase("1 2 3 4 5          ")]
        [TestCase("1 2")]
        public void TextThatDoesNotFit_IsRefused(string text)
        {
            var file = new NrrdFile(Numbers, 6, 1, 1) { ["encoding"] = "ascii" };
            byte[] bytes = VoxelBytes.Join(file.HeaderBytes(), Encoding.ASCII.GetBytes(text));
            Assert.That(() => Read(bytes), Throws.TypeOf<VolumeFormatException>());
        }

        [TestCase("0g00")]
        [TestCase("0 0 0")]
        public void HexThatDoesNotFit_IsRefused(string text)
        {
            var file = new NrrdFile(new short[1], 1, 1, 1) { ["encoding"] = "hex" };
            byte[] bytes = VoxelBytes.Join(file.HeaderBytes(), Encoding.ASCII.GetBytes(text));
            Assert.That(() => Read(bytes), Throws.TypeOf<VolumeFormatException>());
        }

        [TestCase("space", "scanner-xyz", "anatomical")]
        [TestCase("space units", "\"furlong\" \"furlong\" \"furlong\"", "furlong")]
        [TestCase("space", "3D-right-handed", "anatomical")]
        public void OddSpace_IsReadWithAWarning(string field, string value, string warning)
        {
            Assert.That(Read(new NrrdFile(Numbers, 6, 1, 1) { [field] = value }.ToBytes()).Warnings, Has.Some.Contains(warning));
        }

        [TestCase("space", "right-anterior-superior-time")]
        [TestCase("endian", null)]
        [TestCase("encoding", "bzip2")]
        [TestCase("data file", "other.raw")]
        [TestCase("space origin", "(0,0)")]
        [TestCase("space directions", "(1,0,0) (0,1,0) 0,0,1")]
        [TestCase("sizes", "6 1")]
        [TestCase("byte skip", "-2")]
        [TestCase("line skip", "99")]
        public void FieldThatCannotBeUsed_IsNamed(string field, string value)
        {
            var refusal = Assert.Throws<VolumeFormatException>(() => Read(new NrrdFile(Numbers, 6, 1, 1) { [field] = value }.ToBytes()));
            Assert.That(refusal.Field, Is.EqualTo(field));
            Assert.That(refusal.File, Is.EqualTo("test"));
        }

        [Test]
        public void SpaceUnits_AreTurnedIntoMillimetres()
        {
            VolumeData data = Read(new NrrdFile(Numbers, 6, 1, 1) { ["space units"] = "\"cm\" \"cm\" \"cm\"" }.ToBytes());
            Assert.That(data.Geometry.SpacingMm, Is.EqualTo(new VectorMm(10, 10, 10)));
        }

        [Test]
        public void ReadUnderACultureWithDecimalComma_GivesTheSame()
        {
            CultureInfo before = Thread.CurrentThread.CurrentCulture;
            try
            {
                Thread.CurrentThread.CurrentCulture = new CultureInfo("de-DE");
                var file = Placed(new NrrdFile(new[] { 0.5, 1.5 }, 2, 1, 1) { ["encoding"] = "ascii" }, "(0.5,0,0) (0,1.25,0) (0,0,2.5)");
                VolumeData data = Read(file.ToBytes());
                Assert.That(data.Geometry.SpacingMm, Is.EqualTo(new VectorMm(0.5, 1.25, 2.5)));
                Assert.That(data.Voxels, Is.EqualTo(new[] { 0.5, 1.5 }));
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [Test]
        public void Segments_StopAtTheFirstMissingNumber_AndTenFollowsNine()
        {
            var file = new NrrdFile(new byte[6], 6, 1, 1);
            for (int n = 11; n >= 0; n--)
            {
                file.FurtherLines.Add(n == 10 ? "Segment10_Name:=nameless" : "Segment" + n + "_ID:=id" + n);
                file.FurtherLines.Add("Segment" + n + "_LabelValue:=" + (n + 1));
            }

            VolumeData data = Read(file.ToBytes());
            Assert.That(data.Segments, Has.Count.EqualTo(10));
            Assert.That(data.Segments[9].Id, Is.EqualTo("id9"));
            Assert.That(data.Segments[9].LabelValue, Is.EqualTo(10));
            Assert.That(data.Warnings, Has.Some.Contains("Segment10"));
        }

        static NrrdFile Placed(NrrdFile file, string directions)
        {
            file["space"] = "left-posterior-superior";
            file["space directions"] = directions;
            return file;
        }

        static VolumeData Read(byte[] file) => NrrdReader.Read(new MemoryStream(file), "test");
    }
}
