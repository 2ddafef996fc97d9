using System;

namespace AnatomyCarve.Formats
{
    /// <summary>How a plane of codes (intensities, or label indices) is cut into blocks: runs of voxels in memory's order, each coded by itself.</summary>
    static class PackedBlocks
    {
        /// <summary>
        /// Voxels per block, but for the last: 256 KiB of codes, which stay in a core's cache while they are decoded, and enough for four slices of
        /// 181 x 181 voxels, so that a voxel of the slice behind can be referred to.
        /// </summary>
        internal const int Voxels = 1 << 17;

        /// <summary>The number of blocks of a plane.</summary>
        internal static int Count(long voxels) => (int)((voxels + Voxels - 1) / Voxels);

        /// <summary>A block's part of its plane.</summary>
        internal static Span<ushort> Of(ushort[] plane, int block)
        {
            int start = block * Voxels;
            return plane.AsSpan(start, Math.Min(Voxels, plane.Length - start));
        }
    }
}
