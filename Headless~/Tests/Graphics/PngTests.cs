using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    public sealed class PngTests : GpuTest
    {
        [Test]
        public void Rgba_Encoded_HasTheFirstRowAtTheBottom()
        {
            var data = new byte[] { 1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18 };
            var (width, height, type, bits, rows) = Decode(ImageConversion.EncodeArrayToPNG(data, GraphicsFormat.R8G8B8A8_SRGB, 2, 2));
            Assert.That((width, height, type, bits), Is.EqualTo((2, 2, 6, 8)));
            Assert.That(rows[0], Is.EqualTo(data.Skip(8)));
            Assert.That(rows[1], Is.EqualTo(data.Take(8)));
        }

        [Test]
        public void Grey16_Encoded_HasTheHighByteFirst()
        {
            var (_, _, type, bits, rows) = Decode(ImageConversion.EncodeArrayToPNG(new ushort[] { 0x0102, 0xA0B0 }, GraphicsFormat.R16_UNorm, 2, 1));
            Assert.That((type, bits), Is.EqualTo((0, 16)));
            Assert.That(rows[0], Is.EqualTo(new byte[] { 0x01, 0x02, 0xA0, 0xB0 }));
        }

        [TestCase(GraphicsFormat.R8_UNorm, 0, 1)]
        [TestCase(GraphicsFormat.R8G8B8_UNorm, 2, 3)]
        [TestCase(GraphicsFormat.R8G8B8A8_UNorm, 6, 4)]
        public void RandomPicture_Encoded_DecodesToTheSame(GraphicsFormat format, int expectedType, int channels)
        {
            const int width = 37, height = 23;
            var random = new System.Random(1);
            var data = new byte[width * height * channels];
            random.NextBytes(data);
            var (_, _, type, _, rows) = Decode(ImageConversion.EncodeArrayToPNG(data, format, width, height));
            Assert.That(type, Is.EqualTo(expectedType));
            for (var y = 0; y < height; y++)
                Assert.That(rows[y], Is.EqualTo(data.Skip((height - 1 - y) * width * channels).Take(width * channels)), $"row {y}");
        }

        [Test]
        public void Texture_EncodedAndLoaded_IsTheSame()
        {
            var texture = Own(new Texture2D(3, 2, TextureFormat.RGBA32, false));
            var data = Enumerable.Range(0, 24).Select(i => (byte)(i * 10)).ToArray();
            texture.SetPixelData(data, 0);
            var loaded = Own(new Texture2D(1, 1));
            Assert.That(loaded.LoadImage(texture.EncodeToPNG()));
            Assert.That((loaded.width, loaded.height), Is.EqualTo((3, 2)));
            Assert.That(loaded.GetRawTextureData(), Is.EqualTo(data));
        }

        [Test]
        public void RowsWithPadding_Encoded_LoseIt()
        {
            var (_, _, _, _, rows) = Decode(ImageConversion.EncodeArrayToPNG(new byte[] { 1, 2, 99, 3, 4 }, GraphicsFormat.R8_UNorm, 2, 2, 3));
            Assert.That(rows[1], Is.EqualTo(new byte[] { 1, 2 }));
            Assert.That(rows[0], Is.EqualTo(new byte[] { 3, 4 }));
        }

        [Test]
        public void TooShortArray_IsRefused() =>
            Assert.Throws<ArgumentException>(() => ImageConversion.EncodeArrayToPNG(new byte[3], GraphicsFormat.R8_UNorm, 2, 2));

        [Test]
        public void BrokenFile_IsNotLoaded()
        {
            var png = ImageConversion.EncodeArrayToPNG(new byte[4], GraphicsFormat.R8_UNorm, 2, 2);
            png[20] ^= 1;
            Assert.That(Own(new Texture2D(1, 1)).LoadImage(png), Is.False);
        }

        // A reader of its own: the stream through .NET's zlib, which checks Adler-32; CRC-32 bit by bit.
        static (int Width, int Height, int Type, int Bits, List<byte[]> Rows) Decode(byte[] png)
        {
            Assert.That(png.Take(8), Is.EqualTo(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10 }));
            int width = 0, height = 0, type = 0, bits = 0;
            var compressed = new MemoryStream();
            for (var at = 8; at < png.Length;)
            {
                var length = Int(png, at);
                Assert.That((uint)Int(png, at + 8 + length), Is.EqualTo(Crc(png.AsSpan(at + 4, length + 4))));
                switch (System.Text.Encoding.ASCII.GetString(png, at + 4, 4))
                {
                    case "IHDR":
                        (width, height, bits, type) = (Int(png, at + 8), Int(png, at + 12), png[at + 16], png[at + 17]);
                        break;
                    case "IDAT":
                        compressed.Write(png, at + 8, length);
                        break;
                }
                at += 12 + length;
            }
            compressed.Position = 0;
            var data = new MemoryStream();
            using (var zlib = new ZLibStream(compressed, CompressionMode.Decompress))
                zlib.CopyTo(data);
            var pixel = new[] { 1, 0, 3, 1, 2, 0, 4 }[type] * bits / 8;
            return (width, height, type, bits, Unfilter(data.ToArray(), width * pixel, height, pixel));
        }

        static List<byte[]> Unfilter(byte[] data, int stride, int height, int pixel)
        {
            Assert.That(data, Has.Length.EqualTo((stride + 1) * height));
            var rows = new List<byte[]>();
            for (var y = 0; y < height; y++)
            {
                var row = data.AsSpan(y * (stride + 1) + 1, stride).ToArray();
                var filter = data[y * (stride + 1)];
                for (var x = 0; x < stride; x++)
                    row[x] += filter switch
                    {
                        0 => 0,
                        1 => x < pixel ? (byte)0 : row[x - pixel],
                        2 => y == 0 ? (byte)0 : rows[y - 1][x],
                        _ => throw new InvalidDataException(),
                    };
                rows.Add(row);
            }
            return rows;
        }

        static int Int(byte[] data, int at) => data[at] << 24 | data[at + 1] << 16 | data[at + 2] << 8 | data[at + 3];

        static uint Crc(ReadOnlySpan<byte> data)
        {
            var crc = uint.MaxValue;
            foreach (var b in data)
            {
                crc ^= b;
                for (var k = 0; k < 8; k++)
                    crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
            }
            return ~crc;
        }
    }
}
