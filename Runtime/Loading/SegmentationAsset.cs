using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// A segmentation's file as an asset of the project: which segments it holds. Its voxels go into the <see cref="VolumeAsset"/> of the scan
    /// that it belongs to.
    /// </summary>
    public sealed class SegmentationAsset : ScriptableObject
    {
        [SerializeField, Tooltip("Voxels along the three axes")]
        Vector3Int size;

        [SerializeField, Tooltip("Distance between voxels along the three axes, mm")]
        Vector3 spacingMm;

        [SerializeField, Tooltip("The segments, label 0 first")]
        VolumeAssetSegment[] segments = Array.Empty<VolumeAssetSegment>();

        [SerializeField, Tooltip("The file that it was made of, without folders")]
        string source = "";

        /// <summary>Voxels along the three axes.</summary>
        public Vector3Int Size => size;

        /// <summary>Distance between voxels along the three axes, mm.</summary>
        public Vector3 SpacingMm => spacingMm;

        /// <summary>The segments: label 0 first, then ascending labels.</summary>
        public IReadOnlyList<VolumeAssetSegment> Segments => segments;

        /// <summary>The file that it was made of, without folders.</summary>
        public string Source => source;

        /// <param name="labels">The segmentation.</param>
        /// <param name="source">Its file, without folders.</param>
        internal static SegmentationAsset Create(LabelMap labels, string source)
        {
            var asset = CreateInstance<SegmentationAsset>();
            VolumeGeometry g = labels.Geometry;
            asset.size = new Vector3Int(g.SizeI, g.SizeJ, g.SizeK);
            asset.spacingMm = new Vector3((float)g.SpacingMm.X, (float)g.SpacingMm.Y, (float)g.SpacingMm.Z);
            asset.segments = AssetSegments.Of(labels);
            asset.source = source;
            return asset;
        }
    }
}
