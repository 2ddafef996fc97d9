using System;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// Which bricks hold anything that transfer function and segment opacities show, carved away or not. Carving only takes away, so what is empty here
    /// stays empty whatever the spheres do. Found out brick by brick, when first asked for.
    /// </summary>
    sealed class MatterMap
    {
        readonly BrickGrid bricks;
        readonly Answer[] hasMatter;
        readonly Answer[] isClear;

        public MatterMap(BrickGrid bricks)
        {
            this.bricks = bricks;
            hasMatter = new Answer[bricks.Count];
            isClear = new Answer[bricks.Count];
        }

        enum Answer : byte
        {
            Unknown,
            No,
            Yes,
        }

        public void Forget()
        {
            Array.Clear(hasMatter, 0, hasMatter.Length);
            Array.Clear(isClear, 0, isClear.Length);
        }

        /// <summary>
        /// Whether a brick and its neighbours on all sides are empty. Samples between the brick's voxels and the next ones read anti-aliased voxels up to
        /// the neighbour's first, and those read one voxel more: both lie within the neighbours.
        /// </summary>
        public bool IsClearFrom(VoxelOpacity opacity, int brickX, int brickY, int brickZ)
        {
            ref Answer answer = ref isClear[bricks.IndexOf(brickX, brickY, brickZ)];
            if (answer == Answer.Unknown)
                answer = AreEmptyAround(opacity, brickX, brickY, brickZ) ? Answer.Yes : Answer.No;
            return answer == Answer.Yes;
        }

        bool AreEmptyAround(VoxelOpacity opacity, int brickX, int brickY, int brickZ)
        {
            for (int z = Math.Max(0, brickZ - 1); z <= Math.Min(brickZ + 1, bricks.BricksZ - 1); z++)
                for (int y = Math.Max(0, brickY - 1); y <= Math.Min(brickY + 1, bricks.BricksY - 1); y++)
                    for (int x = Math.Max(0, brickX - 1); x <= Math.Min(brickX + 1, bricks.BricksX - 1); x++)
                    {
                        ref Answer answer = ref hasMatter[bricks.IndexOf(x, y, z)];
                        if (answer == Answer.Unknown)
                            answer = opacity.HasMatter(x, y, z) ? Answer.Yes : Answer.No;
                        if (answer == Answer.Yes)
                            return false;
                    }
            return true;
        }
    }
}
