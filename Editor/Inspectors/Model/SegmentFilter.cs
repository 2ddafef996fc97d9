using System;
using System.Collections.Generic;
using System.Globalization;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// The rows of a segment table that a search leaves: those where each word occurs in the name, whatever the case, or begins the label.
    /// </summary>
    sealed class SegmentFilter
    {
        static readonly char[] Blanks = { ' ', '\t', ',' };

        readonly List<int> rows = new List<int>();
        SegmentTable filtered;
        string search = "";
        string[] words = Array.Empty<string>();

        /// <summary>What is searched for; empty = every row is left.</summary>
        public string Search
        {
            get => search;
            set
            {
                value ??= "";
                if (value == search)
                    return;
                search = value;
                words = value.Split(Blanks, StringSplitOptions.RemoveEmptyEntries);
                filtered = null;
            }
        }

        /// <summary>Indices of the rows that are left, ascending. The list is used again.</summary>
        public IReadOnlyList<int> Rows(SegmentTable table)
        {
            if (!ReferenceEquals(table, filtered))
            {
                filtered = table;
                rows.Clear();
                for (int row = 0; table != null && row < table.Count; row++)
                    if (IsLeft(table[row]))
                        rows.Add(row);
            }
            return rows;
        }

        bool IsLeft(Segment segment)
        {
            foreach (string word in words)
                if (segment.Name.IndexOf(word, StringComparison.OrdinalIgnoreCase) < 0 && !BeginsLabel(word, segment.Label))
                    return false;
            return true;
        }

        static bool BeginsLabel(string word, long label) =>
            (word[0] == '-' || (word[0] >= '0' && word[0] <= '9'))
            && label.ToString(CultureInfo.InvariantCulture).StartsWith(word, StringComparison.Ordinal);
    }
}
