using System;
using System.IO;
using System.IO.Compression;

namespace UnityEngine
{
    /// <summary>Reads PNG files with 8 bits per channel that are not interlaced, into RGBA with the bottom row first.</summary>
    static class PngDecoder
    {
        const int SignatureLength = 8;
        const int MaxSize = 16384;

        internal static bool TryDecode(byte[] file, out int width, out int height, out byte[] rgba)
        {
            rgba = null;
            width = height = 0;
            var palette = Array.Empty<byte>();
            var transparency = Array.Empty<byte>();
            var type = -1;
            using var compressed = new MemoryStream();
            try
            {
                for (var at = SignatureLength; at + 12 <= file.Length;)
                {
                    var length = (int)BigEndian(file, at);
                    if (length < 0 || at + 12 + (long)length > file.Length || Checksums.Crc32(file, at + 4, length + 4) != BigEndian(file, at + 8 + length))
                        return false;
                    var data = new ArraySegment<byte>(file, at + 8, length);
                    switch (System.Text.Encoding.ASCII.GetString(file, at + 4, 4))
                    {
                        case "IHDR":
                            (width, height, type) = ((int)BigEndian(file, at + 8), (int)BigEndian(file, at + 12), file[at + 17]);
                            if (width is < 1 or > MaxSize || height is < 1 or > MaxSize || file[at + 16] != 8 || file[at + 20] != 0)
                                return false;
                            break;
                        case "PLTE":
                            palette = data.ToArray();
                            break;
                        case "tRNS":
                            transparency = data.ToArray();
                            break;
                        case "IDAT":
                            compressed.Write(file, at + 8, length);
                            break;
                    }
                    at += 12 + length;
                }
                var channels = type switch { 0 => 1, 2 => 3, 3 => 1, 4 => 2, 6 => 4, _ => 0 };
                if (channels == 0)
                    return false;
                var rows = Unfilter(Inflate(compressed, (width * channels + 1) * height), width * channels, height, channels);
                rgba = ToRgba(rows, width, height, type, channels, palette, transparency);
                return true;
            }
            catch (Exception e) when (e is InvalidDataException or IndexOutOfRangeException or OverflowException)
            {
                return false;
            }
        }

        static byte[] Inflate(MemoryStream compressed, int size)
        {
            compressed.Position = 2;
            using var deflate = new DeflateStream(compressed, CompressionMode.Decompress);
            var data = new byte[size];
            for (var done = 0; done < size;)
            {
                var read = deflate.Read(data, done, size - done);
                if (read == 0)
                    throw new InvalidDataException("the picture ends too early");
                done += read;
            }
            return data;
        }

        static byte[] Unfilter(byte[] data, int stride, int height, int pixel)
        {
            var rows = new byte[stride * height];
            for (var y = 0; y < height; y++)
            {
                var filter = data[y * (stride + 1)];
                for (var x = 0; x < stride; x++)
                {
                    var at = y * stride + x;
                    var left = x >= pixel ? rows[at - pixel] : 0;
                    var up = y > 0 ? rows[at - stride] : 0;
                    var corner = x >= pixel && y > 0 ? rows[at - stride - pixel] : 0;
                    var predicted = filter switch
                    {
                        0 => 0,
                        1 => left,
                        2 => up,
                        3 => (left + up) / 2,
                        4 => Paeth(left, up, corner),
                        _ => throw new InvalidDataException("unknown filter"),
                    };
                    rows[at] = (byte)(data[y * (stride + 1) + 1 + x] + predicted);
                }
            }
            return rows;
        }

        static int Paeth(int left, int up, int corner)
        {
            var estimate = left + up - corner;
            var (a, b, c) = (Math.Abs(estimate - left), Math.Abs(estimate - up), Math.Abs(estimate - corner));
            return a <= b && a <= c ? left : b <= c ? up : corner;
        }

        static byte[] ToRgba(byte[] rows, int width, int height, int type, int channels, byte[] palette, byte[] transparency)
        {
            var rgba = new byte[width * height * 4];
            for (var i = 0; i < width * height; i++)
            {
                var target = ((height - 1 - i / width) * width + i % width) * 4;
                var source = i * channels;
                rgba[target + 3] = 255;
                if (type == 3)
                {
                    Array.Copy(palette, rows[source] * 3, rgba, target, 3);
                    if (rows[source] < transparency.Length)
                        rgba[target + 3] = transparency[rows[source]];
                    continue;
                }
                for (var c = 0; c < 3; c++)
                    rgba[target + c] = rows[source + (channels >= 3 ? c : 0)];
                if (channels is 2 or 4)
                    rgba[target + 3] = rows[source + channels - 1];
            }
            return rgba;
        }

        static uint BigEndian(byte[] data, int at) => (uint)(data[at] << 24 | data[at + 1] << 16 | data[at + 2] << 8 | data[at + 3]);
    }
}
