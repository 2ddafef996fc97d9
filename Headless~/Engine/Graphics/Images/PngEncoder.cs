using System;
using System.IO;
using System.IO.Compression;

namespace UnityEngine
{
    /// <summary>Writes PNG files: grey, RGB or RGBA with 8 or 16 bits, without gamma and colour profile.</summary>
    static class PngEncoder
    {
        static readonly byte[] s_Signature = { 0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A };

        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        /// <param name="channels">1 grey, 2 grey and alpha, 3 RGB, 4 RGBA.</param>
        /// <param name="bits">8, or 16 with the high byte first.</param>
        /// <param name="topRow">The samples, top row first.</param>
        internal static byte[] Encode(int width, int height, int channels, int bits, byte[] topRow)
        {
            using var output = new MemoryStream();
            output.Write(s_Signature, 0, s_Signature.Length);
            var header = new byte[13];
            BigEndian(header, 0, (uint)width);
            BigEndian(header, 4, (uint)height);
            header[8] = (byte)bits;
            header[9] = channels switch { 1 => 0, 2 => 4, 3 => 2, _ => 6 };
            Chunk(output, "IHDR", header);
            Chunk(output, "IDAT", Compress(Filter(topRow, width * channels * bits / 8, height, channels * bits / 8)));
            Chunk(output, "IEND", Array.Empty<byte>());
            return output.ToArray();
        }

        // Filter 2 (difference to the row above) suits pictures with large even areas, and costs next to nothing.
        static byte[] Filter(byte[] rows, int stride, int height, int pixel)
        {
            var filtered = new byte[(stride + 1) * height];
            for (var y = 0; y < height; y++)
            {
                var target = y * (stride + 1);
                var source = y * stride;
                filtered[target++] = (byte)(y == 0 ? 1 : 2);
                for (var x = 0; x < stride; x++)
                {
                    var before = y == 0 ? x >= pixel ? rows[source + x - pixel] : 0 : rows[source + x - stride];
                    filtered[target + x] = (byte)(rows[source + x] - before);
                }
            }
            return filtered;
        }

        // The zlib format by hand: .NET Standard 2.1 has the bare deflate stream only.
        static byte[] Compress(byte[] data)
        {
            using var output = new MemoryStream();
            output.WriteByte(0x78);
            output.WriteByte(0x9C);
            using (var deflate = new DeflateStream(output, CompressionLevel.Optimal, leaveOpen: true))
                deflate.Write(data, 0, data.Length);
            var checksum = new byte[4];
            BigEndian(checksum, 0, Checksums.Adler32(data));
            output.Write(checksum, 0, 4);
            return output.ToArray();
        }

        static void Chunk(Stream output, string type, byte[] data)
        {
            var head = new byte[4];
            BigEndian(head, 0, (uint)data.Length);
            output.Write(head, 0, 4);
            var body = new byte[4 + data.Length];
            for (var i = 0; i < 4; i++)
                body[i] = (byte)type[i];
            Buffer.BlockCopy(data, 0, body, 4, data.Length);
            output.Write(body, 0, body.Length);
            BigEndian(head, 0, Checksums.Crc32(body, 0, body.Length));
            output.Write(head, 0, 4);
        }

        static void BigEndian(byte[] target, int at, uint value)
        {
            for (var i = 0; i < 4; i++)
                target[at + i] = (byte)(value >> (24 - 8 * i));
        }
    }
}
