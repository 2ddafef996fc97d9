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
    }
}
