using System;
using System.Collections.Generic;
using System.IO;

namespace UnityEngine
{
    /// <summary>Makes the objects of a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="objects">Receives the objects.</param>
    delegate void AssetImport(string path, AssetObjects objects);

    /// <summary>What turns a file of the package into objects: one importer per extension, unless the Editor's part chooses another.</summary>
    static class AssetImporters
    {
        static readonly Dictionary<string, AssetImport> s_Importers = new(StringComparer.OrdinalIgnoreCase);

        /// <summary>Asked first: the importer that scripts bring for a file; null where they bring none.</summary>
        internal static Func<string, AssetImport> Scripted { get; set; }

        /// <summary>Registers an importer of files that hold a single object, or replaces one.</summary>
        /// <param name="extension">With its dot, such as ".compute".</param>
        /// <param name="mainId">The fileID by which YAML refers to the object in the file, such as 7200000 for a compute shader.</param>
        /// <param name="load">Makes the object from the file's path.</param>
        internal static void Register(string extension, long mainId, Func<string, Object> load) =>
            Register(extension, (path, objects) => AssetLibrary.Enter(objects, mainId, load(path), Path.GetFileNameWithoutExtension(path)));

        /// <summary>Registers an importer, or replaces one.</summary>
        internal static void Register(string extension, AssetImport import) => s_Importers[extension] = import;

        /// <summary>The importer of a file; null if there is none.</summary>
        internal static AssetImport For(string path) =>
            Scripted?.Invoke(path) ?? (s_Importers.TryGetValue(Path.GetExtension(path), out var import) ? import : null);
    }
}
