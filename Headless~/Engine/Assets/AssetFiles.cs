using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace UnityEngine
{
    /// <summary>
    /// The files that a Unity project would have: by path, by GUID, and by their path in the project, which begins with "Packages/NAME" for a package and
    /// with "Assets" for what lies beside it.
    /// </summary>
    static class AssetFiles
    {
        static readonly List<(string Root, string Mount)> s_Roots = new();
        static readonly Dictionary<string, string> s_PathOfGuid = new();
        static readonly Dictionary<string, string> s_GuidOfPath = new();
        static readonly List<string> s_Files = new();

        /// <summary>All files, without those that Unity hides and without .meta files.</summary>
        internal static IReadOnlyList<string> All => s_Files;

        /// <summary>Takes in all files below a folder, as Unity would: none in folders that end in ~ or begin with a dot.</summary>
        /// <exception cref="AssetFormatException">Two files have the same GUID, or a .meta has none.</exception>
        internal static void AddRoot(string root)
        {
            root = Normal(Path.GetFullPath(root)).TrimEnd('/');
            if (s_Roots.Any(r => r.Root == root))
                return;
            var manifest = PackageManifest.Read(root);
            s_Roots.Add((root, manifest == null ? "Assets/" + Path.GetFileName(root) : "Packages/" + manifest.Name));
            Scan(root);
        }

        /// <summary>Looks through all roots anew.</summary>
        internal static void Rescan()
        {
            s_Files.Clear();
            s_PathOfGuid.Clear();
            s_GuidOfPath.Clear();
            foreach (var (root, _) in s_Roots)
                Scan(root);
        }

        /// <summary>True for a root's path in the project.</summary>
        internal static bool IsRoot(string projectPath) => s_Roots.Any(r => r.Mount == projectPath);

        static void Scan(string root)
        {
            var pending = new Stack<string>();
            pending.Push(root);
            while (pending.Count > 0)
            {
                var folder = pending.Pop();
                foreach (var file in Directory.GetFiles(folder).OrderBy(f => f, StringComparer.Ordinal))
                    AddFile(Normal(file));
                foreach (var inner in Directory.GetDirectories(folder))
                    if (!IsHidden(Path.GetFileName(inner)))
                        pending.Push(inner);
            }
        }

        /// <summary>The path of the file with that GUID; null if there is none.</summary>
        internal static string PathOf(string guid) => s_PathOfGuid.TryGetValue(guid, out var path) ? path : null;

        /// <summary>The GUID of a file; null if it has no .meta.</summary>
        internal static string GuidOf(string path) => s_GuidOfPath.TryGetValue(Normal(path), out var guid) ? guid : null;

        /// <summary>Where a file of the project lies; null if no root has such a path. An absolute path is taken as it is.</summary>
        internal static string FullPath(string projectPath)
        {
            if (Path.IsPathRooted(projectPath))
                return Normal(projectPath);
            foreach (var (root, mount) in s_Roots)
                if (projectPath == mount || projectPath.StartsWith(mount + "/", StringComparison.Ordinal))
                    return root + projectPath.Substring(mount.Length);
            return null;
        }

        /// <summary>A file's path in the project; the path itself for one outside.</summary>
        internal static string ProjectPath(string fullPath)
        {
            fullPath = Normal(fullPath);
            // The innermost root: a sample lies below its package.
            foreach (var (root, mount) in s_Roots.OrderByDescending(r => r.Root.Length))
                if (fullPath == root || fullPath.StartsWith(root + "/", StringComparison.Ordinal))
                    return mount + fullPath.Substring(root.Length);
            return fullPath;
        }

        /// <summary>Takes in a file that has come, or drops one that has gone.</summary>
        internal static void Refresh(string path)
        {
            path = Normal(path);
            Forget(path);
            if (!File.Exists(path))
                return;
            AddFile(path);
            if (File.Exists(path + ".meta"))
                AddFile(path + ".meta");
        }

        internal static void Clear()
        {
            s_Roots.Clear();
            s_Files.Clear();
            s_PathOfGuid.Clear();
            s_GuidOfPath.Clear();
        }

        internal static string Normal(string path) => path.Replace('\\', '/');

        static void Forget(string path)
        {
            s_Files.Remove(path);
            if (s_GuidOfPath.Remove(path, out var guid))
                s_PathOfGuid.Remove(guid);
        }

        static void AddFile(string file)
        {
            if (Path.GetFileName(file).StartsWith(".", StringComparison.Ordinal))
                return;
            if (!file.EndsWith(".meta", StringComparison.Ordinal))
            {
                s_Files.Add(file);
                return;
            }

            var match = Regex.Match(File.ReadAllText(file), @"^guid: ([0-9a-f]{32})\s*$", RegexOptions.Multiline);
            if (!match.Success)
                throw new AssetFormatException(file, "has no line 'guid: <32 hexadecimal digits>'");
            var path = file.Substring(0, file.Length - ".meta".Length);
            var guid = match.Groups[1].Value;
            if (s_PathOfGuid.TryGetValue(guid, out var other) && other != path)
                throw new AssetFormatException(file, $"has the same GUID as {other}");
            s_PathOfGuid[guid] = path;
            s_GuidOfPath[path] = guid;
        }

        static bool IsHidden(string folder) => folder.EndsWith("~", StringComparison.Ordinal) || folder.StartsWith(".", StringComparison.Ordinal);
    }
}
