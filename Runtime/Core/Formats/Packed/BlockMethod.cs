namespace AnatomyCarve.Formats
{
    /// <summary>How a block of a packed volume is coded; the numbers stand in files.</summary>
    enum BlockMethod : byte
    {
        /// <summary>Predicted, with the differences in as few bits as a group of them needs: <see cref="TileEncoder"/>.</summary>
        Tiles = 0,

        /// <summary>Runs of one value and runs that repeat the row above or the slice behind: <see cref="RunEncoder"/>.</summary>
        Runs = 1,
    }
}
