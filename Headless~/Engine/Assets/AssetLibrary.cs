using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace UnityEngine
{
    /// <summary>The files of the package by path and by the GUID in their .meta, and the objects that were loaded from them.</summary>
    static class AssetLibrary
    {
        static readonly Dictionary<string, string> s_PathOfGuid = new();
        static readonly List<string> s_Files = new();
        static readonly Dictionary<string, Dictionary<long, Object>> s_Loaded = new();

        /// <summary>Takes in all files below a folder, as Unity would: none in folders that end in ~ or begin with a dot.</summary>
        /// <exception cref="AssetFormatException">Two files have the same GUID, or a .meta has none.</exception>
        internal static void AddRoot(string root)
        {
            var pending = new Stack<string>();
            pending.Push(Path.GetFullPath(root));
            while (pending.Count > 0)
            {
                var folder = pending.Pop();
                foreach (var file in Directory.GetFiles(folder).OrderBy(f => f, StringComparer.Ordinal))
                    AddFile(file);
                foreach (var inner in Directory.GetDirectories(folder))
                    if (!IsHidden(Path.GetFileName(inner)))
                        pending.Push(inner);
            }
        }

        /// <summary>The object that YAML means by fileID and GUID.</summary>
        /// <exception cref="AssetFormatException">There is none.</exception>
        internal static Object Load(string guid, long fileId, string referrer)
        {
            if (!s_PathOfGuid.TryGetValue(guid, out var path))
                throw new AssetFormatException(referrer, $"refers to GUID {guid}, which no .meta of the package has");
            var objects = LoadFile(path);
            if (!objects.TryGetValue(fileId, out var found))
                throw new AssetFormatException(referrer, $"refers to fileID {fileId} of {path}, which has only {string.Join(", ", objects.Keys)}");
            return found;
        }

        /// <summary>The path of the file with that GUID; null if there is none.</summary>
        internal static string PathOf(string guid) => s_PathOfGuid.TryGetValue(guid, out var path) ? path : null;

        /// <summary>The objects of a file by fileID. A file that nothing imports has none.</summary>
        internal static Dictionary<long, Object> LoadFile(string path)
        {
            if (s_Loaded.TryGetValue(path, out var known) && known.Values.All(Object.IsAlive))
                return known;
            var objects = new Dictionary<long, Object>();
            s_Loaded[path] = objects;
            try
            {
                if (Path.GetExtension(path) == ".asset")
                    YamlAsset.Load(path, objects);
                else if (AssetImporters.TryGet(Path.GetExtension(path), out var mainId, out var load))
                    Enter(objects, mainId, load(path), Path.GetFileNameWithoutExtension(path));
            }
            catch
            {
                s_Loaded.Remove(path);
                foreach (var half in objects.Values)
                    half.Kill();
                throw;
            }

            return objects;
        }

        /// <summary>Files at that path, without extension, relative to any Resources folder.</summary>
        internal static IEnumerable<string> Resources(string path)
        {
            var ending = "/Resources/" + path.Trim('/');
            return s_Files.Where(f => WithoutExtension(f).EndsWith(ending, StringComparison.Ordinal));
        }

        internal static void Enter(Dictionary<long, Object> objects, long fileId, Object asset, string name)
        {
            asset.NativeName = name;
            asset.IsAsset = true;
            objects.Add(fileId, asset);
        }

        /// <summary>Ends all loaded objects and forgets the files.</summary>
        internal static void Unload()
        {
            foreach (var asset in s_Loaded.Values.SelectMany(o => o.Values).ToList())
                if (Object.IsAlive(asset))
                    Destruction.Now(asset);
            s_Loaded.Clear();
            s_Files.Clear();
            s_PathOfGuid.Clear();
        }

        static void AddFile(string file)
        {
            if (Path.GetFileName(file).StartsWith(".", StringComparison.Ordinal))
                return;
            if (!file.EndsWith(".meta", StringComparison.Ordinal))
            {
                s_Files.Add(file.Replace('\\', '/'));
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
        }

        static bool IsHidden(string folder) => folder.EndsWith("~", StringComparison.Ordinal) || folder.StartsWith(".", StringComparison.Ordinal);

        static string WithoutExtension(string file) => file.Substring(0, file.Length - Path.GetExtension(file).Length);
    }
}
