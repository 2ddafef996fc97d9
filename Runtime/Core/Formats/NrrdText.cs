using System;
using System.Collections.Generic;
using System.Globalization;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Reads what stands in the fields of an NRRD header: lists of numbers, vectors, words in quotes.</summary>
    static class NrrdText
    {
        static readonly char[] Blanks = { ' ', '\t' };

        /// <summary>Splits at blanks.</summary>
        internal static string[] Words(string text) => text.Split(Blanks, StringSplitOptions.RemoveEmptyEntries);

        /// <summary>A number, "nan" and "inf" included; invariant culture.</summary>
        internal static bool TryNumber(string text, out double number)
        {
            if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out number))
                return true;
            switch (text.ToUpperInvariant())
            {
                case "NAN":
                case "-NAN":
                    number = double.NaN;
                    return true;
                case "INF":
                case "+INF":
                    number = double.PositiveInfinity;
                    return true;
                case "-INF":
                    number = double.NegativeInfinity;
                    return true;
                default:
                    return false;
            }
        }

        /// <summary>A whole number; invariant culture.</summary>
        internal static bool TryWhole(string text, out long number) =>
            long.TryParse(text, NumberStyles.AllowLeadingSign | NumberStyles.AllowLeadingWhite | NumberStyles.AllowTrailingWhite, CultureInfo.InvariantCulture, out number);

        /// <summary>A field that is one whole number; <paramref name="otherwise"/> when the header doesn't have it.</summary>
        internal static long Whole(NrrdHeader header, string field, long otherwise, ReadContext context)
        {
            string text = header.Find(field);
            if (text == null)
                return otherwise;
            return TryWhole(text, out long number) ? number : throw context.Refusal(field, $"\"{NrrdHeader.Excerpt(text)}\"", "a whole number");
        }

        /// <summary>A list of vectors in brackets and of the word none, which becomes null, as does a vector of NaNs alone.</summary>
        internal static List<VectorMm?> Vectors(string field, string text, ReadContext context)
        {
            var vectors = new List<VectorMm?>();
            for (int place = 0; place < text.Length;)
            {
                if (char.IsWhiteSpace(text[place]))
                {
                    place++;
                }
                else if (string.CompareOrdinal(text, place, "none", 0, 4) == 0)
                {
                    vectors.Add(null);
                    place += 4;
                }
                else
                {
                    int end = text[place] == '(' ? text.IndexOf(')', place) : -1;
                    string[] numbers = end < 0 ? Array.Empty<string>() : text.Substring(place + 1, end - place - 1).Split(',');
                    if (numbers.Length != 3 || !TryNumber(numbers[0].Trim(), out double x) || !TryNumber(numbers[1].Trim(), out double y) || !TryNumber(numbers[2].Trim(), out double z))
                        throw context.Refusal(field, $"\"{NrrdHeader.Excerpt(text.Substring(place))}\"", "vectors of three numbers, such as (1,0,0), or none");
                    bool none = double.IsNaN(x) && double.IsNaN(y) && double.IsNaN(z);
                    vectors.Add(none ? (VectorMm?)null : new VectorMm(x, y, z));
                    place = end + 1;
                }
            }

            return vectors;
        }

        /// <summary>The words between double quotes; the words between blanks where there are no quotes.</summary>
        internal static string[] Quoted(string text)
        {
            if (text.IndexOf('"') < 0)
                return Words(text);
            string[] parts = text.Split('"');
            var words = new List<string>();
            for (int n = 1; n < parts.Length; n += 2)
                words.Add(parts[n]);
            return words.ToArray();
        }
    }
}
