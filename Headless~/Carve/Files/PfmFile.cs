using System;
using System.Globalization;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

namespace AnatomyCarve.Headless.Cli.Files
{
    /// <summary>
    /// Portable float map, one channel: "Pf", width and height, a scale whose sign is the byte order, then 32-bit floats, the
    /// LOWEST row of the picture first, as the format has it. In memory the first row is the top one.
    /// </summary>
    static class PfmFile
    {
        /// <summary>Writes little-endian floats.</summary>
        public static void Write(Stream stream, int width, int height, float[] rowsFromTop)
        {
            stream.Write(Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"Pf\n{width} {height}\n-1.0\n")));
            for (var row = height - 1; row >= 0; row--)
            {
                stream.Write(MemoryMarshal.AsBytes(rowsFromTop.AsSpan(row * width, width)));
            }
        }

        /// <exception cref="PictureFileException">The file is not such a map.</exception>
        public static Plane<float> Read(string path)
        {
            var reader = new HeaderReader(path);
            if (reader.Word() != "Pf") throw reader.Refusal("it does not begin with Pf");
            int width = reader.Size("width"), height = reader.Size("height");
            if (!double.TryParse(reader.Word(), NumberStyles.Float, CultureInfo.InvariantCulture, out var scale) || scale == 0)
            {
                throw reader.Refusal("its scale is not a number other than 0");
            }

            var bytes = reader.Rest((long)width * height * sizeof(float));
            var values = new float[width * height];
            for (var y = 0; y < height; y++)
            {
                for (var x = 0; x < width; x++)
                {
                    var source = bytes.Slice(((height - 1 - y) * width + x) * sizeof(float), sizeof(float));
                    values[y * width + x] = scale < 0
                        ? System.Buffers.Binary.BinaryPrimitives.ReadSingleLittleEndian(source)
                        : System.Buffers.Binary.BinaryPrimitives.ReadSingleBigEndian(source);
                }
            }

            return new Plane<float>(width, height, values);
        }
    }
}
