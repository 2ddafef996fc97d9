namespace AnatomyCarve.Formats
{
    /// <summary>What a tile's voxels are predicted from; the numbers stand in files.</summary>
    enum TilePredictor : byte
    {
        /// <summary>The voxel before.</summary>
        Left = 0,

        /// <summary>The voxel one row before.</summary>
        Above = 1,

        /// <summary>The voxel one slice before.</summary>
        Behind = 2,

        /// <summary>Half of left + above, rounded down.</summary>
        Mean = 3,

        /// <summary>Left + above - the voxel above left: what a plane would have.</summary>
        Plane = 4,
    }
}
