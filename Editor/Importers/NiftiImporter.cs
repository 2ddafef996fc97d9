using UnityEditor.AssetImporters;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Imports NIfTI files. Compressed ones have the extension .gz, which is everybody's: for those it only can be chosen, which
    /// <see cref="NiftiGzipChoice"/> does.
    /// </summary>
    [ScriptedImporter(Version, new[] { "nii" }, new[] { "gz" })]
    public sealed class NiftiImporter : VolumeImporter
    {
    }
}
