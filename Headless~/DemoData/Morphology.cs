using System;
using System.Collections.Generic;

namespace AnatomyCarve.Headless.DemoData
{
    /// <summary>Set operations on voxel masks; neighbours are the six that share a face.</summary>
    static class Morphology
    {
        /// <summary>The mask without the voxels that lie within <paramref name="steps"/> steps of one that is out, or of the grid's border.</summary>
        public static bool[] Erode(Grid grid, bool[] mask, int steps)
        {
            var outside = Array.ConvertAll(mask, isIn => !isIn);
            return Array.ConvertAll(Dilate(grid, outside, steps, borderIsIn: true), isOut => !isOut);
        }

        /// <summary>The mask and all voxels within <paramref name="steps"/> steps of it.</summary>
        public static bool[] Dilate(Grid grid, bool[] mask, int steps, bool borderIsIn = false)
        {
            var result = (bool[])mask.Clone();
            for (var step = 0; step < steps; step++)
            {
                var before = (bool[])result.Clone();
                for (var index = 0; index < before.Length; index++)
                {
                    if (before[index]) continue;
                    var neighbours = 0;
                    grid.VisitNeighbours(index, neighbour =>
                    {
                        neighbours++;
                        result[index] |= before[neighbour];
                    });
                    result[index] |= borderIsIn && step == 0 && neighbours < 6;
                }
            }

            return result;
        }

        /// <summary>The largest connected part of the mask.</summary>
        public static bool[] LargestPart(Grid grid, bool[] mask)
        {
            var seen = new bool[mask.Length];
            var largest = new List<int>();
            for (var seed = 0; seed < mask.Length; seed++)
            {
                if (!mask[seed] || seen[seed]) continue;
                var part = Flood(grid, seed, mask, seen);
                if (part.Count > largest.Count) largest = part;
            }

            var result = new bool[mask.Length];
            foreach (var index in largest) result[index] = true;
            return result;
        }

        /// <summary>The mask and every cavity in it: voxels from which no path outside the mask leads to the grid's border.</summary>
        public static bool[] FillCavities(Grid grid, bool[] mask)
        {
            var outside = Array.ConvertAll(mask, isIn => !isIn);
            var seen = new bool[mask.Length];
            for (var index = 0; index < mask.Length; index++)
            {
                if (!outside[index] || seen[index] || !IsBorder(grid, index)) continue;
                Flood(grid, index, outside, seen);
            }

            return Array.ConvertAll(seen, isAir => !isAir);
        }

        /// <summary>As <see cref="FillCavities"/>, but in each axial slice by itself, so that a cavity may be open above or below.</summary>
        public static bool[] FillCavitiesOfSlices(Grid grid, bool[] mask)
        {
            var slice = new Grid(grid.SizeI, grid.SizeJ, 1);
            var result = new bool[mask.Length];
            for (var k = 0; k < grid.SizeK; k++)
            {
                var start = k * slice.Count;
                FillCavities(slice, mask[start..(start + slice.Count)]).CopyTo(result, start);
            }

            return result;
        }

        static bool IsBorder(Grid grid, int index)
        {
            int i = index % grid.SizeI, j = index / grid.SizeI % grid.SizeJ, k = index / (grid.SizeI * grid.SizeJ);
            return i == 0 || i == grid.SizeI - 1 || j == 0 || j == grid.SizeJ - 1
                || (grid.SizeK > 1 && (k == 0 || k == grid.SizeK - 1));
        }

        static List<int> Flood(Grid grid, int seed, bool[] mask, bool[] seen)
        {
            var part = new List<int> { seed };
            seen[seed] = true;
            for (var next = 0; next < part.Count; next++)
            {
                grid.VisitNeighbours(part[next], neighbour =>
                {
                    if (!mask[neighbour] || seen[neighbour]) return;
                    seen[neighbour] = true;
                    part.Add(neighbour);
                });
            }

            return part;
        }
    }
}
