using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>What the voxels of a packed volume are of.</summary>
    enum PackedPlane
    {
        Intensities,
        Labels,
    }

    /// <summary>Unpacks single blocks, and refuses those that are damaged. Any thread, several at once.</summary>
    sealed class PackedBlockDecoder
    {
        readonly ReadOnlyMemory<byte> data;
        readonly PackedHeader header;
        readonly string name;

        internal PackedBlockDecoder(ReadOnlyMemory<byte> data, PackedHeader header, string name) => (this.data, this.header, this.name) = (data, header, name);

        /// <summary>Unpacks a block.</summary>
        /// <param name="voxels">Where to: all voxels of the block.</param>
        /// <exception cref="VolumeFormatException">It is damaged.</exception>
        internal void Decode(PackedPlane plane, int number, Span<ushort> voxels)
        {
            bool isLabels = plane == PackedPlane.Labels;
            IReadOnlyList<PackedBlock> directory = isLabels ? header.LabelBlocks : header.IntensityBlocks;
            ushort largest = isLabels ? (ushort)(header.Info.SegmentCount - 1) : ushort.MaxValue;
            PackedBlock block = directory[number];
            ReadOnlySpan<byte> bytes = data.Span.Slice(block.Start, block.Length);
            if (Checksum64.Of(bytes) != block.Checksum)
                throw Refusal(plane, number, $"damaged", "bytes that agree with their checksum");
            int row = header.Info.SizeI;
            if (!BlockCoder.TryDecode(block.Method, bytes, voxels, row, (long)row * header.Info.SizeJ, largest))
                throw Refusal(plane, number, $"malformed", FormattableString.Invariant($"{voxels.Length} values of 0 to {largest}, coded as {block.Method}"));
        }

        VolumeFormatException Refusal(PackedPlane plane, int number, FormattableString found, string expectation) =>
            PackedVolume.Context(name).Refusal(
                FormattableString.Invariant($"block {number} of the {(plane == PackedPlane.Labels ? "labels" : "intensities")}"), found, expectation);
    }
}
