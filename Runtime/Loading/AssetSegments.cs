using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>Turns a label map's table into what assets list.</summary>
    static class AssetSegments
    {
        /// <summary>The rows of the table, in its order: label 0 first.</summary>
        public static VolumeAssetSegment[] Of(LabelMap labels)
        {
            SegmentTable table = labels.Segments;
            IReadOnlyList<long> voxels = labels.VoxelCounts;
            var rows = new VolumeAssetSegment[table.Count];
            for (int row = 0; row < rows.Length; row++)
            {
                Segment segment = table[row];
                var color = new Color32(segment.Color.R, segment.Color.G, segment.Color.B, byte.MaxValue);
                rows[row] = new VolumeAssetSegment(segment.Label, segment.Name, color, voxels[row]);
            }

            return rows;
        }
    }
}
