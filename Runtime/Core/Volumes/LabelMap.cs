using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace AnatomyCarve.Volumes
{
    /// <summary>Which segment each voxel belongs to, as dense indices into a <see cref="SegmentTable"/>. Immutable.</summary>
    public sealed class LabelMap
    {
        readonly Lazy<IReadOnlyList<long>> voxelCounts;

        /// <summary>Makes a label map from its indices. The array is kept, not copied.</summary>
        /// <param name="geometry">Where the voxels lie.</param>
        /// <param name="indices">One row of the table per voxel, i fastest.</param>
        /// <param name="segments">The table.</param>
        /// <param name="warnings">What was odd, a sentence each; may be null.</param>
        /// <exception cref="ArgumentException">An array of another length, or an index that the table doesn't have.</exception>
        public LabelMap(VolumeGeometry geometry, ushort[] indices, SegmentTable segments, IEnumerable<string> warnings = null)
        {
            Geometry = geometry ?? throw new ArgumentNullException(nameof(geometry));
            Indices = indices ?? throw new ArgumentNullException(nameof(indices));
            Segments = segments ?? throw new ArgumentNullException(nameof(segments));
            if (indices.LongLength != geometry.VoxelCount)
                throw new ArgumentException(FormattableString.Invariant($"{geometry.VoxelCount} voxels need as many indices, not {indices.LongLength}."), nameof(indices));
            ushort largest = 0;
            foreach (ushort index in indices)
                largest = index > largest ? index : largest;
            if (largest >= segments.Count)
                throw new ArgumentException(FormattableString.Invariant($"A voxel has segment {largest}; the table has rows 0 to {segments.Count - 1}."), nameof(indices));
            Warnings = warnings == null ? Array.Empty<string>() : warnings.ToArray();
            voxelCounts = new Lazy<IReadOnlyList<long>>(() => Array.AsReadOnly(Count()));
        }

        /// <summary>The same from indices that the table is known to have, and that were counted before.</summary>
        internal LabelMap(VolumeGeometry geometry, ushort[] indices, SegmentTable segments, long[] voxelCounts, string[] warnings)
        {
            Geometry = geometry;
            Indices = indices;
            Segments = segments;
            Warnings = warnings;
            this.voxelCounts = new Lazy<IReadOnlyList<long>>(Array.AsReadOnly(voxelCounts));
        }

        /// <summary>Where the voxels lie.</summary>
        public VolumeGeometry Geometry { get; }

        /// <summary>One row of <see cref="Segments"/> per voxel, i fastest. Not to be changed.</summary>
        public ushort[] Indices { get; }

        /// <summary>The segments by dense index.</summary>
        public SegmentTable Segments { get; }

        /// <summary>What was odd while the map was made (overlaps, values without a name ...), a sentence each.</summary>
        public IReadOnlyList<string> Warnings { get; }

        /// <summary>
        /// Makes a label map from an image of whole numbers, whatever type it stores them in. Where the file names segments in several
        /// layers, the layers are merged: of segments that overlap, the one that the file lists later wins, and a warning counts the
        /// voxels. Segments without a name are called "Label N", those without a colour take <see cref="PredefinedSegmentColors"/>.
        /// </summary>
        /// <param name="data">The image.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="VolumeFormatException">A value that is no whole number, several values per voxel without segments that
        /// name them, or more labels than <see cref="SegmentTable.MaximumCount"/>.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static LabelMap FromVolumeData(VolumeData data, CancellationToken cancellation = default, IProgress<float> progress = null) =>
            new LabelMapBuilder(data ?? throw new ArgumentNullException(nameof(data)), cancellation, progress).Build();

        /// <summary>
        /// The same labels on a scan's grid, where both grids share a lattice: segmentations saved cropped to their segments, or in another
        /// orientation. Voxels of the grid that the map does not reach get label 0.
        /// </summary>
        /// <param name="grid">The scan's grid.</param>
        /// <returns>This map where the grids agree, or where they share no lattice (nothing is resampled); a new one otherwise, with a warning if
        /// labelled voxels lie outside the grid.</returns>
        /// <exception cref="ArgumentNullException"><paramref name="grid"/> is null.</exception>
        public LabelMap OnGridOf(VolumeGeometry grid)
        {
            if (grid == null)
                throw new ArgumentNullException(nameof(grid));
            if (Geometry.Matches(grid, out _) || !(LatticeMap.Find(grid, Geometry, SegmentedVolume.GeometryToleranceMm) is LatticeMap lattice))
                return this;
            ushort[] moved = lattice.Gather(Indices, Geometry, grid);
            long lost = Indices.LongCount(index => index != 0) - moved.LongCount(index => index != 0);
            IEnumerable<string> warnings = lost == 0
                ? Warnings
                : Warnings.Append(FormattableString.Invariant($"{lost} labelled voxels lie outside the scan."));
            return new LabelMap(grid, moved, Segments, warnings);
        }

        /// <summary>
        /// How many voxels each segment has, by row of <see cref="Segments"/>. Counted once, when it is first asked for, on whichever thread that is.
        /// </summary>
        public IReadOnlyList<long> VoxelCounts => voxelCounts.Value;

        /// <summary>How many voxels each segment has.</summary>
        /// <returns>A new array, one number per row of <see cref="Segments"/>.</returns>
        public long[] CountVoxels() => VoxelCounts.ToArray();

        long[] Count()
        {
            var counts = new long[Segments.Count];
            foreach (ushort index in Indices)
                counts[index]++;
            return counts;
        }
    }
}
