using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>The segments that an asset lists, as a table that can be searched.</summary>
    static class AssetTable
    {
        /// <summary>The table; null where an asset lists nothing, as one that was never filled does.</summary>
        public static SegmentTable Of(IReadOnlyList<VolumeAssetSegment> segments) => segments.Count == 0 ? null : new SegmentTable(segments.Select(
            (s, index) => new Segment(index, s.Label, s.Name, new SegmentColor(s.Color.r, s.Color.g, s.Color.b))));

        /// <summary>How many voxels each row has.</summary>
        public static long[] VoxelCounts(IReadOnlyList<VolumeAssetSegment> segments) => segments.Select(s => s.Voxels).ToArray();
    }
}
