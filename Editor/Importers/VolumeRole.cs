namespace AnatomyCarve.Editor
{
    /// <summary>What a volume's file is imported as.</summary>
    public enum VolumeRole
    {
        /// <summary>By its name and header: see <see cref="VolumeFileNames"/>.</summary>
        Automatic = 0,

        /// <summary>A scan: intensities. It becomes a <see cref="VolumeAsset"/>.</summary>
        Scan = 1,

        /// <summary>A segmentation: labels. It becomes a <see cref="SegmentationAsset"/>.</summary>
        Segmentation = 2,
    }
}
