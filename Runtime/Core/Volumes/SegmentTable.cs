using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// The segments of a volume by dense index. Row 0 is always label 0, tissue that no segment claims; the others follow in
    /// ascending order of their labels. Immutable: an edit gives a new table.
    /// </summary>
    public sealed class SegmentTable : IReadOnlyList<Segment>
    {
        /// <summary>
        /// The largest number of segments, label 0 included, of tables, label maps and masks: dense indices are 16 bit, and index 65,535 means "no segment" in
        /// pictures.
        /// </summary>
        public const int MaximumCount = 65535;

        /// <summary>The name of row 0 where a file gives none.</summary>
        public const string UnlabelledName = "Unlabelled";

        readonly Segment[] segments;
        readonly Dictionary<long, int> indexOfLabel;

        /// <summary>Makes a table from its rows.</summary>
        /// <param name="segments">Row 0 with label 0, then ascending by label; each row's index is its place.</param>
        /// <exception cref="ArgumentException">No row, more than 65,535 rows, row 0 without label 0, rows out of order, or a wrong index.</exception>
        public SegmentTable(IEnumerable<Segment> segments)
        {
            this.segments = (segments ?? throw new ArgumentNullException(nameof(segments))).ToArray();
            if (this.segments.Length == 0 || this.segments.Length > MaximumCount)
                throw new ArgumentException(FormattableString.Invariant($"A segment table has 1 to {MaximumCount} rows, label 0 included, not {this.segments.Length}."), nameof(segments));
            indexOfLabel = new Dictionary<long, int>(this.segments.Length);
            for (int index = 0; index < this.segments.Length; index++)
            {
                Segment segment = this.segments[index];
                bool inOrder = index == 0 ? segment.Label == 0 : index == 1 || segment.Label > this.segments[index - 1].Label;
                if (segment.Index != index || !inOrder || !indexOfLabel.TryAdd(segment.Label, index))
                    throw new ArgumentException(
                        FormattableString.Invariant($"Row {index} of a segment table holds index {segment.Index}, label {segment.Label}; expected label 0 in row 0, then ascending labels."),
                        nameof(segments));
            }
        }

        SegmentTable(Segment[] segments, Dictionary<long, int> indexOfLabel)
        {
            this.segments = segments;
            this.indexOfLabel = indexOfLabel;
        }

        /// <summary>The number of rows, at least 1.</summary>
        public int Count => segments.Length;

        /// <summary>A row.</summary>
        /// <param name="index">0 to <see cref="Count"/> - 1.</param>
        public Segment this[int index] => segments[index];

        /// <summary>The table of a volume without segments: row 0 alone.</summary>
        public static SegmentTable UnlabelledOnly() =>
            new SegmentTable(new[] { new Segment(0, 0, UnlabelledName, PredefinedSegmentColors.Unlabelled) });

        /// <summary>The row of a label, or -1 when no segment has it.</summary>
        public int IndexOfLabel(long label) => indexOfLabel.TryGetValue(label, out int index) ? index : -1;

        /// <summary>The first segment of a name (upper and lower case are the same), or null.</summary>
        public Segment FindByName(string name) =>
            Array.Find(segments, segment => string.Equals(segment.Name, name, StringComparison.OrdinalIgnoreCase));

        /// <summary>A table in which one segment has another opacity, 0 to 1.</summary>
        /// <exception cref="ArgumentException">No such row, or the opacity is outside 0..1.</exception>
        public SegmentTable WithOpacity(int index, float opacity) => With(index, Row(index).WithOpacity(opacity));

        /// <summary>A table in which one segment has another colour.</summary>
        /// <exception cref="ArgumentException">No such row.</exception>
        public SegmentTable WithColor(int index, SegmentColor color) => With(index, Row(index).WithColor(color));

        /// <summary>A table in which one segment has another name.</summary>
        /// <exception cref="ArgumentException">No such row, or the name is null.</exception>
        public SegmentTable WithName(int index, string name) => With(index, Row(index).WithName(name));

        /// <summary>A table in which several segments have other colours and opacities. Labels that the table does not have are passed over.</summary>
        /// <param name="changes">Label, colour and opacity, 0 to 1; of several for one label the last counts.</param>
        /// <exception cref="ArgumentException">An opacity is outside 0..1.</exception>
        public SegmentTable With(IEnumerable<(long label, SegmentColor color, float opacity)> changes)
        {
            var changed = (Segment[])segments.Clone();
            foreach ((long label, SegmentColor color, float opacity) in changes ?? throw new ArgumentNullException(nameof(changes)))
                if (indexOfLabel.TryGetValue(label, out int index))
                    changed[index] = changed[index].WithColor(color).WithOpacity(opacity);
            return new SegmentTable(changed, indexOfLabel);
        }

        /// <inheritdoc/>
        public IEnumerator<Segment> GetEnumerator() => ((IEnumerable<Segment>)segments).GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        Segment Row(int index)
        {
            if (index < 0 || index >= segments.Length)
                throw new ArgumentOutOfRangeException(nameof(index), index, FormattableString.Invariant($"The table has rows 0 to {segments.Length - 1}."));
            return segments[index];
        }

        SegmentTable With(int index, Segment segment)
        {
            var changed = (Segment[])segments.Clone();
            changed[index] = segment;
            return new SegmentTable(changed, indexOfLabel);
        }
    }
}
