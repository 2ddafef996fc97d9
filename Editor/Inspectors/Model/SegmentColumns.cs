using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>Where a segment table's columns lie in a row, and in the row of their titles. Narrow Inspectors do without some of them.</summary>
    readonly struct SegmentColumns
    {
        const float Gap = 4f, Eye = 18f, Swatch = 36f, Slider = 120f, Clip = 24f, LabelWidth = 52f, Count = 72f, NarrowestName = 90f;

        /// <param name="row">The row.</param>
        /// <param name="editable">With colour, opacity and mask to edit; otherwise only with what describes a segment.</param>
        public SegmentColumns(Rect row, bool editable)
        {
            float x = row.x, end = row.xMax;
            float name = row.width - LabelWidth - Gap - Swatch - Gap - (editable ? Eye + Gap + Slider + Gap + Clip + Gap : 0f);
            bool wide = name - Count - Gap >= NarrowestName;
            bool labelled = name >= NarrowestName;
            Visible = editable ? Left(row, ref x, Eye) : Hidden(row);
            Color = Left(row, ref x, Swatch);
            Clipped = editable ? Right(row, ref end, Clip) : Hidden(row);
            Voxels = wide ? Right(row, ref end, Count) : Hidden(row);
            Label = labelled ? Right(row, ref end, LabelWidth) : Hidden(row);
            float slider = Mathf.Clamp(end - x - NarrowestName - Gap, 24f, Slider);
            Opacity = editable ? Left(row, ref x, slider) : Hidden(row);
            Name = new Rect(x, row.y, Mathf.Max(0f, end - x), row.height);
        }

        /// <summary>Whether the segment is shown at all.</summary>
        public Rect Visible { get; }

        public Rect Color { get; }

        public Rect Opacity { get; }

        public Rect Name { get; }

        /// <summary>The segment's label; without width where there is no room.</summary>
        public Rect Label { get; }

        /// <summary>How many voxels it has; without width where there is no room.</summary>
        public Rect Voxels { get; }

        /// <summary>Whether the active sphere clips it.</summary>
        public Rect Clipped { get; }

        static Rect Left(Rect row, ref float x, float width)
        {
            var rect = new Rect(x, row.y, width, row.height);
            x += width + Gap;
            return rect;
        }

        static Rect Right(Rect row, ref float end, float width)
        {
            end -= width;
            var rect = new Rect(end, row.y, width, row.height);
            end -= Gap;
            return rect;
        }

        static Rect Hidden(Rect row) => new Rect(row.x, row.y, 0f, row.height);
    }
}
