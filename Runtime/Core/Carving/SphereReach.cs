using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>How much of a box of voxels a clip sphere covers.</summary>
    enum BoxCover
    {
        /// <summary>Nothing of any voxel.</summary>
        None,

        /// <summary>Perhaps some voxels, or parts of them.</summary>
        Part,

        /// <summary>All voxels, wholly.</summary>
        Whole,
    }

    /// <summary>
    /// Spheres against boxes of voxels: never None or Whole where it is not so in the kernels' float arithmetic too. Exact on grids with right angles; on
    /// sheared grids the box's bounding ball is taken.
    /// </summary>
    sealed class SphereReach
    {
        const double RightAngle = 1e-9;

        readonly CentredGrid grid;
        readonly double[,] toIndex = new double[3, 3];
        readonly double stepI, stepJ, stepK;
        readonly double halfVoxelMm, halfDiagonalMm, unevenMm2;
        readonly bool rightAngled;

        public SphereReach(CentredGrid grid)
        {
            this.grid = grid;
            VolumeGeometry geometry = grid.Geometry;
            Affine toIjk = geometry.LpsToIjk;
            for (int row = 0; row < 3; row++)
                for (int column = 0; column < 3; column++)
                    toIndex[row, column] = toIjk[row, column];
            stepI = Length(0);
            stepJ = Length(1);
            stepK = Length(2);
            halfDiagonalMm = 0.5 * (stepI * geometry.SizeI + stepJ * geometry.SizeJ + stepK * geometry.SizeK);
            rightAngled = Math.Abs(Dot(0, 1)) <= RightAngle * stepI * stepJ && Math.Abs(Dot(0, 2)) <= RightAngle * stepI * stepK
                && Math.Abs(Dot(1, 2)) <= RightAngle * stepJ * stepK;
            // Half of a voxel's largest extent along any direction n, |n.a| + |n.b| + |n.c|: with right angles it is that along the diagonal.
            double shortest = Math.Min(stepI, Math.Min(stepJ, stepK));
            unevenMm2 = 0.25 * (stepI * stepI + stepJ * stepJ + stepK * stepK - shortest * shortest);
            halfVoxelMm = 0.5 * (rightAngled ? Math.Sqrt(stepI * stepI + stepJ * stepJ + stepK * stepK) : stepI + stepJ + stepK);
        }

        /// <summary>A sphere's coverage of voxels, made ready for many boxes.</summary>
        public Ready Of(in SphereF sphere, CutMode cut) => Of(sphere, cut == CutMode.Smooth ? 0.5 : 0);

        /// <summary>The voxels whose coverage or normal a sphere can change; false for none.</summary>
        public bool TrySurfaceBox(in SphereF sphere, out VoxelBox box) =>
            CarvingReach.TryVoxelBox(grid, sphere, SurfaceBandMm + CarvingReach.RelativeSlack * Lengths(sphere), 0, out box);

        /// <summary>A sphere's surface, with the voxels near it that may take its normal: a part = such voxels, whole = deep inside.</summary>
        public Ready SurfaceOf(in SphereF sphere) => Of(sphere, CarvingReach.SurfaceExtents);

        /// <summary>
        /// A sphere that is felt within some extents of a voxel from its surface, along the surface's normal n. Extents along n are 2 n.h, where h is the half
        /// diagonal of a box as large as the voxel whose corner points to the sphere's centre. With c = 2 * extents, felt at distance |d| means |d| - c n.h no more
        /// than the radius; and the square of c h's corner's distance, |d - c h|^2, is (|d| - c n.h)^2 + c^2 (h^2 - (n.h)^2), of which the last is at most
        /// c^2 times what the box has more than its shortest half. So the sphere, a little larger, meets the voxel's box, widened to these extents. Likewise
        /// it holds wholly what it holds up to the farthest corner of that box.
        /// </summary>
        Ready Of(in SphereF sphere, double extents)
        {
            double slack = CarvingReach.RelativeSlack * Lengths(sphere), widened = rightAngled ? extents : 0;
            double uneven = 4 * widened * widened * unevenMm2, band = slack + (rightAngled ? 0 : 2 * extents * halfVoxelMm);
            double outer = Math.Sqrt(sphere.Radius * (double)sphere.Radius + uneven) + band, inner = sphere.Radius - band;
            return new Ready(
                grid.CentreI + toIndex[0, 0] * sphere.X + toIndex[0, 1] * sphere.Y + toIndex[0, 2] * sphere.Z,
                grid.CentreJ + toIndex[1, 0] * sphere.X + toIndex[1, 1] * sphere.Y + toIndex[1, 2] * sphere.Z,
                grid.CentreK + toIndex[2, 0] * sphere.X + toIndex[2, 1] * sphere.Y + toIndex[2, 2] * sphere.Z,
                sphere.Radius > 0 ? outer * outer : -1, inner > 0 ? inner * inner : -1, widened);
        }

        double SurfaceBandMm => 2 * CarvingReach.SurfaceExtents * halfVoxelMm;

        double Lengths(in SphereF sphere) =>
            sphere.Radius + halfDiagonalMm + Math.Abs((double)sphere.X) + Math.Abs((double)sphere.Y) + Math.Abs((double)sphere.Z);

        public BoxCover Cover(in Ready sphere, in VoxelBox box)
        {
            double nearest, farthest;
            if (rightAngled)
            {
                Along(sphere.I, box.MinI, box.MaxI, stepI, sphere.Widened, out double ni, out double fi);
                Along(sphere.J, box.MinJ, box.MaxJ, stepJ, sphere.Widened, out double nj, out double fj);
                Along(sphere.K, box.MinK, box.MaxK, stepK, sphere.Widened, out double nk, out double fk);
                nearest = ni + nj + nk;
                farthest = fi + fj + fk;
            }
            else
            {
                double distance = MmBetween(sphere, 0.5 * (box.MinI + box.MaxI), 0.5 * (box.MinJ + box.MaxJ), 0.5 * (box.MinK + box.MaxK));
                double ball = 0.5 * ((box.MaxI - box.MinI) * stepI + (box.MaxJ - box.MinJ) * stepJ + (box.MaxK - box.MinK) * stepK);
                nearest = Math.Max(0, distance - ball);
                farthest = distance + ball;
                nearest *= nearest;
                farthest *= farthest;
            }
            if (nearest > sphere.OuterSquared)
                return BoxCover.None;
            return farthest < sphere.InnerSquared ? BoxCover.Whole : BoxCover.Part; // NaN, of spheres beyond all measure, is a part
        }

        /// <summary>
        /// Where along k a sphere may touch voxels of a rectangle of columns, and where it surely covers all of them. On sheared grids everywhere and nowhere.
        /// </summary>
        public void Along(in Ready sphere, in VoxelBox columns, out KRange touched, out KRange covered)
        {
            covered = KRange.Nowhere;
            touched = KRange.Everywhere;
            if (!rightAngled)
                return;
            Along(sphere.I, columns.MinI, columns.MaxI, stepI, sphere.Widened, out double nearI, out double farI);
            Along(sphere.J, columns.MinJ, columns.MaxJ, stepJ, sphere.Widened, out double nearJ, out double farJ);
            double left = sphere.OuterSquared - nearI - nearJ, deep = sphere.InnerSquared - farI - farJ;
            if (left < 0)
            {
                touched = KRange.Nowhere;
                return;
            }
            double length = Math.Sqrt(left) / stepK + sphere.Widened;
            touched = new KRange(Place(Math.Ceiling(sphere.K - length), int.MinValue), Place(Math.Floor(sphere.K + length), int.MaxValue));
            if (!(deep > 0))
                return;
            length = Math.Sqrt(deep) / stepK - sphere.Widened;
            covered = new KRange(Place(Math.Floor(sphere.K - length) + 1, 0), Place(Math.Ceiling(sphere.K + length) - 1, -1));
        }

        static int Place(double k, int notANumber) => double.IsNaN(k) ? notANumber : (int)Math.Max(-1e9, Math.Min(1e9, k));

        static void Along(double centre, int min, int max, double stepMm, double widened, out double nearestSquared, out double farthestSquared)
        {
            double toMin = (min - widened - centre) * stepMm, toMax = (max + widened - centre) * stepMm;
            double nearest = toMin > 0 ? toMin : toMax < 0 ? toMax : 0;
            nearestSquared = nearest * nearest;
            farthestSquared = Math.Max(toMin * toMin, toMax * toMax);
        }

        double MmBetween(in Ready sphere, double i, double j, double k)
        {
            double di = i - sphere.I, dj = j - sphere.J, dk = k - sphere.K;
            double x = grid[0, 0] * di + grid[0, 1] * dj + grid[0, 2] * dk;
            double y = grid[1, 0] * di + grid[1, 1] * dj + grid[1, 2] * dk;
            double z = grid[2, 0] * di + grid[2, 1] * dj + grid[2, 2] * dk;
            return Math.Sqrt(x * x + y * y + z * z);
        }

        double Length(int column) => Math.Sqrt(Dot(column, column));

        double Dot(int a, int b) => (double)grid[0, a] * grid[0, b] + (double)grid[1, a] * grid[1, b] + (double)grid[2, a] * grid[2, b];

        /// <summary>A sphere's centre in voxel indices, and the squares of the distances within which it may touch and surely covers, in mm.</summary>
        public readonly struct Ready
        {
            public Ready(double i, double j, double k, double outerSquared, double innerSquared, double widened)
            {
                I = i;
                J = j;
                K = k;
                OuterSquared = outerSquared;
                InnerSquared = innerSquared;
                Widened = widened;
            }

            public double I { get; }

            public double J { get; }

            public double K { get; }

            public double OuterSquared { get; }

            public double InnerSquared { get; }

            /// <summary>Voxels by which boxes are larger, for these distances, than their voxels' centres say.</summary>
            public double Widened { get; }
        }
    }
}
