using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Reads the segments that 3D Slicer writes into a .seg.nrrd file as key/value pairs "SegmentN_Name:=...". As Slicer does, it stops at
    /// the first number without an ID.
    /// </summary>
    static class SlicerSegments
    {
        const string Prefix = "Segment";

        /// <summary>Adds the segments to the file's description; one that can't be used is left out with a warning.</summary>
        /// <param name="layers">The number of components.</param>
        internal static void AddTo(ReadContext context, long layers)
        {
            IDictionary<string, string> keys = context.Description.Metadata;
            int count = 0;
            while (keys.ContainsKey(FormattableString.Invariant($"{Prefix}{count}_ID")))
            {
                SegmentInfo segment = Read(keys, count, layers, context);
                if (segment != null)
                    context.Description.Segments.Add(segment);
                count++;
            }

            long[] beyond = keys.Keys.Select(NumberOf).Where(number => number >= count).Distinct().OrderBy(number => number).ToArray();
            if (beyond.Length > 0)
                context.Warn($"Segment{count}_ID is missing; Segment{beyond[0]} and any behind it are left out, as 3D Slicer does.");
        }

        static SegmentInfo Read(IDictionary<string, string> keys, int number, long layers, ReadContext context)
        {
            string Text(string part) => keys.TryGetValue(FormattableString.Invariant($"{Prefix}{number}_{part}"), out string value) ? value : null;

            // Slicer 4.10 and older wrote neither: one layer of 0 and 1 per segment.
            long layer = Whole(Text("Layer"), layers == 1 ? 0 : number);
            long label = Whole(Text("LabelValue"), 1);
            if (layer < 0 || layer >= layers)
            {
                context.Warn($"Segment{number} is left out: its layer is \"{Text("Layer")}\", and the file has layers 0 to {layers - 1}.");
                return null;
            }

            if (label == long.MinValue)
            {
                context.Warn($"Segment{number} is left out: its label value is \"{Text("LabelValue")}\", no whole number.");
                return null;
            }

            return new SegmentInfo(
                Text("ID"), Text("Name"), label, (int)layer, Color(Text("Color"), number, context), Text("Tags"), Extent(Text("Extent"), number, context));
        }

        /// <summary>A whole number; the alternative where the file has none; <see cref="long.MinValue"/> for any other text.</summary>
        static long Whole(string text, long otherwise) =>
            text == null ? otherwise : NrrdText.TryWhole(text, out long number) ? number : long.MinValue;

        static SegmentColor? Color(string text, int number, ReadContext context)
        {
            if (text == null)
                return null;
            string[] words = NrrdText.Words(text);
            if (words.Length == 3 && TryChannel(words[0], out double red) && TryChannel(words[1], out double green) && TryChannel(words[2], out double blue))
                return SegmentColor.FromFloats(red, green, blue);
            context.Warn($"Segment{number}_Color is \"{NrrdHeader.Excerpt(text)}\", expected three numbers of 0 to 1; a predefined colour is used.");
            return null;
        }

        static bool TryChannel(string text, out double channel) =>
            NrrdText.TryNumber(text, out channel) && channel >= 0 && channel <= 1;

        static int[] Extent(string text, int number, ReadContext context)
        {
            if (text == null)
                return null;
            var extent = new List<int>();
            foreach (string word in NrrdText.Words(text))
                if (NrrdText.TryWhole(word, out long index) && index >= int.MinValue && index <= int.MaxValue)
                    extent.Add((int)index);
            if (extent.Count == 6)
                return extent.ToArray();
            context.Warn($"Segment{number}_Extent is \"{NrrdHeader.Excerpt(text)}\", expected six whole numbers; it is ignored.");
            return null;
        }

        /// <summary>N of "SegmentN_...", or -1 for any other key.</summary>
        static long NumberOf(string key)
        {
            int end = key.IndexOf('_');
            return key.StartsWith(Prefix, StringComparison.Ordinal) && end > Prefix.Length
                && NrrdText.TryWhole(key.Substring(Prefix.Length, end - Prefix.Length), out long number) ? number : -1;
        }
    }
}
