using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// Which segments a transfer function and segment opacities show in each brick, carved away or not; never too few. Carving only takes away: what is not
    /// listed here is empty whatever the spheres do, so that no edit of a carving can change it.
    /// </summary>
    public sealed class VisibleContents
    {
        /// <summary>Opacities that are stored as 0: below half of a code, less what rounding may do.</summary>
        const float Nothing = 0.4999f / 255f;

        readonly BlockContents blocks;
        readonly ushort[] segments;
        readonly ushort[] counts;
        readonly bool[] isNearMatter;

        VisibleContents(BlockContents blocks, ushort[] segments, ushort[] counts, bool[] isNearMatter)
        {
            this.isNearMatter = isNearMatter;
            this.blocks = blocks;
            this.segments = segments;
            this.counts = counts;
        }

        /// <summary>The number of bricks.</summary>
        public int Count => counts.Length;

        /// <summary>The segments of a brick that are visible before carving; empty = the brick has opacity 0 everywhere.</summary>
        /// <param name="brick">The brick's number, 0 to Count - 1.</param>
        public ReadOnlySpan<ushort> this[int brick] => new ReadOnlySpan<ushort>(segments, blocks.FirstEntry(brick), counts[brick]);

        /// <summary>Whether a mask holds any segment of a brick, visible or not: voxels of opacity 0 have normals too.</summary>
        internal bool AnyIsIn(SegmentMask mask, int brick)
        {
            foreach (BlockContents.Entry entry in blocks[brick])
                if (mask[entry.Segment])
                    return true;
            return false;
        }

        /// <summary>
        /// Whether the brick or one of those around it has a visible segment: elsewhere anti-aliased opacity and normals are empty too, whatever the carving.
        /// </summary>
        /// <param name="brick">The brick's number.</param>
        public bool IsNearMatter(int brick) => isNearMatter[brick];

        /// <summary>Finds them from what the blocks hold; no voxel is looked at.</summary>
        /// <param name="volume">The volume.</param>
        /// <param name="lookup">Its transfer function.</param>
        /// <param name="segmentOpacities">The opacity of each segment, 0 to 1.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">There are not as many opacities as segments.</exception>
        public static VisibleContents Of(SegmentedVolume volume, OpacityLookup lookup, ReadOnlySpan<float> segmentOpacities)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            if (lookup == null)
                throw new ArgumentNullException(nameof(lookup));
            if (segmentOpacities.Length != volume.Segments.Count)
                throw new ArgumentException(FormattableString.Invariant(
                    $"There are {segmentOpacities.Length} opacities for {volume.Segments.Count} segments."), nameof(segmentOpacities));
            BlockContents blocks = volume.Blocks;
            int[] shownBelow = ShownCodesBelow(lookup);
            var visible = new ushort[blocks.EntryCount];
            var counts = new ushort[blocks.Count];
            for (int block = 0; block < counts.Length; block++)
            {
                int first = blocks.FirstEntry(block), count = 0;
                foreach (BlockContents.Entry entry in blocks[block])
                {
                    bool shown = segmentOpacities[entry.Segment] > Nothing && shownBelow[entry.HighestCode + 1] > shownBelow[entry.LowestCode];
                    if (shown)
                        visible[first + count++] = entry.Segment;
                }
                counts[block] = (ushort)count;
            }
            return new VisibleContents(blocks, visible, counts, NearMatter(new BrickGrid(volume.Geometry), counts));
        }

        static bool[] NearMatter(BrickGrid bricks, ushort[] counts)
        {
            var near = new bool[counts.Length];
            for (int brick = 0; brick < counts.Length; brick++)
            {
                if (counts[brick] == 0)
                    continue;
                bricks.BrickAt(brick, out int x, out int y, out int z);
                for (int dz = -1; dz <= 1; dz++)
                    for (int dy = -1; dy <= 1; dy++)
                        for (int dx = -1; dx <= 1; dx++)
                            if (bricks.Contains(x + dx, y + dy, z + dz))
                                near[bricks.IndexOf(x + dx, y + dy, z + dz)] = true;
            }
            return near;
        }

        /// <summary>For each code, how many smaller ones are shown.</summary>
        static int[] ShownCodesBelow(OpacityLookup lookup)
        {
            var below = new int[ushort.MaxValue + 2];
            for (int code = 0; code <= ushort.MaxValue; code++)
                below[code + 1] = below[code] + (lookup.OpacityOf((ushort)code) > Nothing ? 1 : 0);
            return below;
        }
    }
}
