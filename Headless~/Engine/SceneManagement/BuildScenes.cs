using System;
using System.Collections.Generic;
using System.IO;

namespace UnityEngine.SceneManagement
{
    /// <summary>The list of scenes that a player contains, which the host is given.</summary>
    static class BuildScenes
    {
        static readonly List<string> s_Paths = new();

        internal static int Count => s_Paths.Count;

        /// <param name="paths">Paths in the project, such as Assets/Demo/Demo.unity.</param>
        internal static void Set(IEnumerable<string> paths)
        {
            s_Paths.Clear();
            s_Paths.AddRange(paths);
        }

        internal static string At(int index) => index >= 0 && index < s_Paths.Count ? s_Paths[index] : null;

        internal static int IndexOf(string path) => s_Paths.IndexOf(path);

        /// <summary>The scene of that name or path, with or without extension; null if the list has none.</summary>
        internal static string Find(string nameOrPath)
        {
            var wanted = nameOrPath.EndsWith(".unity", StringComparison.OrdinalIgnoreCase) ? nameOrPath.Substring(0, nameOrPath.Length - 6) : nameOrPath;
            return s_Paths.Find(p => string.Equals(Path.ChangeExtension(p, null), wanted, StringComparison.OrdinalIgnoreCase))
                ?? s_Paths.Find(p => string.Equals(Path.GetFileNameWithoutExtension(p), wanted, StringComparison.OrdinalIgnoreCase));
        }
    }
}
