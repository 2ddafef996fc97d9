using System;
using System.IO;
using System.Linq;
using System.Text;
using AnatomyCarve.Headless.Cli.Files;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>The files beside the picture, byte by byte as their formats have them.</summary>
    sealed class PictureFileTests
    {
        TestFolder folder;

        [SetUp]
        public void MakeFolder() => folder = new TestFolder();

        [TearDown]
        public void DeleteFolder() => folder.Dispose();

        [Test]
        public void Pfm_OfTwoRows_HoldsTheLowestRowFirst()
        {
            using var stream = new MemoryStream();
            PfmFile.Write(stream, 2, 2, [1f, 2f, 3f, float.PositiveInfinity]);

            byte[] expected = [.. "Pf\n2 2\n-1.0\n"u8, .. new[] { 3f, float.PositiveInfinity, 1f, 2f }.SelectMany(BitConverter.GetBytes)];
            Assert.That(stream.ToArray(), Is.EqualTo(expected));
        }

        [Test]
        public void Pgm_OfTwoRows_HoldsTheTopRowFirstBigEndian()
        {
            using var stream = new MemoryStream();
            PgmFile.Write(stream, 2, 2, [1, 258, 3, 65535]);

            byte[] expected = [.. "P5\n2 2\n65535\n"u8, 0, 1, 1, 2, 0, 3, 255, 255];
            Assert.That(stream.ToArray(), Is.EqualTo(expected));
        }

        [Test]
        public void Pfm_WrittenAndRead_IsTheSame()
        {
            float[] values = [1f, 2.5f, float.PositiveInfinity, -4f, 5f, 6f];
            using (var stream = File.Create(folder["a.pfm"])) PfmFile.Write(stream, 3, 2, values);

            var read = PfmFile.Read(folder["a.pfm"]);

            Assert.That((read.Width, read.Height), Is.EqualTo((3, 2)));
            Assert.That(read.Values, Is.EqualTo(values));
        }

        [Test]
        public void Pfm_BigEndian_IsRead()
        {
            File.WriteAllBytes(folder["a.pfm"], [.. "Pf\n1 1\n1.0\n"u8, 0x3F, 0x80, 0, 0]);

            Assert.That(PfmFile.Read(folder["a.pfm"]).Values, Is.EqualTo(new[] { 1f }));
        }

        [Test]
        public void Pgm_WithComments_IsRead()
        {
            File.WriteAllBytes(folder["a.pgm"], [.. "P5 # made by hand\n# two pixels\n2 1\n65535\n"u8, 1, 0, 0, 7]);

            Assert.That(PgmFile.Read(folder["a.pgm"]).Values, Is.EqualTo(new ushort[] { 256, 7 }));
        }

        [TestCase("P5\n2 2\n65535\n\0\0\0")]
        [TestCase("P5\n2 2\n255\n\0\0\0\0")]
        [TestCase("P6\n1 1\n65535\n\0\0")]
        [TestCase("P5\n-2 2\n65535\n")]
        [TestCase("P5\n99999999 99999999\n65535\n")]
        [TestCase("")]
        public void Pgm_Malformed_IsRefused(string text)
        {
            File.WriteAllBytes(folder["a.pgm"], Encoding.Latin1.GetBytes(text));

            Assert.That(() => PgmFile.Read(folder["a.pgm"]), Throws.TypeOf<PictureFileException>().With.Message.StartsWith(folder["a.pgm"]));
        }

        [Test]
        public void Outputs_NotCommitted_LeaveNothingBehind()
        {
            using (var outputs = new OutputSet())
            {
                outputs.Add(folder["a.txt"], stream => stream.WriteByte(1));
                outputs.Add(folder["b.txt"], stream => stream.WriteByte(2));
            }

            Assert.That(folder.FileNames, Is.Empty);
        }

        [Test]
        public void Outputs_WhoseWritingFails_LeaveWhatWasThere()
        {
            folder.Write("a.txt", "before");

            Assert.That(
                () =>
                {
                    using var outputs = new OutputSet();
                    outputs.Add(folder["a.txt"], stream => stream.WriteByte(1));
                    outputs.Add(folder["b.txt"], _ => throw new IOException("full"));
                    outputs.Commit();
                },
                Throws.TypeOf<IOException>());

            Assert.That(folder.FileNames, Is.EqualTo(new[] { "a.txt" }));
            Assert.That(File.ReadAllText(folder["a.txt"]), Is.EqualTo("before"));
        }

        [Test]
        public void Outputs_Committed_StandUnderTheirNames()
        {
            folder.Write("a.txt", "before");
            using (var outputs = new OutputSet())
            {
                outputs.Add(folder["a.txt"], stream => stream.Write("after"u8));
                outputs.Commit();
            }

            Assert.That(folder.FileNames, Is.EqualTo(new[] { "a.txt" }));
            Assert.That(File.ReadAllText(folder["a.txt"]), Is.EqualTo("after"));
        }
    }
}
