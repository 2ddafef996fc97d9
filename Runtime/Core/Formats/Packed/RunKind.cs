namespace AnatomyCarve.Formats
{
    /// <summary>What a run of voxels holds; the numbers stand in files.</summary>
    enum RunKind : byte
    {
        /// <summary>What stands one row before.</summary>
        Above = 0,

        /// <summary>What stands one slice before.</summary>
        Behind = 1,

        /// <summary>The value of the voxel before.</summary>
        Same = 2,

        /// <summary>A value that follows.</summary>
        Value = 3,
    }
}
