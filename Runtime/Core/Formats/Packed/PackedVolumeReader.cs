using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Unpacks one volume: header, then the blocks of both planes straight into their arrays.</summary>
    sealed class PackedVolumeReader
    {
        readonly ReadOnlyMemory<byte> data;
        readonly ReadContext context;
        PackedHeader header;
        ushort[] codes;
        ushort[] indices;

        internal PackedVolumeReader(ReadOnlyMemory<byte> data, ReadContext context)
        {
            this.data = data;
            this.context = context;
        }

        internal SegmentedVolume Read(int threads)
        {
            context.Cancellation.ThrowIfCancellationRequested();
            header = PackedHeaderReader.Read(data, context);
            long voxels = header.Info.Geometry.VoxelCount;
            codes = new ushort[voxels];
            indices = new ushort[voxels];
            int blocks = PackedBlocks.Count(voxels);
            BlockWorkers.Run(2 * blocks, threads, () => Decode, context.Cancellation, context.Progress);
            context.Progress?.Report(1);
            return header.MakeVolume(codes, indices);
        }

        void Decode(int piece)
        {
            int blocks = header.IntensityBlocks.Count;
            if (piece < blocks)
                Decode("intensities", header.IntensityBlocks, piece, codes, ushort.MaxValue);
            else
                Decode("labels", header.LabelBlocks, piece - blocks, indices, (ushort)(header.Info.SegmentCount - 1));
        }

        void Decode(string plane, IReadOnlyList<PackedBlock> directory, int number, ushort[] target, ushort largest)
        {
            PackedBlock block = directory[number];
            ReadOnlySpan<byte> bytes = data.Span.Slice(block.Start, block.Length);
            if (Checksum64.Of(bytes) != block.Checksum)
                throw Refusal(plane, number, $"damaged", "bytes that agree with their checksum");
            Span<ushort> voxels = PackedBlocks.Of(target, number);
            int row = header.Info.SizeI;
            if (!BlockCoder.TryDecode(block.Method, bytes, voxels, row, (long)row * header.Info.SizeJ, largest))
                throw Refusal(plane, number, $"malformed", FormattableString.Invariant($"{voxels.Length} values of 0 to {largest}, coded as {block.Method}"));
        }

        VolumeFormatException Refusal(string plane, int number, FormattableString found, string expectation) =>
            context.Refusal(FormattableString.Invariant($"block {number} of the {plane}"), found, expectation);
    }
}
