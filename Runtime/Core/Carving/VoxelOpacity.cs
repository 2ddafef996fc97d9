using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>The CPU twin of the kernel <c>ClipVoxels</c>, voxel by voxel, for one fixed set of inputs.</summary>
    sealed class VoxelOpacity
    {
        readonly SegmentedVolume volume;
        readonly CentredGrid grid;
        readonly BrickGrid bricks;
        readonly float[] segmentOpacities;
        readonly CutMode cut;
        readonly CentredSphere[] spheres;
        readonly double brickRadiusMm;

        public VoxelOpacity(
            SegmentedVolume volume, CentredGrid grid, BrickGrid bricks, IReadOnlyList<ClipSphere> carving,
            OpacityLookup lookup, float[] segmentOpacities, CutMode cut)
        {
            this.volume = volume;
            this.grid = grid;
            this.bricks = bricks;
            Lookup = lookup;
            this.segmentOpacities = segmentOpacities;
            this.cut = cut;
            spheres = Effective(carving, grid, cut);
            brickRadiusMm = BrickRadiusMm(grid);
        }

        public OpacityLookup Lookup { get; }

        /// <summary>Eq. 1 for one voxel.</summary>
        public bool IsClipped(int i, int j, int k)
        {
            int segment = volume.Labels.Indices[VoxelIndex(i, j, k)];
            grid.Position(i, j, k, out float x, out float y, out float z);
            foreach (CentredSphere sphere in spheres)
            {
                if (sphere.Mask[segment] && ClipTest.Inside(sphere.Place, x, y, z))
                    return true;
            }
            return false;
        }

        /// <summary>A voxel's opacity code, cut by the spheres that reach its brick: opacity * 255, ties to even.</summary>
        public byte Code(int i, int j, int k, List<CentredSphere> reaching)
        {
            long voxel = VoxelIndex(i, j, k);
            float opacity = Uncut(voxel);
            if (!(opacity > 0))
                return 0;
            float coverage = reaching.Count == 0 ? 0 : Coverage(i, j, k, volume.Labels.Indices[voxel], reaching);
            return ToCode((float)(opacity * (float)(1 - coverage)));
        }

        /// <summary>Whether any voxel of a brick is above 0 when nothing is clipped.</summary>
        public bool HasMatter(int brickX, int brickY, int brickZ)
        {
            int lastI = Math.Min((brickX + 1) * BrickGrid.BrickSize, bricks.SizeI);
            int lastJ = Math.Min((brickY + 1) * BrickGrid.BrickSize, bricks.SizeJ);
            int lastK = Math.Min((brickZ + 1) * BrickGrid.BrickSize, bricks.SizeK);
            for (int k = brickZ * BrickGrid.BrickSize; k < lastK; k++)
                for (int j = brickY * BrickGrid.BrickSize; j < lastJ; j++)
                    for (int i = brickX * BrickGrid.BrickSize; i < lastI; i++)
                    {
                        if (ToCode(Uncut(VoxelIndex(i, j, k))) > 0)
                            return true;
                    }
            return false;
        }

        /// <summary>Lists the spheres that can touch a voxel of a brick, and perhaps a few that cannot.</summary>
        public void FindReaching(int brickX, int brickY, int brickZ, List<CentredSphere> reaching)
        {
            const float ToMiddle = (BrickGrid.BrickSize - 1) * 0.5f;
            double fi = brickX * BrickGrid.BrickSize + ToMiddle - grid.CentreI;
            double fj = brickY * BrickGrid.BrickSize + ToMiddle - grid.CentreJ;
            double fk = brickZ * BrickGrid.BrickSize + ToMiddle - grid.CentreK;
            double x = grid[0, 0] * fi + grid[0, 1] * fj + grid[0, 2] * fk;
            double y = grid[1, 0] * fi + grid[1, 1] * fj + grid[1, 2] * fk;
            double z = grid[2, 0] * fi + grid[2, 1] * fj + grid[2, 2] * fk;
            reaching.Clear();
            foreach (CentredSphere sphere in spheres)
            {
                double dx = x - sphere.Place.X, dy = y - sphere.Place.Y, dz = z - sphere.Place.Z;
                double reach = sphere.ReachMm + brickRadiusMm;
                if (!(dx * dx + dy * dy + dz * dz > reach * reach))
                    reaching.Add(sphere);
            }
        }

        float Uncut(long voxel) =>
            (float)(Lookup.OpacityOf(volume.Intensity.Codes[voxel]) * segmentOpacities[volume.Labels.Indices[voxel]]);

        float Coverage(int i, int j, int k, int segment, List<CentredSphere> reaching)
        {
            grid.Position(i, j, k, out float x, out float y, out float z);
            float most = 0;
            foreach (CentredSphere sphere in reaching)
            {
                if (sphere.Mask[segment])
                    most = Math.Max(most, ClipTest.Coverage(grid, sphere.Place, x, y, z, cut));
            }
            return most;
        }

        static byte ToCode(float opacity) => (byte)Math.Round((float)(opacity * 255f), MidpointRounding.ToEven);

        long VoxelIndex(int i, int j, int k) => i + (long)bricks.SizeI * (j + (long)bricks.SizeJ * k);

        static CentredSphere[] Effective(IReadOnlyList<ClipSphere> carving, CentredGrid grid, CutMode cut)
        {
            var effective = new List<CentredSphere>(carving.Count);
            foreach (ClipSphere sphere in carving)
            {
                if (sphere.CanClip)
                {
                    SphereF place = grid.ToCentred(sphere);
                    effective.Add(new CentredSphere(place, sphere.Mask, place.Radius + CarvingReach.BeyondRadiusMm(grid, place, cut)));
                }
            }
            return effective.ToArray();
        }

        static double BrickRadiusMm(CentredGrid grid)
        {
            const double Half = (BrickGrid.BrickSize - 1) * 0.5;
            double longest = 0;
            for (int corner = 0; corner < 4; corner++)
            {
                double si = (corner & 1) == 0 ? Half : -Half, sj = (corner & 2) == 0 ? Half : -Half;
                double x = grid[0, 0] * si + grid[0, 1] * sj + grid[0, 2] * Half;
                double y = grid[1, 0] * si + grid[1, 1] * sj + grid[1, 2] * Half;
                double z = grid[2, 0] * si + grid[2, 1] * sj + grid[2, 2] * Half;
                longest = Math.Max(longest, Math.Sqrt(x * x + y * y + z * z));
            }
            return longest;
        }
    }
}
