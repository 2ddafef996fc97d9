using UnityEditor.AssetImporters;

namespace AnatomyCarve.Editor
{
    /// <summary>Imports NRRD files, those of 3D Slicer's segmentations among them.</summary>
    [ScriptedImporter(Version, "nrrd")]
    public sealed class NrrdImporter : VolumeImporter
    {
    }
}
