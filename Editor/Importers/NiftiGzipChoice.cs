using UnityEditor;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// Chooses the importer of compressed NIfTI files. Unity goes by the last extension, and .gz is no claim of this package's: two packages that
    /// claim one extension are both rejected. So each .nii.gz that comes is given its importer, unless somebody has chosen one.
    /// </summary>
    sealed class NiftiGzipChoice : AssetPostprocessor
    {
        const string LookedKey = "AnatomyCarve.NiftiGzipChoice.Looked";

        static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets, string[] movedFromAssetPaths)
        {
            foreach (string path in importedAssets)
                Choose(path);
        }

        /// <summary>Files that were in the project before the package are not imported anew by themselves: once per start of the Editor they are looked for.</summary>
        [InitializeOnLoadMethod]
        static void ChooseForOldFiles()
        {
            if (SessionState.GetBool(LookedKey, false) || AssetDatabase.IsAssetImportWorkerProcess())
                return;
            SessionState.SetBool(LookedKey, true);
            EditorApplication.delayCall += () =>
            {
                foreach (string path in AssetDatabase.GetAllAssetPaths())
                    Choose(path);
            };
        }

        static void Choose(string path)
        {
            if (VolumeFileNames.IsCompressedNifti(path) && AssetDatabase.GetImporterOverride(path) == null && IsWritable(path))
                AssetDatabase.SetImporterOverride<NiftiImporter>(path);
        }

        /// <summary>The choice is kept in the .meta file, which in an installed package cannot be written.</summary>
        static bool IsWritable(string path)
        {
            string folder = path.Substring(0, path.LastIndexOf('/'));
            return AssetDatabase.TryGetAssetFolderInfo(folder, out _, out bool immutable) && !immutable;
        }
    }
}
