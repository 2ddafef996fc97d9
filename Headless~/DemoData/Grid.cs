using System;

namespace AnatomyCarve.Headless.DemoData
{
    /// <summary>The sizes of a voxel grid; a voxel's index is i + SizeI * (j + SizeJ * k).</summary>
    readonly record struct Grid(int SizeI, int SizeJ, int SizeK)
    {
        public int Count => SizeI * SizeJ * SizeK;

        public int Index(int i, int j, int k) => i + SizeI * (j + SizeJ * k);

        /// <summary>Calls <paramref name="visit"/> with each of the up to six neighbours of a voxel that lie inside the grid.</summary>
        public void VisitNeighbours(int index, Action<int> visit)
        {
            int i = index % SizeI, j = index / SizeI % SizeJ, k = index / (SizeI * SizeJ);
            if (i > 0) visit(index - 1);
            if (i < SizeI - 1) visit(index + 1);
            if (j > 0) visit(index - SizeI);
            if (j < SizeJ - 1) visit(index + SizeI);
            if (k > 0) visit(index - SizeI * SizeJ);
            if (k < SizeK - 1) visit(index + SizeI * SizeJ);
        }
    }

    /// <summary>A box of voxels, both ends included.</summary>
    readonly record struct VoxelBox(int MinI, int MaxI, int MinJ, int MaxJ, int MinK, int MaxK)
    {
        public Grid Grid => new(MaxI - MinI + 1, MaxJ - MinJ + 1, MaxK - MinK + 1);

        /// <summary>The smallest box that holds every voxel for which <paramref name="isIn"/> is true, grown by a margin and clipped to the grid.</summary>
        public static VoxelBox Around(Grid grid, Func<int, bool> isIn, int margin)
        {
            int minI = int.MaxValue, minJ = int.MaxValue, minK = int.MaxValue, maxI = -1, maxJ = -1, maxK = -1;
            for (int k = 0, index = 0; k < grid.SizeK; k++)
            {
                for (var j = 0; j < grid.SizeJ; j++)
                {
                    for (var i = 0; i < grid.SizeI; i++, index++)
                    {
                        if (!isIn(index)) continue;
                        minI = Math.Min(minI, i);
                        maxI = Math.Max(maxI, i);
                        minJ = Math.Min(minJ, j);
                        maxJ = Math.Max(maxJ, j);
                        minK = Math.Min(minK, k);
                        maxK = Math.Max(maxK, k);
                    }
                }
            }

            if (maxI < 0) throw new ArgumentException("The box would be empty: no voxel of the grid is in.", nameof(isIn));
            return new VoxelBox(
                Math.Max(minI - margin, 0), Math.Min(maxI + margin, grid.SizeI - 1),
                Math.Max(minJ - margin, 0), Math.Min(maxJ + margin, grid.SizeJ - 1),
                Math.Max(minK - margin, 0), Math.Min(maxK + margin, grid.SizeK - 1));
        }

        /// <summary>The voxels of this box, cut out of an array that covers <paramref name="grid"/>.</summary>
        public byte[] Cut(Grid grid, byte[] voxels)
        {
            var cut = new byte[Grid.Count];
            for (int k = MinK, target = 0; k <= MaxK; k++)
            {
                for (var j = MinJ; j <= MaxJ; j++, target += Grid.SizeI)
                {
                    Array.Copy(voxels, grid.Index(MinI, j, k), cut, target, Grid.SizeI);
                }
            }

            return cut;
        }
    }
}
