using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Reads the opacities of a volume property file of 3D Slicer (.vp): nine lines of numbers, the seventh the scalar opacity as a count of
    /// numbers and value, opacity pairs. Shading, gradient opacity and colours are not taken over: segments have colours of their own.
    /// </summary>
    public static class TransferFunctionFile
    {
        /// <summary>Files that are longer, bytes, are no volume properties.</summary>
        const long LargestSize = 1 << 20;

        const int ScalarOpacityLine = 6;

        /// <summary>Reads a file.</summary>
        /// <param name="path">The file.</param>
        /// <exception cref="VolumeFormatException">The file can't be read; says what stands where, and what was expected.</exception>
        public static OpacityTransferFunction Read(string path) => VolumeFile.Read(path, stream => Read(stream, path));

        /// <summary>Reads from a stream, from its position to its end.</summary>
        /// <param name="stream">Can be read and positioned; stays open.</param>
        /// <param name="name">What messages call it.</param>
        /// <exception cref="VolumeFormatException">The text can't be read; says what stands where, and what was expected.</exception>
        public static OpacityTransferFunction Read(Stream stream, string name)
        {
            VolumeFile.CheckStream(stream);
            var context = new ReadContext(name, "volume property", default, null);
            if (stream.Length - stream.Position > LargestSize)
                throw context.Refusal("the file's size", $"{stream.Length} bytes", "nine lines of a volume property (.vp)");
            string[] lines;
            using (var reader = new StreamReader(stream, Encoding.UTF8, false, 1024, leaveOpen: true))
                lines = reader.ReadToEnd().Replace("\r\n", "\n").Split('\n');
            if (lines.Length <= ScalarOpacityLine)
                throw context.Refusal("the number of lines", $"{lines.Length}", "nine, the seventh with the scalar opacity");
            return ScalarOpacity(lines[ScalarOpacityLine], context);
        }

        static OpacityTransferFunction ScalarOpacity(string line, ReadContext context)
        {
            string[] words = NrrdText.Words(line);
            if (words.Length == 0 || !NrrdText.TryWhole(words[0], out long count) || count < 2 || count % 2 != 0 || count != words.Length - 1)
                throw context.Refusal("line 7, the scalar opacity,", $"\"{NrrdHeader.Excerpt(line)}\"", "the count of the numbers that follow, then pairs of value and opacity");
            var points = new List<TransferPoint>();
            for (int n = 1; n < words.Length; n += 2)
            {
                if (!NrrdText.TryNumber(words[n], out double value) || !double.IsFinite(value)
                    || !NrrdText.TryNumber(words[n + 1], out double opacity) || !(opacity >= 0 && opacity <= 1))
                    throw context.Refusal("line 7, the scalar opacity,", $"\"{NrrdHeader.Excerpt(words[n] + " " + words[n + 1])}\"", "a finite value and an opacity of 0 to 1");
                points.Add(new TransferPoint(value, opacity));
            }

            return new OpacityTransferFunction(points);
        }
    }
}
