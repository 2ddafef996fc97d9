using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// How the voxels along an axis share the cells of a coarser one: cells of the same size that fill the axis, voxels by parts where they must be.
    /// </summary>
    sealed class CellAxis
    {
        readonly int voxels, unitsPerVoxel, unitsPerCell;
        readonly bool middleOnly;

        /// <param name="voxels">Voxels along the axis.</param>
        /// <param name="cells">Cells along it: 1 to the number of voxels.</param>
        /// <param name="middleOnly">Whether a cell is made of the voxel in its middle alone.</param>
        internal CellAxis(int voxels, int cells, bool middleOnly = false)
        {
            this.voxels = voxels;
            this.middleOnly = middleOnly;
            int common = GreatestCommonDivisor(voxels, cells);
            (Cells, unitsPerVoxel, unitsPerCell) = (cells, cells / common, voxels / common);
        }

        /// <summary>The number of cells.</summary>
        internal int Cells { get; }

        /// <summary>The weights of a cell's voxels in all.</summary>
        internal long Total => middleOnly ? 1 : unitsPerCell;

        /// <summary>The first voxel of a cell.</summary>
        internal int First(int cell) => middleOnly
            ? Math.Min(voxels - 1, (int)(((2L * cell) + 1) * unitsPerCell / (2L * unitsPerVoxel)))
            : (int)((long)cell * unitsPerCell / unitsPerVoxel);

        /// <summary>The voxel behind a cell's last.</summary>
        internal int End(int cell) => middleOnly ? First(cell) + 1 : (int)((((cell + 1L) * unitsPerCell) + unitsPerVoxel - 1) / unitsPerVoxel);

        /// <summary>What a voxel counts in a cell that it belongs to.</summary>
        internal long Weight(int cell, int voxel) => middleOnly
            ? 1
            : Math.Min((voxel + 1L) * unitsPerVoxel, (cell + 1L) * unitsPerCell) - Math.Max((long)voxel * unitsPerVoxel, (long)cell * unitsPerCell);

        static int GreatestCommonDivisor(int a, int b) => b == 0 ? a : GreatestCommonDivisor(b, a % b);
    }
}
