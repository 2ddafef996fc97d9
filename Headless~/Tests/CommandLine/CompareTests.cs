using System;
using System.IO;
using System.IO.Compression;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Files;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    sealed class CompareTests
    {
        TestFolder folder;

        [SetUp]
        public void MakeFolder() => folder = new TestFolder();

        [TearDown]
        public void DeleteFolder() => folder.Dispose();

        [Test]
        public void Compare_OfHandMadePairs_GivesTheMetrics()
        {
            WriteDepth("a.pfm", [1, 2, float.PositiveInfinity, 4]);
            WriteDepth("b.pfm", [4, 6, 3, float.PositiveInfinity]);
            WriteSegments("a.pgm", [1, 2, 65535, 65535]);
            WriteSegments("b.pgm", [1, 3, 4, 65535]);
            WritePng("a.png", 2, 2, [0, 0, 0, 10, 10, 10, 20, 20, 20, 30, 30, 30]);
            WritePng("b.png", 2, 2, [0, 0, 0, 10, 10, 10, 20, 20, 20, 30, 30, 60]);

            var result = Carve.InProcess("compare", folder["a.png"], folder["b.png"], "--json");

            Assert.That(result.ExitCode, Is.Zero, result.Error);
            var json = JsonNode.Parse(result.Output);
            Assert.That((double)json["depth"]["rmseMm"], Is.EqualTo(Math.Sqrt((9 + 16) / 2.0)).Within(1e-12));
            Assert.That((int)json["depth"]["both"], Is.EqualTo(2));
            Assert.That((int)json["depth"]["onlyOne"], Is.EqualTo(2));
            Assert.That((double)json["segments"]["mae"], Is.EqualTo(2 / 3.0).Within(1e-12));
            Assert.That((double)json["image"]["rmse"], Is.EqualTo(Math.Sqrt(900 / 12.0)).Within(1e-12));
            Assert.That((double)json["image"]["psnrDecibels"], Is.EqualTo(20 * Math.Log10(255 / Math.Sqrt(75))).Within(1e-9));
        }

        [Test]
        public void Compare_WithItself_FindsNoDifference()
        {
            WriteDepth("a.pfm", [1, 2, float.PositiveInfinity, 4]);
            WriteSegments("a.pgm", [1, 2, 65535, 65535]);
            WritePng("a.png", 2, 2, new byte[12]);

            var result = Carve.InProcess("compare", folder["a.pgm"], folder["a.pfm"]);

            Assert.That(result.ExitCode, Is.Zero, result.Error);
            Assert.That(result.Output, Does.Match(@"depth RMSE +│ 0 mm"));
            Assert.That(result.Output, Does.Match(@"first-segment MAE +│ 0 "));
            Assert.That(result.Output, Does.Match(@"image RMSE +│ 0 "));
            Assert.That(result.Output, Does.Contain("infinite"));
        }

        [Test]
        public void Compare_ByReports_FindsTheirOutputs()
        {
            WriteDepth("depth.pfm", [1, 2, 3, 4]);
            folder.Write("a.json", """{"outputs": {"depth": "depth.pfm"}}""");

            var result = Carve.InProcess("compare", folder["a.json"], folder["a.json"], "--json");

            Assert.That(result.ExitCode, Is.Zero, result.Error);
            var json = JsonNode.Parse(result.Output);
            Assert.That((int)json["depth"]["both"], Is.EqualTo(4));
            Assert.That(json["image"], Is.Null);
        }

        [TestCase(1)]
        [TestCase(3)]
        [TestCase(4)]
        public void Compare_OfFilteredPngs_ReadsTheirPixels(int filter)
        {
            // Row by row with this filter, the differences below mean: 7 everywhere (each predictor starts from 0).
            byte[] first = filter == 3 ? [7, 7, 7, 4, 4, 4] : [7, 7, 7, 0, 0, 0];
            byte[] second = filter switch { 1 => [7, 7, 7, 0, 0, 0], 3 => [4, 4, 4, 0, 0, 0], _ => [0, 0, 0, 0, 0, 0] };
            WritePngRows("a.png", 2, 2, [(byte)filter, .. first, (byte)filter, .. second]);

            Assert.That(PngFile.ReadRgb(folder["a.png"]).Values, Is.All.EqualTo(7));
        }

        [Test]
        public void Compare_OfDifferentSizes_IsRefused()
        {
            WritePng("a.png", 2, 2, new byte[12]);
            WritePng("b.png", 4, 1, new byte[12]);

            IsRefused("a.png", "b.png", "size");
        }

        [Test]
        public void Compare_WithNothingInCommon_IsRefused()
        {
            WriteDepth("a.pfm", [1, 2, 3, 4]);
            WriteSegments("b.pgm", [1, 2, 3, 4]);

            IsRefused("a.pfm", "b.pgm", "in common");
        }

        [TestCase("missing.png", null)]
        [TestCase("broken.png", "not a PNG at all")]
        [TestCase("broken.pfm", "Pf\n2 2\n-1\n")]
        [TestCase("broken.json", "{")]
        [TestCase("broken.json", "[]")]
        [TestCase("other.txt", "text")]
        public void Compare_OfBadFile_IsRefused(string name, string content)
        {
            if (content != null) folder.Write(name, content);

            IsRefused(name, name, name);
        }

        void IsRefused(string a, string b, string message)
        {
            var result = Carve.InProcess("compare", folder[a], folder[b]);

            Assert.That(result.ExitCode, Is.EqualTo(1));
            Assert.That(result.ErrorLines, Has.Length.EqualTo(1), result.Error);
            Assert.That(result.Error, Does.Contain(message));
            Assert.That(result.Output, Is.Empty);
        }

        void WriteDepth(string name, float[] values)
        {
            using var stream = File.Create(folder[name]);
            PfmFile.Write(stream, 2, 2, values);
        }

        void WriteSegments(string name, ushort[] values)
        {
            using var stream = File.Create(folder[name]);
            PgmFile.Write(stream, 2, 2, values);
        }

        void WritePng(string name, int width, int height, byte[] rgb)
        {
            using var rows = new MemoryStream();
            for (var y = 0; y < height; y++)
            {
                rows.WriteByte(0);
                rows.Write(rgb, y * width * 3, width * 3);
            }

            WritePngRows(name, width, height, rows.ToArray());
        }

        // Without check sums, which the reader does not look at.
        void WritePngRows(string name, int width, int height, byte[] filteredRows)
        {
            using var compressed = new MemoryStream();
            using (var zlib = new ZLibStream(compressed, CompressionLevel.Fastest, leaveOpen: true)) zlib.Write(filteredRows);
            using var file = File.Create(folder[name]);
            file.Write([0x89, .. "PNG\r\n\u001a\n"u8]);
            WriteChunk(file, "IHDR"u8, [0, 0, 0, (byte)width, 0, 0, 0, (byte)height, 8, 2, 0, 0, 0]);
            WriteChunk(file, "IDAT"u8, compressed.ToArray());
            WriteChunk(file, "IEND"u8, []);
        }

        static void WriteChunk(Stream file, ReadOnlySpan<byte> kind, byte[] content)
        {
            file.Write([0, 0, (byte)(content.Length >> 8), (byte)content.Length]);
            file.Write(kind);
            file.Write(content);
            file.Write([0, 0, 0, 0]);
        }
    }
}
