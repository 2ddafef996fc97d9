using System;
using System.Collections.Generic;
using System.Linq;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// The segments of an image with one or more layers: a (layer, value) pair each. Gives every segment a label of its own, since
    /// two layers may use the same value for different segments, and makes the table.
    /// </summary>
    sealed class LayeredLabels
    {
        readonly VolumeData data;
        readonly List<string> warnings;
        readonly List<Entry> entries = new List<Entry>();
        readonly HashSet<(int Layer, long Value)> claimed = new HashSet<(int Layer, long Value)>();
        readonly SortedSet<(int Layer, long Value)> unnamed = new SortedSet<(int Layer, long Value)>();
        int[] placeOfIndex;

        internal LayeredLabels(VolumeData data, List<string> warnings)
        {
            this.data = data;
            this.warnings = warnings;
            foreach (SegmentInfo info in data.Segments)
            {
                if (info.LabelValue == 0 || info.Layer >= data.Components)
                    warnings.Add(FormattableString.Invariant($"Segment {info} is left out: label 0 is the background, and the file has layers 0 to {data.Components - 1}."));
                else if (!claimed.Add((info.Layer, info.LabelValue)))
                    warnings.Add(FormattableString.Invariant($"Segment {info} is left out: an earlier segment has the same value in the same layer."));
                else
                    entries.Add(new Entry(info.Layer, info.LabelValue, info));
            }
        }

        /// <summary>The error of a file with more labels than there can be.</summary>
        internal static VolumeFormatException TooMany(VolumeData data, string found) => new VolumeFormatException(
            data.Source, "the number of labels", found,
            FormattableString.Invariant($"at most {SegmentTable.MaximumCount}, label 0 included (is this an intensity volume?)"));

        /// <summary>Takes note of the values that a layer's voxels have.</summary>
        internal void AddValues(int layer, IEnumerable<long> values)
        {
            foreach (long value in values)
                if (value != 0 && !claimed.Contains((layer, value)))
                    unnamed.Add((layer, value));
        }

        /// <summary>Makes the table, when every layer's values are known.</summary>
        internal SegmentTable MakeTable()
        {
            if (unnamed.Count > 0 && data.Segments.Count > 0)
                warnings.Add("The file names no segment for the values " + string.Join(", ", unnamed.Take(10).Select(pair => FormattableString.Invariant($"{pair.Value}")))
                    + (unnamed.Count > 10 ? FormattableString.Invariant($" and {unnamed.Count - 10} more.") : "."));

            // Values without a segment come first, so that named segments win where layers overlap.
            entries.InsertRange(0, unnamed.Select(pair => new Entry(pair.Layer, pair.Value, null)));
            if (entries.Count + 1 > SegmentTable.MaximumCount)
                throw TooMany(data, FormattableString.Invariant($"{entries.Count + 1}"));
            GiveLabels();
            var rows = new List<Segment> { new Segment(0, 0, SegmentTable.UnlabelledName, PredefinedSegmentColors.Unlabelled) };
            placeOfIndex = new int[entries.Count + 1];
            foreach (Entry entry in entries.OrderBy(entry => entry.Label))
            {
                entry.Index = (ushort)rows.Count;
                rows.Add(entry.ToSegment());
            }

            for (int place = 0; place < entries.Count; place++)
                placeOfIndex[entries[place].Index] = place + 1;
            return new SegmentTable(rows);
        }

        /// <summary>The table's row for each value of a layer; 0 for 0.</summary>
        internal Dictionary<long, ushort> IndexOfValue(int layer)
        {
            var indices = new Dictionary<long, ushort> { { 0, 0 } };
            foreach (Entry entry in entries.Where(entry => entry.Layer == layer))
                indices.Add(entry.Value, entry.Index);
            return indices;
        }

        /// <summary>The place of a table's row in the file's list: where segments overlap, the larger one wins.</summary>
        internal int PlaceInFile(int index) => placeOfIndex[index];

        /// <summary>A segment keeps its value as label if no other has it; else it takes the next number that is free.</summary>
        void GiveLabels()
        {
            long free = entries.Count == 0 ? 1 : Math.Max(0, entries.Max(entry => entry.Value)) + 1;
            var taken = new HashSet<long>();
            foreach (Entry entry in entries.OrderBy(entry => entry.Info == null))
            {
                entry.Label = entry.Value;
                if (!taken.Add(entry.Label))
                {
                    entry.Label = free++;
                    taken.Add(entry.Label);
                    warnings.Add(FormattableString.Invariant(
                        $"The value {entry.Value} means different segments in different layers; in layer {entry.Layer} it becomes label {entry.Label}."));
                }
            }
        }

        sealed class Entry
        {
            internal Entry(int layer, long value, SegmentInfo info)
            {
                Layer = layer;
                Value = value;
                Info = info;
            }

            internal int Layer { get; }

            internal long Value { get; }

            internal SegmentInfo Info { get; }

            internal long Label { get; set; }

            internal ushort Index { get; set; }

            internal Segment ToSegment()
            {
                string name = !string.IsNullOrWhiteSpace(Info?.Name) ? Info.Name : Info?.Id;
                name = string.IsNullOrWhiteSpace(name) ? FormattableString.Invariant($"Label {Label}") : name;
                SegmentColor color = Info?.Color
                    ?? (Info != null && PredefinedSegmentColors.TryForName(name, out SegmentColor known) ? known : PredefinedSegmentColors.ForLabel(Label));
                return new Segment(Index, Label, name, color);
            }
        }
    }
}
