using System;
using System.Buffers.Binary;
using System.Globalization;
using System.IO;
using System.Text;

namespace AnatomyCarve.Headless.Cli.Files
{
    /// <summary>Portable grey map of 16 bits: "P5", width and height, 65535, then big-endian values, the top row first.</summary>
    static class PgmFile
    {
        public static void Write(Stream stream, int width, int height, ushort[] rowsFromTop)
        {
            stream.Write(Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"P5\n{width} {height}\n65535\n")));
            var bytes = new byte[rowsFromTop.Length * sizeof(ushort)];
            for (var index = 0; index < rowsFromTop.Length; index++)
            {
                BinaryPrimitives.WriteUInt16BigEndian(bytes.AsSpan(index * sizeof(ushort)), rowsFromTop[index]);
            }

            stream.Write(bytes);
        }

        /// <exception cref="PictureFileException">The file is not such a map.</exception>
        public static Plane<ushort> Read(string path)
        {
            var reader = new HeaderReader(path);
            if (reader.Word() != "P5") throw reader.Refusal("it does not begin with P5");
            int width = reader.Size("width"), height = reader.Size("height");
            if (reader.Word() != "65535") throw reader.Refusal("its largest value is not 65535");
            var bytes = reader.Rest((long)width * height * sizeof(ushort));
            var values = new ushort[width * height];
            for (var index = 0; index < values.Length; index++)
            {
                values[index] = BinaryPrimitives.ReadUInt16BigEndian(bytes[(index * sizeof(ushort))..]);
            }

            return new Plane<ushort>(width, height, values);
        }
    }
}
