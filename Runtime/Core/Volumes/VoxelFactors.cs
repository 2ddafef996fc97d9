using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>By how much a grid is made coarser along each axis: so many of its voxels share a cell, of which one voxel is made. Each is at least 1.</summary>
    /// <remarks>
    /// An axis of n voxels gets ceil(n / factor) cells of the same size that fill it exactly; where the factor does not divide n, they are a little smaller than
    /// the factor says, and a voxel may lie in two of them by parts. So a coarser grid fills the same box around the same centre.
    /// </remarks>
    public readonly struct VoxelFactors : IEquatable<VoxelFactors>
    {
        /// <summary>Spacings that differ by less, relatively, count as equal.</summary>
        const double SameSpacing = 1e-6;

        /// <summary>Sets all three.</summary>
        /// <param name="i">Along i, at least 1.</param>
        /// <param name="j">Along j, at least 1.</param>
        /// <param name="k">Along k, at least 1.</param>
        /// <exception cref="ArgumentOutOfRangeException">One of them is below 1.</exception>
        public VoxelFactors(int i, int j, int k)
        {
            if (i < 1 || j < 1 || k < 1)
                throw new ArgumentOutOfRangeException(nameof(i), FormattableString.Invariant($"Factors are at least 1, not {i}, {j} and {k}."));
            (I, J, K) = (i, j, k);
        }

        /// <summary>Along i.</summary>
        public int I { get; }

        /// <summary>Along j.</summary>
        public int J { get; }

        /// <summary>Along k.</summary>
        public int K { get; }

        /// <summary>Whether nothing gets coarser.</summary>
        public bool AreOne => I <= 1 && J <= 1 && K <= 1;

        /// <summary>Voxels that are left of so many along an axis.</summary>
        /// <param name="voxels">Voxels along it, at least 1.</param>
        /// <param name="factor">The factor along it, at least 1.</param>
        public static int SizeOf(int voxels, int factor) => (int)(((long)voxels + factor - 1) / factor);

        /// <summary>The smallest factors with which a grid fits. The axis with the smallest spacing gets coarser first, so a coarse one stays as it is for long.</summary>
        /// <param name="grid">The grid.</param>
        /// <param name="fits">Whether a grid of so many voxels along i, j, k does.</param>
        /// <returns>The factors, all 1 where the grid fits as it is; null where even one voxel does not.</returns>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        public static VoxelFactors? Fitting(VolumeGeometry grid, Func<int, int, int, bool> fits)
        {
            if (grid == null)
                throw new ArgumentNullException(nameof(grid));
            if (fits == null)
                throw new ArgumentNullException(nameof(fits));
            int[] voxels = { grid.SizeI, grid.SizeJ, grid.SizeK }, left = { grid.SizeI, grid.SizeJ, grid.SizeK }, factors = { 1, 1, 1 };
            double[] spacing = { grid.SpacingMm.X, grid.SpacingMm.Y, grid.SpacingMm.Z };
            while (!fits(left[0], left[1], left[2]))
            {
                int finest = -1;
                for (int axis = 0; axis < 3; axis++)
                    if (left[axis] > 1 && (finest < 0 || IsFiner(axis, finest)))
                        finest = axis;
                if (finest < 0)
                    return null;
                left[finest] = SizeOf(voxels[finest], ++factors[finest]);
            }

            return new VoxelFactors(factors[0], factors[1], factors[2]);

            double Now(int axis) => spacing[axis] * voxels[axis] / left[axis];

            // Of equal ones the longer axis: it holds more that can be spared.
            bool IsFiner(int axis, int than) => Now(axis) < Now(than) * (1 - SameSpacing) || (Now(axis) <= Now(than) * (1 + SameSpacing) && left[axis] > left[than]);
        }

        /// <summary>The coarser grid: the same box, around the same centre.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="grid"/> is null.</exception>
        public VolumeGeometry Apply(VolumeGeometry grid)
        {
            if (grid == null)
                throw new ArgumentNullException(nameof(grid));
            if (AreOne)
                return grid;
            int sizeI = SizeOf(grid.SizeI, I), sizeJ = SizeOf(grid.SizeJ, J), sizeK = SizeOf(grid.SizeK, K);
            double i = (double)grid.SizeI / sizeI, j = (double)grid.SizeJ / sizeJ, k = (double)grid.SizeK / sizeK;
            PointMm origin = grid.IjkToLps.TransformPoint(new PointMm((i - 1) / 2, (j - 1) / 2, (k - 1) / 2));
            Affine map = grid.IjkToLps;
            return new VolumeGeometry(sizeI, sizeJ, sizeK, Affine.FromColumns(map.Column(0) * i, map.Column(1) * j, map.Column(2) * k, origin));
        }

        /// <inheritdoc/>
        public bool Equals(VoxelFactors other) => I == other.I && J == other.J && K == other.K;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is VoxelFactors other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(I, J, K);

        /// <summary>Such as "2 x 2 x 1".</summary>
        public override string ToString() => FormattableString.Invariant($"{I} x {J} x {K}");
    }
}
