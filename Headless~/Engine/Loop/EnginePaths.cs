using System.IO;

namespace UnityEngine
{
    /// <summary>The player's folders, all below one.</summary>
    sealed class EnginePaths
    {
        internal EnginePaths(string root)
        {
            Data = Path.Combine(root, "Data");
            StreamingAssets = Path.Combine(Data, "StreamingAssets");
            PersistentData = Path.Combine(root, "PersistentData");
            TemporaryCache = Path.Combine(root, "TemporaryCache");
        }

        internal string Data { get; }

        internal string StreamingAssets { get; }

        internal string PersistentData { get; }

        internal string TemporaryCache { get; }
    }
}
