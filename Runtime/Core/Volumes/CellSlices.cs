namespace AnatomyCarve.Volumes
{
    /// <summary>Which slices (along k) of a cell a coarser voxel is made of.</summary>
    public enum CellSlices
    {
        /// <summary>All of them: a volume to work with.</summary>
        All,

        /// <summary>The one in the middle: several times faster, for a first look.</summary>
        Middle,
    }
}
