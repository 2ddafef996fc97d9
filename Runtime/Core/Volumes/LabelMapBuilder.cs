using System;
using System.Collections;
using System.Collections.Generic;
using System.Threading;

namespace AnatomyCarve.Volumes
{
    /// <summary>Makes a label map from an image: finds the values of each layer, makes the table, merges the layers.</summary>
    sealed class LabelMapBuilder
    {
        /// <summary>Whole numbers up to this one, 2^53, are exact in double precision.</summary>
        const double LargestLabel = 9007199254740992;

        readonly VolumeData data;
        readonly CancellationToken cancellation;
        readonly IProgress<float> progress;
        readonly List<string> warnings = new List<string>();
        BitArray overlaps;
        int overlapping;
        float passes;

        internal LabelMapBuilder(VolumeData data, CancellationToken cancellation, IProgress<float> progress)
        {
            this.data = data;
            this.cancellation = cancellation;
            this.progress = progress;
        }

        internal LabelMap Build()
        {
            if (data.Components > 1 && data.Segments.Count == 0)
                throw new VolumeFormatException(
                    data.Source, "components", FormattableString.Invariant($"{data.Components} values per voxel"), "one label per voxel, or layers whose segments the file names");
            var labels = new LayeredLabels(data, warnings);
            for (int layer = 0; layer < data.Components; layer++)
                labels.AddValues(layer, DistinctValues(layer));
            SegmentTable table = labels.MakeTable();
            var indices = new ushort[data.Geometry.VoxelCount];
            for (int layer = 0; layer < data.Components; layer++)
                Merge(layer, labels, indices);
            if (overlapping > 0)
                warnings.Add(FormattableString.Invariant($"Several segments claim {overlapping} of the voxels; there the segment is shown that the file lists last."));
            return new LabelMap(data.Geometry, indices, table, warnings);
        }

        HashSet<long> DistinctValues(int layer)
        {
            var found = new HashSet<long>();
            double last = double.NaN;
            ComponentBlocks.ForEach(data, layer, cancellation, (values, start, count) =>
            {
                for (int n = 0; n < count; n++)
                {
                    double value = values[n];

                    // Neighbours mostly have the same label.
                    if (value == last)
                        continue;

                    // Written so that NaN fails too.
                    if (!(Math.Abs(value) <= LargestLabel && Math.Floor(value) == value))
                        throw new VolumeFormatException(
                            data.Source, "a voxel", FormattableString.Invariant($"{value} (voxel number {start + n})"), "a whole number, as label maps have");
                    last = value;
                    if (found.Add((long)value) && found.Count > SegmentTable.MaximumCount)
                        throw LayeredLabels.TooMany(data, FormattableString.Invariant($"more than {SegmentTable.MaximumCount}"));
                }

                Report(start + count);
            });
            passes++;
            return found;
        }

        void Merge(int layer, LayeredLabels labels, ushort[] indices)
        {
            Dictionary<long, ushort> indexOfValue = labels.IndexOfValue(layer);
            double last = 0;
            ushort lastIndex = 0;
            ComponentBlocks.ForEach(data, layer, cancellation, (values, start, count) =>
            {
                for (int n = 0; n < count; n++)
                {
                    if (values[n] != last)
                    {
                        last = values[n];
                        lastIndex = indexOfValue[(long)last];
                    }

                    if (lastIndex == 0)
                        continue;
                    ushort present = indices[start + n];
                    if (present != 0)
                        CountOverlap(start + n, indices.Length);

                    if (present == 0 || labels.PlaceInFile(lastIndex) > labels.PlaceInFile(present))
                        indices[start + n] = lastIndex;
                }

                Report(start + count);
            });
            passes++;
        }

        /// <summary>Several layers may claim a voxel; it counts once.</summary>
        void CountOverlap(int voxel, int voxels)
        {
            overlaps ??= new BitArray(voxels);
            if (overlaps[voxel])
                return;
            overlaps[voxel] = true;
            overlapping++;
        }

        void Report(int voxelsDone) =>
            progress?.Report((passes + ((float)voxelsDone / data.Geometry.VoxelCount)) / (2 * data.Components));
    }
}
