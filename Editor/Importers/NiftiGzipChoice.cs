using UnityEditor;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Chooses the importer of compressed NIfTI files. Unity goes by the last extension, and .gz is no claim of this package's: two packages that
    /// claim one extension are both rejected. So each .nii.gz that comes is given its importer, unless somebody has chosen one.
    /// </summary>
    sealed class NiftiGzipChoice : AssetPostprocessor
    {
        static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets, string[] movedFromAssetPaths)
        {
            foreach (string path in importedAssets)
            {
                if (VolumeFileNames.IsCompressedNifti(path) && AssetDatabase.GetImporterOverride(path) == null && IsWritable(path))
                    AssetDatabase.SetImporterOverride<NiftiImporter>(path);
            }
        }

        /// <summary>The choice is kept in the .meta file, which in an installed package cannot be written.</summary>
        static bool IsWritable(string path)
        {
            string folder = path.Substring(0, path.LastIndexOf('/'));
            return AssetDatabase.TryGetAssetFolderInfo(folder, out _, out bool immutable) && !immutable;
        }
    }
}
