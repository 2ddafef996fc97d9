using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Segment tables for tests.</summary>
    static class SegmentTables
    {
        /// <summary>Unlabelled tissue, then a few segments with labels that leave gaps.</summary>
        public static readonly SegmentTable Some = Of(
            (0, "Unlabelled"), (5, "liver"), (11, "Kidney left"), (12, "Kidney right"), (118, "head of femur, left"));

        public static SegmentTable Of(params (long label, string name)[] rows) => new SegmentTable(rows.Select(
            (row, index) => new Segment(index, row.label, row.name, new SegmentColor((byte)(10 * index), 100, 200))));

        public static SegmentTable Many(int count) => new SegmentTable(Enumerable.Range(0, count).Select(
            index => new Segment(index, index, "Segment " + index, new SegmentColor(1, 2, 3))));
    }
}
