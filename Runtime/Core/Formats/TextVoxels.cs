using System;
using System.Globalization;
using System.IO;
using System.Text;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Reads voxels that are written as decimal numbers, parted by blanks, commas or line ends.</summary>
    static class TextVoxels
    {
        /// <summary>No number is longer; more than this without a blank is no text.</summary>
        const int LongestNumber = 400;

        const int NumbersPerReport = 65536;

        /// <summary>Reads numbers, and refuses the file when one can't be read or they end too early.</summary>
        internal static Array Read(Stream stream, VoxelType type, long count, ReadContext context)
        {
            // A number takes a digit, and a blank to the next one.
            long largest = (stream.Length - stream.Position + 1) / 2;
            if (count > largest)
                throw context.Refusal("the voxel data", $"too short (the text can hold {largest} numbers at most)", FormattableString.Invariant($"{count} numbers, as the header says"));
            Array voxels = Array.CreateInstance(type.ElementType(), count);
            Action<int, string> store = Storing(voxels, type);
            using (var reader = new StreamReader(stream, Encoding.ASCII, false, 65536, leaveOpen: true))
            {
                var word = new StringBuilder();
                for (int n = 0; n < count; n++)
                {
                    if (n % NumbersPerReport == 0)
                    {
                        context.Cancellation.ThrowIfCancellationRequested();
                        context.Progress?.Report((float)n / count);
                    }

                    NextWord(reader, word, context);
                    if (word.Length == 0)
                        throw context.Refusal("the voxel data", $"cut off after {n} numbers", FormattableString.Invariant($"{count} numbers, as the header says"));
                    try
                    {
                        store(n, word.ToString());
                    }
                    catch (Exception problem) when (problem is FormatException || problem is OverflowException)
                    {
                        throw context.Refusal("the voxel data", $"\"{NrrdHeader.Excerpt(word.ToString())}\" as number {n}", "a number of the type " + type, problem);
                    }
                }
            }

            context.Progress?.Report(1);
            return voxels;
        }

        static void NextWord(StreamReader reader, StringBuilder word, ReadContext context)
        {
            word.Clear();
            int letter;
            while ((letter = reader.Read()) >= 0)
            {
                bool parts = letter <= ' ' || letter == ',';
                if (!parts)
                    word.Append((char)letter);
                else if (word.Length > 0)
                    return;
                if (word.Length > LongestNumber)
                    throw context.Refusal("the voxel data", $"\"{NrrdHeader.Excerpt(word.ToString())}\"", "numbers, parted by blanks");
            }
        }

        static Action<int, string> Storing(Array voxels, VoxelType type)
        {
            CultureInfo culture = CultureInfo.InvariantCulture;
            const NumberStyles Whole = NumberStyles.AllowLeadingSign;
            switch (type)
            {
                case VoxelType.Int8:
                    return (n, text) => ((sbyte[])voxels)[n] = sbyte.Parse(text, Whole, culture);
                case VoxelType.UInt8:
                    return (n, text) => ((byte[])voxels)[n] = byte.Parse(text, Whole, culture);
                case VoxelType.Int16:
                    return (n, text) => ((short[])voxels)[n] = short.Parse(text, Whole, culture);
                case VoxelType.UInt16:
                    return (n, text) => ((ushort[])voxels)[n] = ushort.Parse(text, Whole, culture);
                case VoxelType.Int32:
                    return (n, text) => ((int[])voxels)[n] = int.Parse(text, Whole, culture);
                case VoxelType.UInt32:
                    return (n, text) => ((uint[])voxels)[n] = uint.Parse(text, Whole, culture);
                case VoxelType.Int64:
                    return (n, text) => ((long[])voxels)[n] = long.Parse(text, Whole, culture);
                case VoxelType.UInt64:
                    return (n, text) => ((ulong[])voxels)[n] = ulong.Parse(text, Whole, culture);
                case VoxelType.Float32:
                    return (n, text) => ((float[])voxels)[n] = float.TryParse(text, NumberStyles.Float, culture, out float single) ? single : (float)Special(text);
                default:
                    return (n, text) => ((double[])voxels)[n] = Special(text);
            }
        }

        static double Special(string text) => NrrdText.TryNumber(text, out double number) ? number : throw new FormatException();
    }
}
