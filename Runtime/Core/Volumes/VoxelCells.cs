using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Makes slices of a coarser grid: an intensity is the mean over its cell, a label what most of its cell is. Each thread has its own, as it has buffers.
    /// </summary>
    sealed class VoxelCells
    {
        readonly VolumeGeometry grid;
        readonly CellAxis axisI, axisJ, axisK;
        readonly long[] row;
        long[] weights = Array.Empty<long>();
        ushort[] found = Array.Empty<ushort>();
        int foundCount;

        /// <param name="grid">The fine grid.</param>
        /// <param name="factors">By how much it gets coarser.</param>
        /// <param name="slices">Whether all slices of a cell count.</param>
        internal VoxelCells(VolumeGeometry grid, VoxelFactors factors, CellSlices slices)
        {
            this.grid = grid;
            axisI = new CellAxis(grid.SizeI, VoxelFactors.SizeOf(grid.SizeI, factors.I));
            axisJ = new CellAxis(grid.SizeJ, VoxelFactors.SizeOf(grid.SizeJ, factors.J));
            axisK = new CellAxis(grid.SizeK, VoxelFactors.SizeOf(grid.SizeK, factors.K), slices == CellSlices.Middle);
            row = new long[grid.SizeI];
        }

        /// <summary>Voxels of a coarse slice.</summary>
        internal int SliceVoxels => axisI.Cells * axisJ.Cells;

        /// <summary>Coarse slices.</summary>
        internal int Slices => axisK.Cells;

        long Total => axisI.Total * axisJ.Total * axisK.Total;

        /// <summary>The first fine slice that a coarse one is made of.</summary>
        internal int FirstSlice(int slice) => axisK.First(slice);

        /// <summary>The fine slice behind the last that a coarse one is made of.</summary>
        internal int EndSlice(int slice) => axisK.End(slice);

        /// <summary>Makes a slice of intensities: the weighted mean of the codes, computed exactly and rounded once.</summary>
        /// <param name="codes">Fine codes, from a slice on.</param>
        /// <param name="from">Number of that slice.</param>
        /// <param name="slice">Which coarse slice.</param>
        /// <param name="coarse">Where to: <see cref="SliceVoxels"/> codes.</param>
        internal void Mean(ReadOnlySpan<ushort> codes, int from, int slice, Span<ushort> coarse)
        {
            double total = Total;
            for (int j = 0; j < axisJ.Cells; j++)
            {
                Array.Clear(row, 0, row.Length);
                for (int k = axisK.First(slice); k < axisK.End(slice); k++)
                    for (int y = axisJ.First(j); y < axisJ.End(j); y++)
                        AddRow(Row(codes, k - from, y), axisK.Weight(slice, k) * axisJ.Weight(j, y));
                for (int i = 0; i < axisI.Cells; i++)
                {
                    long sum = 0; // below 2^47, exact in double too: units multiply to no more than voxels, less than 2^31; codes have 16 bits
                    for (int x = axisI.First(i); x < axisI.End(i); x++)
                        sum += axisI.Weight(i, x) * row[x];
                    coarse[(j * axisI.Cells) + i] = (ushort)Math.Round(sum / total);
                }
            }
        }

        /// <summary>
        /// Makes a slice of labels. Label 0 wins where it fills more than three quarters of a cell: where factors divide sizes, a sheet one voxel thin lives
        /// through factor 4, a thread through factor 2 along both axes across it. Else the segment that fills most of the cell wins; of equal ones the first
        /// in the table.
        /// </summary>
        /// <param name="indices">Fine label indices, from a slice on.</param>
        /// <param name="segments">Rows of their table.</param>
        /// <inheritdoc cref="Mean"/>
        internal void Majority(ReadOnlySpan<ushort> indices, int segments, int from, int slice, Span<ushort> coarse)
        {
            if (weights.Length < segments)
                (weights, found) = (new long[segments], new ushort[segments]);
            for (int j = 0; j < axisJ.Cells; j++)
                for (int i = 0; i < axisI.Cells; i++)
                {
                    for (int k = axisK.First(slice); k < axisK.End(slice); k++)
                        for (int y = axisJ.First(j); y < axisJ.End(j); y++)
                            Count(Row(indices, k - from, y), i, axisK.Weight(slice, k) * axisJ.Weight(j, y));
                    coarse[(j * axisI.Cells) + i] = Winner();
                }
        }

        ReadOnlySpan<ushort> Row(ReadOnlySpan<ushort> plane, int slice, int y) =>
            plane.Slice(checked(grid.SizeI * ((slice * grid.SizeJ) + y)), grid.SizeI);

        void AddRow(ReadOnlySpan<ushort> codes, long weight)
        {
            long[] sums = row;
            for (int x = 0; x < sums.Length && x < codes.Length; x++)
                sums[x] += weight * codes[x];
        }

        void Count(ReadOnlySpan<ushort> indices, int cell, long weight)
        {
            int end = axisI.End(cell);
            for (int x = axisI.First(cell); x < end; x++)
            {
                ushort index = indices[x];
                if (weights[index] == 0)
                    found[foundCount++] = index;
                weights[index] += weight * axisI.Weight(cell, x);
            }
        }

        ushort Winner()
        {
            ushort best = 0;
            long bestWeight = 0;
            bool isUnlabelled = 4 * weights[0] > 3 * Total;
            for (int n = 0; n < foundCount; n++)
            {
                ushort index = found[n];
                if (!isUnlabelled && index != 0 && (weights[index] > bestWeight || (weights[index] == bestWeight && index < best)))
                    (best, bestWeight) = (index, weights[index]);
                weights[index] = 0;
            }

            foundCount = 0;
            return best;
        }
    }
}
