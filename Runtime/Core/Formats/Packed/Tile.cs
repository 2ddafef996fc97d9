namespace AnatomyCarve.Formats
{
    /// <summary>Facts about tiles that encoder and decoder share.</summary>
    static class Tile
    {
        /// <summary>Voxels per tile, but for a block's last one.</summary>
        internal const int Voxels = 256;

        /// <summary>Voxels that share a width.</summary>
        internal const int GroupVoxels = 16;

        /// <summary>The width that is stored as 15; differences of 15 bits are stored in 16.</summary>
        internal const int FullWidth = 16;

        /// <summary>Bytes of the widths: four bits per group.</summary>
        internal const int WidthBytes = Voxels / GroupVoxels / 2;

        /// <summary>In a tile's first byte, beside the predictor: every difference is 0, nothing follows.</summary>
        internal const byte Exact = 0x80;

        /// <summary>Zeros behind a block's last tile, so that a decoder may read eight bytes anywhere.</summary>
        internal const int PaddingBytes = 8;

        /// <summary>The predictors; of equally good ones the first is taken, so the fastest stand first.</summary>
        internal static readonly TilePredictor[] Predictors =
        {
            TilePredictor.Above, TilePredictor.Behind, TilePredictor.Left, TilePredictor.Mean, TilePredictor.Plane,
        };

        /// <summary>How far back a predictor looks: it needs a tile that starts so far behind its block's start. <see cref="TilePredictor.Left"/> takes 0 for what is missing.</summary>
        /// <param name="row">Voxels from one row to the next.</param>
        /// <param name="slice">Voxels from one slice to the next.</param>
        internal static long Reach(TilePredictor predictor, int row, long slice)
        {
            switch (predictor)
            {
                case TilePredictor.Left:
                    return 0;
                case TilePredictor.Above:
                    return row;
                case TilePredictor.Behind:
                    return slice;
                default:
                    return row + 1L;
            }
        }
    }
}
