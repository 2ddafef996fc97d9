using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>Bytes for files that tests write in memory.</summary>
    public static class VoxelBytes
    {
        /// <summary>An array of numbers as bytes in one of both orders.</summary>
        public static byte[] Of(Array voxels, bool bigEndian)
        {
            var bytes = new byte[Buffer.ByteLength(voxels)];
            Buffer.BlockCopy(voxels, 0, bytes, 0, bytes.Length);
            int size = voxels.Length == 0 ? 1 : bytes.Length / voxels.Length;
            for (int place = 0; bigEndian == BitConverter.IsLittleEndian && place < bytes.Length; place += size)
                Array.Reverse(bytes, place, size);
            return bytes;
        }

        /// <summary>One gzip member.</summary>
        public static byte[] Gzip(byte[] bytes)
        {
            using (var target = new MemoryStream())
            {
                using (var gzip = new GZipStream(target, CompressionLevel.Fastest, leaveOpen: true))
                    gzip.Write(bytes, 0, bytes.Length);
                return target.ToArray();
            }
        }

        /// <summary>Several arrays behind each other.</summary>
        public static byte[] Join(params byte[][] parts)
        {
            var all = new List<byte>();
            foreach (byte[] part in parts)
                all.AddRange(part);
            return all.ToArray();
        }

        /// <summary>A part of an array.</summary>
        public static byte[] Part(byte[] bytes, int start, int count)
        {
            var part = new byte[count];
            Array.Copy(bytes, start, part, 0, count);
            return part;
        }
    }
}
