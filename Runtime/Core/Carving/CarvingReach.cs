using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// How far a clip sphere can be felt: the box of voxels whose opacity it can change, and by how many voxels each later stage widens it.
    /// Everything that skips work (brick culling, caches, dirty bricks) takes its reach from here.
    /// </summary>
    public static class CarvingReach
    {
        /// <summary>Voxels that AntiAlias reads on each side of a voxel.</summary>
        public const int AntiAliasVoxels = 1;

        /// <summary>Voxels that SobelNormals reads on each side of a voxel.</summary>
        public const int SobelVoxels = 3;

        /// <summary>Voxels by which a changed opacity can change something in the last volume stage.</summary>
        public const int NormalsVoxels = AntiAliasVoxels + SobelVoxels;

        /// <summary>
        /// How near to a sphere's surface a voxel may take the sphere's normal, in extents of a voxel along it (the kernel's SURFACE_REACH): as far as the voxels
        /// between which a visible point of a cut lies.
        /// </summary>
        public const double SurfaceExtents = 1.75;

        /// <summary>
        /// What the float computation of a distance may be off by, relative to the lengths that enter it. Rounding is below 1e-6 (eight roundings
        /// of 6e-8 each); the rest is reserve.
        /// </summary>
        public const double RelativeSlack = 4e-6;

        /// <summary>
        /// How far beyond a sphere's radius a voxel's centre may lie and still be touched, in millimetres: for smooth cuts half a voxel's largest
        /// extent, and the float computation's rounding.
        /// </summary>
        /// <exception cref="ArgumentNullException"><paramref name="grid"/> is null.</exception>
        public static double BeyondRadiusMm(CentredGrid grid, in SphereF sphere, CutMode cut)
        {
            if (grid == null)
                throw new ArgumentNullException(nameof(grid));
            VolumeGeometry geometry = grid.Geometry;
            double halfExtent = 0;
            double halfDiagonal = 0;
            for (int column = 0; column < 3; column++)
            {
                double step = Math.Sqrt(Square(grid[0, column]) + Square(grid[1, column]) + Square(grid[2, column]));
                halfExtent += 0.5 * step;
                halfDiagonal += 0.5 * step * (column == 0 ? geometry.SizeI : column == 1 ? geometry.SizeJ : geometry.SizeK);
            }
            double lengths = sphere.Radius + halfDiagonal + Math.Abs((double)sphere.X) + Math.Abs((double)sphere.Y) + Math.Abs((double)sphere.Z);
            return (cut == CutMode.Smooth ? halfExtent : 0) + RelativeSlack * lengths;
        }

        /// <summary>
        /// The box of voxels whose opacity a sphere can change, widened by a stage's halo and kept inside the volume.
        /// </summary>
        /// <param name="grid">The volume's grid.</param>
        /// <param name="sphere">The sphere in centred millimetres.</param>
        /// <param name="cut">The cut mode.</param>
        /// <param name="haloVoxels">Voxels to widen by, 0 or more.</param>
        /// <param name="box">The box; undefined where there is none.</param>
        /// <returns>False where the sphere touches no voxel of the volume. A sphere beyond float's range counts as touching all.</returns>
        /// <exception cref="ArgumentNullException"><paramref name="grid"/> is null.</exception>
        public static bool TryVoxelBox(CentredGrid grid, in SphereF sphere, CutMode cut, int haloVoxels, out VoxelBox box)
        {
            if (grid == null)
                throw new ArgumentNullException(nameof(grid));
            return TryVoxelBox(grid, sphere, BeyondRadiusMm(grid, sphere, cut), haloVoxels, out box);
        }

        /// <summary>The same for what is felt some millimetres beyond the radius.</summary>
        internal static bool TryVoxelBox(CentredGrid grid, in SphereF sphere, double beyondRadiusMm, int haloVoxels, out VoxelBox box)
        {
            box = default;
            if (!(sphere.Radius > 0))
                return false;
            double reach = sphere.Radius + beyondRadiusMm;
            VolumeGeometry geometry = grid.Geometry;
            Affine lpsToIjk = geometry.LpsToIjk;
            return Along(lpsToIjk, 0, sphere, reach, grid.CentreI, geometry.SizeI, haloVoxels, out box.MinI, out box.MaxI)
                && Along(lpsToIjk, 1, sphere, reach, grid.CentreJ, geometry.SizeJ, haloVoxels, out box.MinJ, out box.MaxJ)
                && Along(lpsToIjk, 2, sphere, reach, grid.CentreK, geometry.SizeK, haloVoxels, out box.MinK, out box.MaxK);
        }

        static bool Along(Affine lpsToIjk, int row, in SphereF sphere, double reachMm, double centreIndex, int size, int halo, out int min, out int max)
        {
            double x = lpsToIjk[row, 0], y = lpsToIjk[row, 1], z = lpsToIjk[row, 2];
            double middle = centreIndex + x * sphere.X + y * sphere.Y + z * sphere.Z;
            double half = reachMm * Math.Sqrt(x * x + y * y + z * z);
            if (double.IsNaN(middle - half) || double.IsNaN(middle + half))
            {
                min = 0;
                max = size - 1;
                return true;
            }
            double low = Math.Ceiling(middle - half);
            double high = Math.Floor(middle + half);
            min = (int)Math.Max(0, Math.Min(size, low) - halo);
            max = (int)Math.Min(size - 1, Math.Max(-1, high) + halo);
            return low <= high && high >= 0 && low <= size - 1;
        }

        static double Square(double value) => value * value;
    }
}
