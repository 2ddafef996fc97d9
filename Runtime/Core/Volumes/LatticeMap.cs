using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// How the voxels of one grid are found in another that shares its lattice: one is a part of the other, or its axes run in another order or
    /// direction. No voxel moves and none is skipped; segmentations saved cropped, or in another orientation than their scan, differ so.
    /// </summary>
    sealed class LatticeMap
    {
        readonly int[,] matrix = new int[3, 3];
        readonly int[] offset = new int[3];

        LatticeMap(Affine gridToOther)
        {
            for (int row = 0; row < 3; row++)
            {
                for (int col = 0; col < 3; col++)
                    matrix[row, col] = (int)Math.Round(gridToOther[row, col]);
                offset[row] = (int)Math.Round(gridToOther[row, 3]);
            }
        }

        /// <summary>Whether each axis of one grid is one of the other's, forwards or backwards; else one of the grids is coarser, or slanted.</summary>
        bool IsSignedPermutation
        {
            get
            {
                for (int n = 0; n < 3; n++)
                {
                    int inRow = Math.Abs(matrix[n, 0]) + Math.Abs(matrix[n, 1]) + Math.Abs(matrix[n, 2]);
                    int inColumn = Math.Abs(matrix[0, n]) + Math.Abs(matrix[1, n]) + Math.Abs(matrix[2, n]);
                    if (inRow != 1 || inColumn != 1)
                        return false;
                }
                return true;
            }
        }

        /// <summary>Finds the map from one grid's voxel indices to another's; null where they don't share a lattice.</summary>
        /// <param name="grid">The grid whose voxels are looked for.</param>
        /// <param name="other">The grid where they are looked for.</param>
        /// <param name="toleranceMm">How far voxels that count as the same may lie apart.</param>
        internal static LatticeMap Find(VolumeGeometry grid, VolumeGeometry other, double toleranceMm)
        {
            Affine gridToOther = other.LpsToIjk * grid.IjkToLps;
            for (int row = 0; row < 3; row++)
                for (int col = 0; col < 4; col++)
                    if (!(Math.Abs(gridToOther[row, col]) < 1e6))
                        return null;
            var map = new LatticeMap(gridToOther);
            if (!map.IsSignedPermutation)
                return null;
            Affine placed = other.IjkToLps * map.ToAffine();
            double distanceMm = VolumeGeometry.LargestCornerDistanceMm(placed, grid.IjkToLps, grid.SizeI, grid.SizeJ, grid.SizeK);
            return distanceMm <= toleranceMm ? map : null;
        }

        /// <summary>The values of the other grid's voxels at the grid's voxels; 0 where the other grid has none.</summary>
        internal ushort[] Gather(ushort[] values, VolumeGeometry other, VolumeGeometry grid)
        {
            var gathered = new ushort[grid.VoxelCount];
            int target = 0;
            for (int k = 0; k < grid.SizeK; k++)
            {
                for (int j = 0; j < grid.SizeJ; j++)
                {
                    for (int i = 0; i < grid.SizeI; i++, target++)
                    {
                        int x = At(0, i, j, k), y = At(1, i, j, k), z = At(2, i, j, k);
                        if ((uint)x < (uint)other.SizeI && (uint)y < (uint)other.SizeJ && (uint)z < (uint)other.SizeK)
                            gathered[target] = values[x + other.SizeI * (y + (long)other.SizeJ * z)];
                    }
                }
            }
            return gathered;
        }

        int At(int row, int i, int j, int k) => matrix[row, 0] * i + matrix[row, 1] * j + matrix[row, 2] * k + offset[row];

        Affine ToAffine() => Affine.FromColumns(
            new VectorMm(matrix[0, 0], matrix[1, 0], matrix[2, 0]),
            new VectorMm(matrix[0, 1], matrix[1, 1], matrix[2, 1]),
            new VectorMm(matrix[0, 2], matrix[1, 2], matrix[2, 2]),
            new PointMm(offset[0], offset[1], offset[2]));
    }
}
