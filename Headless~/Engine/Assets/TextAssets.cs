using System.IO;

namespace UnityEngine
{
    /// <summary>The files that Unity imports as TextAssets.</summary>
    static class TextAssets
    {
        const long FileId = 4900000;

        internal static void Register()
        {
            foreach (var extension in new[] { ".txt", ".html", ".htm", ".xml", ".json", ".csv", ".yaml", ".fnt", ".bytes", ".md" })
                AssetImporters.Register(extension, FileId, path => new TextAsset(File.ReadAllBytes(path)));
        }
    }
}
