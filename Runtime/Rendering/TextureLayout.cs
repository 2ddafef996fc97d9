namespace AnatomyCarve
{
    /// <summary>
    /// How opacity, anti-aliased opacity and normals of a volume lie in textures. Pictures are the same in both layouts; each takes at most 7 bytes per voxel (8
    /// above 255 segments), intensities and labels included.
    /// </summary>
    public enum TextureLayout
    {
        /// <summary>What the device says it can write: <see cref="Compact"/>, or else <see cref="Portable"/>.</summary>
        Automatic,

        /// <summary>Textures of 8 and 2 x 8 bits, which many devices can write and all can filter.</summary>
        Compact,

        /// <summary>
        /// The same bytes packed into 32-bit textures, which every device can write. They cannot be filtered, so that rays always read them with
        /// <see cref="OpacityFilter.Exact"/>.
        /// </summary>
        Portable,
    }
}
