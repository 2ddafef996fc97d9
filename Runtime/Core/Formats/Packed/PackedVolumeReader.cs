using System;
using System.Threading;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// A packed volume whose header has been read: what it says of itself, and its voxels, whole or coarser, as often as they are wanted. What it gives shares
    /// segments, transfer function and <see cref="SegmentedVolume.Origin"/>. It reads the bytes whenever it is asked; they must not change. Any thread.
    /// </summary>
    public sealed class PackedVolumeReader
    {
        readonly ReadOnlyMemory<byte> data;
        readonly string name;
        readonly PackedHeader header;

        internal PackedVolumeReader(ReadOnlyMemory<byte> data, string name)
        {
            this.data = data;
            this.name = name;
            header = PackedHeaderReader.Read(data, PackedVolume.Context(name));
        }

        /// <summary>What the header says.</summary>
        public PackedVolumeInfo Info => header.Info;

        /// <summary>Unpacks the whole volume.</summary>
        /// <inheritdoc cref="PackedVolume.Read(ReadOnlyMemory{byte}, string, int, CancellationToken, IProgress{float})"/>
        public SegmentedVolume Read(int threads, CancellationToken cancellation = default, IProgress<float> progress = null)
        {
            if (threads < 1)
                throw new ArgumentOutOfRangeException(nameof(threads), threads, "At least one thread has to work.");
            cancellation.ThrowIfCancellationRequested();
            long voxels = Info.Geometry.VoxelCount;
            var codes = new ushort[voxels];
            var indices = new ushort[voxels];
            int blocks = PackedBlocks.Count(voxels);
            var decoder = new PackedBlockDecoder(data, header, name);
            BlockWorkers.Run(2 * blocks, threads, () => Decode, cancellation, progress);
            progress?.Report(1);
            return header.MakeVolume(codes, indices);

            void Decode(int piece)
            {
                if (piece < blocks)
                    decoder.Decode(PackedPlane.Intensities, piece, PackedBlocks.Of(codes, piece));
                else
                    decoder.Decode(PackedPlane.Labels, piece - blocks, PackedBlocks.Of(indices, piece - blocks));
            }
        }

        /// <summary>The same on as many threads as suit the machine: all processors but one, at most four.</summary>
        public SegmentedVolume Read(CancellationToken cancellation = default, IProgress<float> progress = null) =>
            Read(BlockWorkers.DefaultThreads, cancellation, progress);

        /// <summary>
        /// Unpacks a coarser volume, as <see cref="VolumeDownsampling.Of"/> would make it of the whole one, which is never in memory: some slices are, for each
        /// thread. With <see cref="CellSlices.Middle"/> only the blocks that hold these slices are unpacked.
        /// </summary>
        /// <param name="factors">By how much it gets coarser.</param>
        /// <param name="slices">What a cell is made of along k.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1, on the calling thread; may be null.</param>
        /// <exception cref="VolumeFormatException">It is damaged.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public SegmentedVolume ReadCoarse(
            VoxelFactors factors, CellSlices slices = CellSlices.All, CancellationToken cancellation = default, IProgress<float> progress = null)
        {
            if (factors.AreOne)
                return Read(cancellation, progress);
            cancellation.ThrowIfCancellationRequested();
            VolumeGeometry grid = Info.Geometry, coarse = factors.Apply(grid);
            var codes = new ushort[coarse.VoxelCount];
            var indices = new ushort[coarse.VoxelCount];
            BlockWorkers.Run(coarse.SizeK, BlockWorkers.DefaultThreads, MakeWorker, cancellation, progress);
            return header.MakeVolume(coarse, codes, indices);

            Action<int> MakeWorker()
            {
                var cells = new VoxelCells(grid, factors, slices);
                var decoder = new PackedBlockDecoder(data, header, name);
                PackedSlices fineCodes = new PackedSlices(decoder, PackedPlane.Intensities, grid), fineIndices = new PackedSlices(decoder, PackedPlane.Labels, grid);
                return slice =>
                {
                    int first = cells.FirstSlice(slice), end = cells.EndSlice(slice), start = slice * cells.SliceVoxels;
                    cells.Mean(fineCodes.Get(first, end), first, slice, codes.AsSpan(start, cells.SliceVoxels));
                    cells.Majority(fineIndices.Get(first, end), Info.SegmentCount, first, slice, indices.AsSpan(start, cells.SliceVoxels));
                };
            }
        }
    }
}
