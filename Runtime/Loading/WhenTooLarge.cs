namespace AnatomyCarve
{
    /// <summary>What a loader does with a volume that the device cannot hold.</summary>
    public enum WhenTooLarge
    {
        /// <summary>Makes it coarser by the smallest whole factors with which it fits, the axis with the smallest spacing first, and warns of it.</summary>
        Downsample,

        /// <summary>Fails with a <see cref="VolumeTooLargeException"/>, before voxels are read where the header says enough.</summary>
        Refuse,
    }
}
