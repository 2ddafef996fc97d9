using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>What turns a file of the package into an object: one importer per extension.</summary>
    static class AssetImporters
    {
        static readonly Dictionary<string, (long MainId, Func<string, Object> Load)> s_Importers = new(StringComparer.OrdinalIgnoreCase);

        /// <summary>Registers an importer, or replaces one.</summary>
        /// <param name="extension">With its dot, such as ".compute".</param>
        /// <param name="mainId">The fileID by which YAML refers to the object in the file, such as 7200000 for a compute shader.</param>
        /// <param name="load">Makes the object from the file's path.</param>
        internal static void Register(string extension, long mainId, Func<string, Object> load) => s_Importers[extension] = (mainId, load);

        internal static bool TryGet(string extension, out long mainId, out Func<string, Object> load)
        {
            var found = s_Importers.TryGetValue(extension, out var importer);
            (mainId, load) = importer;
            return found;
        }
    }
}
