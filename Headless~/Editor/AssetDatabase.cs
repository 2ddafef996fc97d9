using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>How a file is imported; headless only that it is.</summary>
    [Flags]
    public enum ImportAssetOptions
    {
        Default = 0,
        ForceUpdate = 1,
        ForceSynchronousImport = 8,
        ImportRecursive = 256,
        DontDownloadFromCacheServer = 8192,
        ForceUncompressedImport = 16384,
    }

    /// <summary>The project's files and the objects in them, by paths that begin with Assets or Packages.</summary>
    public sealed class AssetDatabase
    {
        public AssetDatabase()
        {
        }

        /// <summary>Empty if no file has the GUID.</summary>
        public static string GUIDToAssetPath(string guid) => AssetFiles.PathOf(guid) is { } path ? AssetFiles.ProjectPath(path) : "";

        /// <summary>Empty if there is no such file.</summary>
        public static string AssetPathToGUID(string path) => AssetFiles.FullPath(path) is { } full ? AssetFiles.GuidOf(full) ?? "" : "";

        public static bool AssetPathExists(string path) => AssetFiles.FullPath(path) is { } full && AssetFiles.All.Contains(full);

        public static string[] GetAllAssetPaths() => AssetFiles.All.Select(AssetFiles.ProjectPath).ToArray();

        /// <summary>Whether this process only imports for another one; there are none of that kind here.</summary>
        public static bool IsAssetImportWorkerProcess() => false;

        /// <summary>The first object of that type in the file; null if there is none.</summary>
        public static Object LoadAssetAtPath(string assetPath, Type type)
        {
            var main = LoadMainAssetAtPath(assetPath);
            return type.IsInstanceOfType(main) ? main : Array.Find(LoadAllAssetsAtPath(assetPath), type.IsInstanceOfType);
        }

        public static T LoadAssetAtPath<T>(string assetPath) where T : Object => (T)LoadAssetAtPath(assetPath, typeof(T));

        public static Object LoadMainAssetAtPath(string assetPath) => Objects(assetPath)?.Main;

        public static Object[] LoadAllAssetsAtPath(string assetPath) => Objects(assetPath)?.Values.ToArray() ?? Array.Empty<Object>();

        /// <summary>Empty for an object that is no asset.</summary>
        public static string GetAssetPath(Object assetObject) => AssetLibrary.FileOf(assetObject) is { } path ? AssetFiles.ProjectPath(path) : "";

        public static bool Contains(Object obj) => AssetLibrary.FileOf(obj) != null;

        public static bool IsMainAsset(Object obj) => AssetLibrary.FileOf(obj) is { } path && ReferenceEquals(AssetLibrary.LoadFile(path).Main, obj);

        public static bool IsSubAsset(Object obj) => Contains(obj) && !IsMainAsset(obj);

        public static bool TryGetGUIDAndLocalFileIdentifier(Object obj, out string guid, out long localId)
        {
            var path = AssetLibrary.FileOf(obj);
            guid = path == null ? "" : AssetFiles.GuidOf(path) ?? "";
            localId = path == null ? 0 : AssetLibrary.LoadFile(path).First(o => ReferenceEquals(o.Value, obj)).Key;
            return path != null;
        }

        public static void ImportAsset(string path) => ImportAsset(path, ImportAssetOptions.Default);

        /// <summary>Takes the file in as it is now, and tells postprocessors.</summary>
        public static void ImportAsset(string path, ImportAssetOptions options)
        {
            MainThread.Check("ImportAsset");
            if (AssetFiles.FullPath(path) is not { } full)
                return;
            AssetFiles.Refresh(full);
            ImportedAssets.Drop(full);
            Postprocessors.Send(new[] { path }, Array.Empty<string>());
        }

        public static void Refresh() => Refresh(ImportAssetOptions.Default);

        /// <summary>Takes in what came, changed or went since the last time.</summary>
        public static void Refresh(ImportAssetOptions options)
        {
            MainThread.Check("Refresh");
            var before = AssetFiles.All.ToList();
            AssetFiles.Rescan();
            var changed = ImportedAssets.Outdated();
            var gone = before.Except(AssetFiles.All).ToList();
            foreach (var path in changed.Concat(gone))
                ImportedAssets.Drop(path);
            var imported = AssetFiles.All.Except(before).Concat(changed.Where(File.Exists)).Distinct();
            Postprocessors.Send(imported.Select(AssetFiles.ProjectPath), gone.Select(AssetFiles.ProjectPath));
            EditorApplication.RaiseProjectChanged();
        }

        public static Type GetImporterType(string assetPath) => ImportedAssets.ImporterTypeOf(assetPath);

        public static Type GetDefaultImporter(string path) => ImportedAssets.Types.DefaultOf(path);

        public static Type[] GetAvailableImporters(string path) => ImportedAssets.Types.AvailableFor(path);

        /// <summary>Null if the file is imported as by default.</summary>
        public static Type GetImporterOverride(string path) => AssetFiles.FullPath(path) is { } full ? ImportedAssets.OverrideOf(full) : null;

        /// <summary>Chooses an importer for a file, which is imported anew.</summary>
        /// <exception cref="InvalidOperationException">The importer does not take such files.</exception>
        public static void SetImporterOverride<T>(string path) where T : AssetImporter
        {
            MainThread.Check("SetImporterOverride");
            if (AssetFiles.FullPath(path) is not { } full)
                return;
            if (!GetAvailableImporters(path).Contains(typeof(T)))
                throw new InvalidOperationException($"{typeof(T).FullName} is not an available importer for {path}");
            ImportedAssets.SetOverride(full, typeof(T) == GetDefaultImporter(path) ? null : typeof(T));
        }

        public static void ClearImporterOverride(string path)
        {
            MainThread.Check("ClearImporterOverride");
            if (AssetFiles.FullPath(path) is { } full)
                ImportedAssets.SetOverride(full, null);
        }

        /// <summary>Whether a folder is one of the project's roots or lies below, and whether nothing may be written there.</summary>
        public static bool TryGetAssetFolderInfo(string path, out bool rootFolder, out bool immutable)
        {
            rootFolder = AssetFiles.IsRoot(path);
            immutable = false;
            return AssetFiles.FullPath(path) is { } full && Directory.Exists(full);
        }

        static AssetObjects Objects(string assetPath) => AssetFiles.FullPath(assetPath) is { } full && File.Exists(full) ? AssetLibrary.LoadFile(full) : null;
    }
}
