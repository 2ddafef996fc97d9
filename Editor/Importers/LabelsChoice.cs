namespace AnatomyCarve.Editor
{
    /// <summary>Which segmentation a scan is imported with.</summary>
    public enum LabelsChoice
    {
        /// <summary>The one beside it that is named after it, such as head.seg.nrrd or head_labels.nii.gz for head.nii; none if there is none.</summary>
        Automatic = 0,

        /// <summary>A file that is named.</summary>
        File = 1,

        /// <summary>None.</summary>
        None = 2,
    }
}
