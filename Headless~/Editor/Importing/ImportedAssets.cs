using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor.AssetImporters;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    /// <summary>The assets that scripted importers make: at their first use, and kept in memory.</summary>
    static class ImportedAssets
    {
        static readonly Dictionary<string, Type> s_Overrides = new();
        static readonly Dictionary<string, ImportRecord> s_Records = new();

        static ImporterTypes s_Types;

        internal static ImporterTypes Types =>
            s_Types ??= new ImporterTypes(ScriptTypes.Assemblies().SelectMany(ScriptTypes.Types).Where(t => !t.IsAbstract));

        /// <summary>Makes the engine ask here for importers.</summary>
        internal static void Install()
        {
            UnityEngine.AssetImporters.Scripted = Choose;
            AssetLibrary.Unloaded -= Forget;
            AssetLibrary.Unloaded += Forget;
        }

        /// <summary>The importer's class for a file; null if none of the scripts' imports it.</summary>
        internal static Type ImporterTypeOf(string projectPath)
        {
            var path = AssetFiles.FullPath(projectPath);
            if (path == null)
                return null;
            return OverrideOf(path) ?? Types.DefaultOf(path);
        }

        /// <summary>The importer that was chosen for a file in place of the default one; null if none was.</summary>
        internal static Type OverrideOf(string path)
        {
            if (s_Overrides.TryGetValue(AssetFiles.Normal(path), out var chosen))
                return chosen;
            var named = MetaSettings.Of(path)?.ImporterType();
            return named == Types.DefaultOf(path) ? null : named;
        }

        internal static void SetOverride(string path, Type type)
        {
            path = AssetFiles.Normal(path);
            if (type == null)
                s_Overrides.Remove(path);
            else
                s_Overrides[path] = type;
            Drop(path);
        }

        internal static ScriptedImporter ImporterOf(string projectPath) =>
            ImporterTypeOf(projectPath) is { } type && AssetFiles.FullPath(projectPath) is { } path && File.Exists(path) ? Record(path, type).Importer : null;

        internal static ImportLog LogOf(string projectPath)
        {
            if (AssetFiles.FullPath(projectPath) is not { } path)
                return null;
            AssetLibrary.LoadFile(path);
            return s_Records.TryGetValue(AssetFiles.Normal(path), out var record) && record.Log.logEntries.Length > 0 ? record.Log : null;
        }

        /// <summary>Imports a file anew with its importer's settings as they are in memory.</summary>
        internal static void Reimport(string projectPath)
        {
            var path = AssetFiles.FullPath(projectPath);
            AssetLibrary.UnloadFile(path);
            AssetLibrary.LoadFile(path);
        }

        /// <summary>Lets go of an asset and of its importer's settings.</summary>
        internal static void Drop(string path)
        {
            AssetLibrary.UnloadFile(path);
            if (s_Records.Remove(AssetFiles.Normal(path), out var record))
                record.Dispose();
        }

        /// <summary>Imported files of which the file itself, its .meta or one that it depends on is no longer as it was.</summary>
        internal static List<string> Outdated() => s_Records.Where(r => r.Value.IsOutdated).Select(r => r.Key).ToList();

        static AssetImport Choose(string path)
        {
            if ((OverrideOf(path) ?? Types.DefaultOf(path)) is not { } type)
                return null;
            return (file, objects) => Record(file, type).Import(objects);
        }

        static ImportRecord Record(string path, Type type)
        {
            path = AssetFiles.Normal(path);
            if (s_Records.TryGetValue(path, out var record) && record.Importer.GetType() == type)
                return record;
            record?.Dispose();
            return s_Records[path] = new ImportRecord(path, type);
        }

        static void Forget()
        {
            foreach (var record in s_Records.Values)
                record.Dispose();
            s_Records.Clear();
            s_Overrides.Clear();
            s_Types = null;
        }
    }
}
