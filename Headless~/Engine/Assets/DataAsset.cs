using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>An asset of which the host knows only that it exists: one of another package, or a built-in resource that it does not have.</summary>
    sealed class DataAsset : Object
    {
        static readonly Dictionary<(string, long), DataAsset> s_Known = new();

        DataAsset()
        {
        }

        /// <summary>The one that stands for this asset.</summary>
        internal static DataAsset Of(string name, long fileId)
        {
            if (!s_Known.TryGetValue((name, fileId), out var asset) || !IsAlive(asset))
                s_Known[(name, fileId)] = asset = new DataAsset { NativeName = name, IsAsset = true };
            return asset;
        }

        internal static void UnloadAll()
        {
            foreach (var asset in s_Known.Values.ToList())
                asset.Kill();
            s_Known.Clear();
        }
    }
}
