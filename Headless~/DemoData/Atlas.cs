using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace AnatomyCarve.Headless.DemoData
{
    /// <summary>The names of the demo's segments by label: the atlas's own, spelled as the atlas spells them, and the two that are added.</summary>
    static class Atlas
    {
        public const int RegionCount = 116;

        /// <summary>Reads lines "label name number" (aal.nii.txt).</summary>
        public static SortedDictionary<byte, string> ReadNames(string path)
        {
            var names = new SortedDictionary<byte, string>();
            foreach (var line in File.ReadAllLines(path))
            {
                var words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
                if (words.Length == 0) continue;
                if (words.Length != 3 || !byte.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out var label))
                {
                    throw new InvalidDataException($"{path}: \"{line}\" is not a line \"label name number\".");
                }

                names.Add(label, words[1]);
            }

            if (names.Count != RegionCount) throw new InvalidDataException($"{path}: {names.Count} regions instead of {RegionCount}.");
            names.Add(HeadLabels.BrainOther, "brain, other");
            names.Add(HeadLabels.Head, "head");
            return names;
        }
    }
}
