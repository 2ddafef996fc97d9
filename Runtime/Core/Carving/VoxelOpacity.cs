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
        readonly SphereIndex index;
        readonly VisibleContents contents;
        readonly List<int> slots = new List<int>();

        public VoxelOpacity(
            SegmentedVolume volume, CentredGrid grid, BrickGrid bricks, SphereIndex index, VisibleContents contents,
            OpacityLookup lookup, float[] segmentOpacities, CutMode cut)
        {
            this.volume = volume;
            this.grid = grid;
            this.bricks = bricks;
            Lookup = lookup;
            this.segmentOpacities = segmentOpacities;
            this.cut = cut;
            this.index = index;
            this.contents = contents;
        }

        public OpacityLookup Lookup { get; }

        /// <summary>Eq. 1 for one voxel.</summary>
        public bool IsClipped(int i, int j, int k)
        {
            Span<ushort> segment = stackalloc ushort[] { volume.Labels.Indices[VoxelIndex(i, j, k)] };
            slots.Clear();
            index.Gather(i / BrickGrid.BrickSize, j / BrickGrid.BrickSize, k / BrickGrid.BrickSize, CutMode.Binary, segment, slots);
            grid.Position(i, j, k, out float x, out float y, out float z);
            foreach (int slot in slots)
            {
                if (ClipTest.Inside(index.PlaceOf(slot), x, y, z))
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

        /// <summary>Lists the spheres that can touch a visible voxel of a brick, and perhaps a few that cannot.</summary>
        public void FindReaching(int brickX, int brickY, int brickZ, List<CentredSphere> reaching)
        {
            slots.Clear();
            index.Gather(brickX, brickY, brickZ, cut, contents[bricks.IndexOf(brickX, brickY, brickZ)], slots);
            reaching.Clear();
            foreach (int slot in slots)
                reaching.Add(new CentredSphere(index.PlaceOf(slot), index.MaskOf(slot)));
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
    }
}
