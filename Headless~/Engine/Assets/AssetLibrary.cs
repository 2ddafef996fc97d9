using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace UnityEngine
{
    /// <summary>The objects in one file, by fileID.</summary>
    sealed class AssetObjects : Dictionary<long, Object>
    {
        /// <summary>The object that the file as a whole stands for; null if the file has none.</summary>
        internal Object Main { get; set; }
    }

    /// <summary>The objects that were loaded from the project's files.</summary>
    static class AssetLibrary
    {
        static readonly Dictionary<string, AssetObjects> s_Loaded = new();

        /// <summary>Raised when all objects have ended and all files are forgotten.</summary>
        internal static event Action Unloaded;

        /// <inheritdoc cref="AssetFiles.AddRoot"/>
        internal static void AddRoot(string root) => AssetFiles.AddRoot(root);

        /// <summary>The object that YAML means by fileID and GUID.</summary>
        /// <exception cref="AssetFormatException">There is none.</exception>
        internal static Object Load(string guid, long fileId, string referrer)
        {
            var path = PathOf(guid) ?? throw new AssetFormatException(referrer, $"refers to GUID {guid}, which no .meta of the package has");
            var objects = LoadFile(path);
            if (!objects.TryGetValue(fileId, out var found))
                throw new AssetFormatException(referrer, $"refers to fileID {fileId} of {path}, which has only {string.Join(", ", objects.Keys)}");
            return found;
        }

        /// <inheritdoc cref="AssetFiles.PathOf"/>
        internal static string PathOf(string guid) => AssetFiles.PathOf(guid);

        /// <summary>True for a file in Unity's own text form, to which references have type 2; those to imported files have type 3.</summary>
        internal static bool IsNative(string path) => Path.GetExtension(path) is ".asset" or ".mat";

        /// <summary>The objects of a file by fileID. A file that nothing imports has none.</summary>
        internal static AssetObjects LoadFile(string path)
        {
            path = AssetFiles.Normal(path);
            if (s_Loaded.TryGetValue(path, out var known) && known.Values.All(Object.IsAlive))
                return known;
            var objects = new AssetObjects();
            s_Loaded[path] = objects;
            try
            {
                if (YamlAsset.IsOne(path))
                    YamlAsset.Load(path, objects);
                else
                    AssetImporters.For(path)?.Invoke(path, objects);
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

        /// <summary>The file that an asset was loaded from; null for an object that is no asset.</summary>
        internal static string FileOf(Object asset) =>
            s_Loaded.Where(l => l.Value.Values.Any(o => ReferenceEquals(o, asset))).Select(l => l.Key).FirstOrDefault();

        /// <summary>True for a file whose objects are in memory.</summary>
        internal static bool IsLoaded(string path) => s_Loaded.ContainsKey(AssetFiles.Normal(path));

        /// <summary>Lets go of a file's objects; the next one who asks loads it again.</summary>
        internal static void UnloadFile(string path)
        {
            if (s_Loaded.Remove(AssetFiles.Normal(path), out var objects))
                Destroy(objects.Values);
        }

        /// <summary>All files with that extension.</summary>
        internal static List<string> Files(string extension) => AssetFiles.All.Where(f => Path.GetExtension(f) == extension).ToList();

        /// <summary>Files at that path, without extension, relative to any Resources folder.</summary>
        internal static IEnumerable<string> Resources(string path)
        {
            var ending = "/Resources/" + path.Trim('/');
            return AssetFiles.All.Where(f => Path.ChangeExtension(f, null).EndsWith(ending, StringComparison.Ordinal)).ToList();
        }

        internal static void Enter(Dictionary<long, Object> objects, long fileId, Object asset, string name)
        {
            asset.NativeName = name;
            asset.IsAsset = true;
            objects.Add(fileId, asset);
            if (objects is AssetObjects { Main: null } file)
                file.Main = asset;
        }

        /// <summary>Ends all loaded objects and forgets the files.</summary>
        internal static void Unload()
        {
            Destroy(s_Loaded.Values.SelectMany(o => o.Values));
            s_Loaded.Clear();
            DataAsset.UnloadAll();
            ScriptTypes.Forget();
            AssetFiles.Clear();
            Unloaded?.Invoke();
        }

        static void Destroy(IEnumerable<Object> assets)
        {
            // GameObjects first: they take their components along.
            foreach (var asset in assets.OrderBy(o => o is GameObject ? 0 : 1).ToList())
                if (Object.IsAlive(asset))
                    Destruction.Now(asset);
        }
    }
}
