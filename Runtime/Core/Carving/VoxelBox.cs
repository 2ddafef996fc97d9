namespace AnatomyCarve.Carving
{
    /// <summary>A box of voxels, both ends included.</summary>
    public struct VoxelBox
    {
        /// <summary>First voxel along i.</summary>
        public int MinI;

        /// <summary>First voxel along j.</summary>
        public int MinJ;

        /// <summary>First voxel along k.</summary>
        public int MinK;

        /// <summary>Last voxel along i.</summary>
        public int MaxI;

        /// <summary>Last voxel along j.</summary>
        public int MaxJ;

        /// <summary>Last voxel along k.</summary>
        public int MaxK;

        /// <summary>How many voxels it has.</summary>
        public long VoxelCount => (MaxI - MinI + 1L) * (MaxJ - MinJ + 1L) * (MaxK - MinK + 1L);

        /// <summary>Whether another box lies within this one.</summary>
        public bool Contains(VoxelBox other) =>
            other.MinI >= MinI && other.MinJ >= MinJ && other.MinK >= MinK && other.MaxI <= MaxI && other.MaxJ <= MaxJ && other.MaxK <= MaxK;
    }
}
