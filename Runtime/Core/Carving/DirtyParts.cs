using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// What of a dirty brick is dirty: the part of <see cref="DirtyBrickSet"/> that looks into bricks. Of each strip of a brick's columns it takes the places
    /// along k that both the spheres and the bricks that can differ leave possible; never too few.
    /// </summary>
    sealed class DirtyParts
    {
        const int Size = BrickGrid.BrickSize, Half = Size / 2;

        /// <summary>Bits of a neighbourhood that a halo of at most half a brick reaches: of the brick itself, of all, and of each quarter.</summary>
        const int Centre = 1 << 4, All = (1 << 9) - 1;

        static readonly int[] QuarterReaches = { 1 | 2 | 8 | 16, 2 | 4 | 16 | 32, 8 | 16 | 64 | 128, 16 | 32 | 128 | 256 };

        readonly BrickGrid bricks;
        readonly ChangedSpheres changed;
        readonly ChangedRanges ranges;
        readonly BrickSet touched;
        readonly int[] touchedAround = new int[3]; // a brick's neighbourhood by z, bits dx + 1 + 3 * (dy + 1)

        /// <param name="bricks">The volume's bricks.</param>
        /// <param name="changed">The spheres in which two carvings differ.</param>
        /// <param name="touched">The bricks in which opacities can differ.</param>
        public DirtyParts(BrickGrid bricks, ChangedSpheres changed, BrickSet touched)
        {
            this.bricks = bricks;
            this.changed = changed;
            this.touched = touched;
            ranges = new ChangedRanges(changed);
        }

        /// <summary>What of a brick can differ because opacities within a halo can, or, if asked for, because a sphere's surface gives voxels its normal.</summary>
        public BrickPart Of(int brick, int haloVoxels, bool withSurfaces)
        {
            if (!changed.AreFew)
                return BrickPart.Whole;
            bricks.BrickAt(brick, out int x, out int y, out int z);
            VoxelBox box = bricks.VoxelsOf(x, y, z);
            var own = new KRange(box.MinK, box.MaxK);
            int step = withSurfaces ? BrickPart.NormalsStep : BrickPart.OpacityStep;
            int together = withSurfaces ? 1 : BrickPart.OpacityStep / BrickPart.StripRows; // strips, which have the same places
            FindTouchedAround(x, y, z);
            if (withSurfaces)
                ranges.FindLenders(x, y, z);
            BrickPart part = BrickPart.None;
            for (int strip = 0; strip < BrickPart.Strips; strip += together)
            {
                VoxelBox columns = ColumnsOf(box, strip, together);
                if (columns.MaxI < columns.MinI || columns.MaxJ < columns.MinJ)
                    continue;
                KRange range = Near(z, strip >> 1, haloVoxels).And(own);
                if (!range.IsEmpty)
                    range = range.And(ranges.Differing(Widened(columns, haloVoxels), haloVoxels));
                if (withSurfaces && !range.Holds(own))
                    range = range.Or(ranges.WithOtherNormals(columns));
                range = range.And(own);
                for (int n = strip; n < strip + together && !range.IsEmpty; n++)
                    part = part.With(n, range.First - z * Size, range.Last - z * Size, step);
            }
            return part;
        }

        /// <summary>The columns of a strip, or of the two of a quarter.</summary>
        static VoxelBox ColumnsOf(VoxelBox box, int strip, int strips)
        {
            box.MinI += BrickPart.FirstColumnOf(strip);
            box.MaxI = Math.Min(box.MaxI, box.MinI + BrickPart.StripColumns - 1);
            box.MinJ += BrickPart.FirstRowOf(strip);
            box.MaxJ = Math.Min(box.MaxJ, box.MinJ + strips * BrickPart.StripRows - 1);
            return box;
        }

        static VoxelBox Widened(VoxelBox columns, int voxels)
        {
            columns.MinI -= voxels;
            columns.MinJ -= voxels;
            columns.MaxI += voxels;
            columns.MaxJ += voxels;
            return columns;
        }

        void FindTouchedAround(int x, int y, int z)
        {
            for (int dz = -1; dz <= 1; dz++)
            {
                int bits = 0;
                for (int dy = -1; dy <= 1; dy++)
                    for (int dx = -1; dx <= 1; dx++)
                        if (bricks.Contains(x + dx, y + dy, z + dz) && touched[bricks.IndexOf(x + dx, y + dy, z + dz)])
                            bits |= 1 << (dx + 1 + 3 * (dy + 1));
                touchedAround[dz + 1] = bits;
            }
        }

        /// <summary>Where in a quarter of a brick's columns a touched brick is within the halo.</summary>
        KRange Near(int z, int quarter, int haloVoxels)
        {
            int reached = haloVoxels == 0 ? Centre : haloVoxels > Half ? All : QuarterReaches[quarter];
            KRange range = KRange.Nowhere;
            for (int dz = -1; dz <= 1; dz++)
                if ((touchedAround[dz + 1] & reached) != 0)
                    range = range.Or(new KRange((z + dz) * Size - haloVoxels, (z + dz + 1) * Size - 1 + haloVoxels));
            return range;
        }
    }
}
