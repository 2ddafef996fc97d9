using System.Collections.Generic;
using System.Globalization;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>The numbers of a segment table as texts, each made once when it is first seen.</summary>
    sealed class SegmentTexts
    {
        SegmentTable labelsOf;
        IReadOnlyList<long> countsOf;
        string[] labels, counts;

        /// <summary>A row's label.</summary>
        public string Label(SegmentTable table, int row)
        {
            if (!ReferenceEquals(table, labelsOf))
            {
                labels = labels != null && SameLabels(table, labelsOf) ? labels : new string[table.Count];
                labelsOf = table;
            }
            return labels[row] ??= table[row].Label.ToString(CultureInfo.InvariantCulture);
        }

        /// <summary>A row's number of voxels.</summary>
        /// <param name="voxelCounts">One number for each row; null = not known yet.</param>
        /// <param name="row">The row.</param>
        public string Voxels(IReadOnlyList<long> voxelCounts, int row)
        {
            if (voxelCounts == null)
                return "...";
            if (!ReferenceEquals(voxelCounts, countsOf))
            {
                countsOf = voxelCounts;
                counts = new string[voxelCounts.Count];
            }
            return counts[row] ??= voxelCounts[row].ToString("N0", CultureInfo.InvariantCulture);
        }

        /// <summary>A table whose colours or opacities were edited is another object with the same labels.</summary>
        static bool SameLabels(SegmentTable a, SegmentTable b)
        {
            if (a.Count != b.Count)
                return false;
            for (int row = 0; row < a.Count; row++)
                if (a[row].Label != b[row].Label)
                    return false;
            return true;
        }
    }
}
