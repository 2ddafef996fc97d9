using System;

namespace AnatomyCarve.Formats
{
    /// <summary>Codes the blocks of one grid's planes, each by the method that takes fewer bytes. Not thread safe.</summary>
    sealed class BlockCoder
    {
        readonly TileEncoder tiles = new TileEncoder();
        readonly RunEncoder runs = new RunEncoder();
        readonly int row;
        readonly long slice;

        /// <param name="row">Voxels from one row to the next.</param>
        /// <param name="slice">Voxels from one slice to the next.</param>
        internal BlockCoder(int row, long slice)
        {
            this.row = row;
            this.slice = slice;
        }

        /// <summary>Codes a block.</summary>
        internal byte[] Encode(ReadOnlySpan<ushort> block, out BlockMethod method)
        {
            ReadOnlySpan<byte> tiled = tiles.Encode(block, row, slice);
            bool asRuns = runs.TryEncode(block, row, slice, tiled.Length, out ReadOnlySpan<byte> inRuns);
            method = asRuns ? BlockMethod.Runs : BlockMethod.Tiles;
            return (asRuns ? inRuns : tiled).ToArray();
        }

        /// <summary>Decodes a block straight into its plane.</summary>
        /// <param name="row">Voxels from one row to the next.</param>
        /// <param name="slice">Voxels from one slice to the next.</param>
        /// <param name="largest">The largest value that a voxel may have.</param>
        /// <returns>False where the bytes are no such block.</returns>
        internal static bool TryDecode(BlockMethod method, ReadOnlySpan<byte> bytes, Span<ushort> block, int row, long slice, ushort largest) =>
            method == BlockMethod.Runs
                ? RunDecoder.TryDecode(bytes, block, row, slice, largest)
                : TileDecoder.TryDecode(bytes, block, row, slice, largest);
    }
}
