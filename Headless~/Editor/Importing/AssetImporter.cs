using System;
using UnityEditor.AssetImporters;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>The settings of one asset's import. Headless they are read from the .meta, and never written.</summary>
    public class AssetImporter : Object
    {
        public AssetImporter()
        {
        }

        /// <summary>The asset's path in the project.</summary>
        public string assetPath { get; internal set; } = "";

        public string userData { get; set; } = "";

        public string assetBundleName { get; set; } = "";

        public string assetBundleVariant { get; set; } = "";

        /// <summary>Whether the .meta holds no settings.</summary>
        public bool importSettingsMissing { get; internal set; }

        /// <summary>The importer of an asset; null if there is no such file, or none imports it.</summary>
        public static AssetImporter GetAtPath(string path) => ImportedAssets.ImporterOf(path);

        /// <summary>What the last import said; null if it said nothing.</summary>
        public static ImportLog GetImportLog(string path) => ImportedAssets.LogOf(path);

        /// <summary>Imports the asset anew with the settings as they are.</summary>
        public void SaveAndReimport() => ImportedAssets.Reimport(assetPath);
    }
}
