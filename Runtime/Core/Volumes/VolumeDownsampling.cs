using System;
using System.Threading;

namespace AnatomyCarve.Volumes
{
    /// <summary>Makes volumes coarser: they take less memory, and fill the same box around the same centre.</summary>
    public static class VolumeDownsampling
    {
        /// <summary>
        /// A coarser volume. An intensity is the mean over its cell, on the codes of the fine volume. A label is 0 where label 0 fills more than three
        /// quarters of the cell, else that of the segment that fills most of it (of equal ones the first in the table): structures thinner than a cell get
        /// thicker rather than vanish. Segments, transfer function and warnings are those of the fine volume; so is <see cref="SegmentedVolume.Origin"/>.
        /// Works on the calling thread and up to three more; takes the coarse volume's memory and a few rows, whatever the fine one's size.
        /// </summary>
        /// <param name="volume">The volume.</param>
        /// <param name="factors">By how much it gets coarser.</param>
        /// <param name="slices">What a cell is made of along k.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1, on the calling thread; may be null.</param>
        /// <returns>The coarser volume; the same one where all factors are 1.</returns>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static SegmentedVolume Of(
            SegmentedVolume volume, VoxelFactors factors, CellSlices slices = CellSlices.All, CancellationToken cancellation = default,
            IProgress<float> progress = null)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            if (factors.AreOne)
                return volume;
            VolumeGeometry grid = volume.Geometry, coarse = factors.Apply(grid);
            ushort[] fineCodes = volume.Intensity.Codes, fineIndices = volume.Labels.Indices;
            var codes = new ushort[coarse.VoxelCount];
            var indices = new ushort[coarse.VoxelCount];
            BlockWorkers.Run(coarse.SizeK, BlockWorkers.DefaultThreads, MakeWorker, cancellation, progress);
            IntensityVolume scan = volume.Intensity;
            return new SegmentedVolume(
                new IntensityVolume(coarse, codes, scan.CodeOffset, scan.CodeScale, scan.ValueMax, scan.Warnings),
                new LabelMap(coarse, indices, volume.Segments, volume.Labels.Warnings), volume.Warnings, volume.AutomaticTransferFunction, null, volume.Origin);

            Action<int> MakeWorker()
            {
                var cells = new VoxelCells(grid, factors, slices);
                return slice =>
                {
                    int start = slice * cells.SliceVoxels;
                    cells.Mean(fineCodes, 0, slice, codes.AsSpan(start, cells.SliceVoxels));
                    cells.Majority(fineIndices, volume.Segments.Count, 0, slice, indices.AsSpan(start, cells.SliceVoxels));
                };
            }
        }
    }
}
