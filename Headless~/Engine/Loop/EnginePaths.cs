using System.IO;

namespace UnityEngine
{
    /// <summary>The player's folders, all below one.</summary>
    sealed class EnginePaths
    {
        /// <param name="root">The folder that holds them.</param>
        /// <param name="streamingAssets">Where StreamingAssets are instead: a folder, or an address such as Android's jar:file:///base.apk!/assets.</param>
        internal EnginePaths(string root, string streamingAssets = null)
        {
            Data = Path.Combine(root, "Data");
            StreamingAssets = streamingAssets ?? Path.Combine(Data, "StreamingAssets");
            PersistentData = Path.Combine(root, "PersistentData");
            TemporaryCache = Path.Combine(root, "TemporaryCache");
        }

        internal string Data { get; }

        internal string StreamingAssets { get; }

        internal string PersistentData { get; }

        internal string TemporaryCache { get; }
    }
}
