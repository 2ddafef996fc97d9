using System;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Imports a volume's file: a scan becomes a <see cref="VolumeAsset"/> with the segmentation that belongs to it, a segmentation becomes a
    /// <see cref="SegmentationAsset"/>.
    /// </summary>
    public abstract class VolumeImporter : ScriptedImporter
    {
        /// <summary>
        /// Raise it whenever the same file with the same settings gives another asset: another packed format, picture, histogram, name or field. Unity then
        /// imports all volumes of a project anew. What is only read differently in error (a clearer message) needs no new version.
        /// </summary>
        internal const int Version = 1;

        [SerializeField, Tooltip("What the file is; Automatic goes by name and header")]
        VolumeRole role = VolumeRole.Automatic;

        [SerializeField, Tooltip("Which segmentation belongs to the scan; Automatic takes NAME.seg.nrrd, NAME_labels.nii.gz and the like beside it")]
        LabelsChoice labels = LabelsChoice.Automatic;

        [SerializeField, Tooltip("The segmentation's file relative to the scan's folder, if one is chosen")]
        string labelsFile = "";

        /// <summary>What the file is imported as.</summary>
        public VolumeRole Role
        {
            get => role;
            set => role = value;
        }

        /// <summary>Which segmentation a scan is imported with.</summary>
        public LabelsChoice Labels
        {
            get => labels;
            set => labels = value;
        }

        /// <summary>
        /// The segmentation's file relative to the scan's folder, with slashes; counts if <see cref="Labels"/> is <see cref="LabelsChoice.File"/>.
        /// </summary>
        public string LabelsFile
        {
            get => labelsFile;
            set => labelsFile = value ?? "";
        }

        /// <summary>Called by Unity.</summary>
        public override void OnImportAsset(AssetImportContext ctx)
        {
            if (ctx == null)
                throw new ArgumentNullException(nameof(ctx));
            new VolumeImport(ctx).Run(this);
        }
    }
}
