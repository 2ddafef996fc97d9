using System;

namespace AnatomyCarve.Editor
{
    /// <summary>Paths as the loader's fields hold them: relative to StreamingAssets where the file lies there, with '/' on every platform.</summary>
    static class FilePaths
    {
        /// <summary>A chosen file's path as it is saved.</summary>
        /// <param name="path">An absolute path.</param>
        /// <param name="folder">An absolute path of a folder.</param>
        /// <returns>The path below the folder if the file lies there; otherwise the absolute path.</returns>
        public static string RelativeTo(string path, string folder)
        {
            string file = Slashed(path), prefix = Slashed(folder).TrimEnd('/') + "/";

            // Drive letters come in both cases, and so do paths on file systems that do not tell cases apart.
            bool caseless = prefix.Length > 1 && prefix[1] == ':';
            return file.StartsWith(prefix, caseless ? StringComparison.OrdinalIgnoreCase : StringComparison.Ordinal) ? file.Substring(prefix.Length) : file;
        }

        static string Slashed(string path) => path.Replace('\\', '/');
    }
}
