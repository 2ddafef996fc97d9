using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>Some slices of a packed volume's plane at a time, in a buffer that is used again. What was unpacked for the slices before is not unpacked anew.</summary>
    sealed class PackedSlices
    {
        readonly PackedBlockDecoder decoder;
        readonly PackedPlane plane;
        readonly long voxels, perSlice;
        ushort[] buffer = Array.Empty<ushort>();
        int firstBlock, endBlock; // what the buffer holds

        internal PackedSlices(PackedBlockDecoder decoder, PackedPlane plane, VolumeGeometry grid) =>
            (this.decoder, this.plane, voxels, perSlice) = (decoder, plane, grid.VoxelCount, (long)grid.SizeI * grid.SizeJ);

        /// <summary>Slices first to end - 1; valid until the next call.</summary>
        internal ReadOnlySpan<ushort> Get(int first, int end)
        {
            int from = (int)(first * perSlice / PackedBlocks.Voxels), to = (int)(((end * perSlice) + PackedBlocks.Voxels - 1) / PackedBlocks.Voxels);
            ushort[] target = buffer.Length < (to - from) * PackedBlocks.Voxels ? new ushort[(to - from) * PackedBlocks.Voxels] : buffer;
            int kept = 0;
            if (from >= firstBlock && from < endBlock)
            {
                kept = Math.Min(endBlock, to) - from;
                Array.Copy(buffer, (from - firstBlock) * PackedBlocks.Voxels, target, 0, kept * PackedBlocks.Voxels);
            }

            (buffer, firstBlock, endBlock) = (target, 0, 0); // nothing is held while a block may be refused
            for (int block = from + kept; block < to; block++)
            {
                int length = (int)Math.Min(PackedBlocks.Voxels, voxels - ((long)block * PackedBlocks.Voxels));
                decoder.Decode(plane, block, buffer.AsSpan((block - from) * PackedBlocks.Voxels, length));
            }

            (firstBlock, endBlock) = (from, to);
            return buffer.AsSpan((int)((first * perSlice) - ((long)from * PackedBlocks.Voxels)), (int)((end - first) * perSlice));
        }
    }
}
