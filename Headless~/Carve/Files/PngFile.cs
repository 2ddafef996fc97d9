using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using System.Text;

namespace AnatomyCarve.Headless.Cli.Files
{
    /// <summary>Reads the PNGs that the command line writes, and any other of 8 bits a channel that is not interlaced and has no palette.</summary>
    static class PngFile
    {
        static readonly byte[] Signature = [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

        const int LargestSize = 32768;

        /// <summary>The picture as three bytes (red, green, blue) a pixel, so its width counts bytes; an alpha channel is left out.</summary>
        /// <exception cref="PictureFileException">The file is not such a PNG.</exception>
        public static Plane<byte> ReadRgb(string path)
        {
            var bytes = File.ReadAllBytes(path);
            if (!bytes.AsSpan().StartsWith(Signature)) throw new PictureFileException(path, "not a PNG");
            int width = 0, height = 0, channels = 0;
            using var compressed = new MemoryStream();
            for (var position = Signature.Length; ;)
            {
                if (position + 12 > bytes.Length) throw new PictureFileException(path, "the PNG ends too early");
                var length = BinaryPrimitives.ReadUInt32BigEndian(bytes.AsSpan(position));
                if (length > bytes.Length - position - 12) throw new PictureFileException(path, "the PNG ends too early");
                var kind = Encoding.ASCII.GetString(bytes, position + 4, 4);
                var content = bytes.AsSpan(position + 8, (int)length);
                if (kind == "IHDR") (width, height, channels) = ReadHeader(path, content);
                if (kind == "IDAT") compressed.Write(content);
                if (kind == "IEND") break;
                position += 12 + (int)length;
            }

            if (channels == 0) throw new PictureFileException(path, "the PNG has no header");
            return new Plane<byte>(width * 3, height,
                ToRgb(Unfilter(path, Inflate(path, compressed, height * (1 + width * channels)), width, height, channels), channels));
        }

        static (int Width, int Height, int Channels) ReadHeader(string path, ReadOnlySpan<byte> header)
        {
            if (header.Length != 13) throw new PictureFileException(path, "the PNG's header has a wrong size");
            uint width = BinaryPrimitives.ReadUInt32BigEndian(header), height = BinaryPrimitives.ReadUInt32BigEndian(header[4..]);
            if (width is 0 or > LargestSize || height is 0 or > LargestSize) throw new PictureFileException(path, $"{width} x {height} pixels");
            var channels = header[9] switch { 0 => 1, 2 => 3, 4 => 2, 6 => 4, _ => 0 };
            if (header[8] != 8 || channels == 0 || header[12] != 0)
            {
                throw new PictureFileException(path, "only PNGs of 8 bits a channel without palette and interlacing are read");
            }

            return ((int)width, (int)height, channels);
        }

        static byte[] Inflate(string path, MemoryStream compressed, int size)
        {
            compressed.Position = 0;
            var rows = new byte[size];
            try
            {
                using var zlib = new ZLibStream(compressed, CompressionMode.Decompress);
                zlib.ReadExactly(rows);
            }
            catch (Exception exception) when (exception is InvalidDataException or EndOfStreamException)
            {
                throw new PictureFileException(path, "the PNG's pixels can't be unpacked");
            }

            return rows;
        }

        static byte[] Unfilter(string path, byte[] rows, int width, int height, int channels)
        {
            var stride = width * channels;
            var pixels = new byte[height * stride];
            for (var y = 0; y < height; y++)
            {
                var filter = rows[y * (stride + 1)];
                if (filter > 4) throw new PictureFileException(path, $"PNG filter {filter} does not exist");
                for (var x = 0; x < stride; x++)
                {
                    int left = x < channels ? 0 : pixels[y * stride + x - channels];
                    int above = y == 0 ? 0 : pixels[(y - 1) * stride + x];
                    int corner = y == 0 || x < channels ? 0 : pixels[(y - 1) * stride + x - channels];
                    var predicted = filter switch { 0 => 0, 1 => left, 2 => above, 3 => (left + above) / 2, _ => Paeth(left, above, corner) };
                    pixels[y * stride + x] = (byte)(rows[y * (stride + 1) + 1 + x] + predicted);
                }
            }

            return pixels;
        }

        static int Paeth(int left, int above, int corner)
        {
            var estimate = left + above - corner;
            int toLeft = Math.Abs(estimate - left), toAbove = Math.Abs(estimate - above), toCorner = Math.Abs(estimate - corner);
            return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
        }

        static byte[] ToRgb(byte[] pixels, int channels)
        {
            if (channels == 3) return pixels;
            var count = pixels.Length / channels;
            var rgb = new byte[count * 3];
            for (var index = 0; index < count; index++)
            {
                for (var channel = 0; channel < 3; channel++)
                {
                    rgb[index * 3 + channel] = pixels[index * channels + (channels == 4 ? channel : 0)];
                }
            }

            return rgb;
        }
    }
}
