using UnityEditor;

namespace AnatomyCarve.Editor
{
    /// <summary>Tells components outside Play that assets were imported: a volume or a carving file that changed is to be seen in the scene.</summary>
    sealed class ImportNotice : AssetPostprocessor
    {
        static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets, string[] movedFromAssetPaths)
        {
            if (importedAssets.Length == 0)
                return;
            EditorLink.Imports++;
            EditorViews.Refresh();
        }
    }
}
