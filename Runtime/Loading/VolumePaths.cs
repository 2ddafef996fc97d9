using System;
using System.IO;
using System.Linq;

namespace AnatomyCarve
{
    /// <summary>Where a volume's file lies: an absolute path or an address is taken as it is, a relative path counts from StreamingAssets.</summary>
    static class VolumePaths
    {
        /// <summary>Marks an address that is no path, such as Android's jar:file:///data/app/base.apk!/assets.</summary>
        const string Address = "://";

        /// <param name="path">The path or address; null or empty = no file.</param>
        /// <param name="streamingAssets">Unity's folder of this name; on Android an address.</param>
        /// <returns>An absolute path, or an address; null for no file.</returns>
        public static string Resolve(string path, string streamingAssets)
        {
            if (string.IsNullOrEmpty(path))
                return null;
            if (IsAddress(path) || Path.IsPathRooted(path))
                return path;
            return IsAddress(streamingAssets)
                ? streamingAssets.TrimEnd('/') + "/" + string.Join("/", path.Replace('\\', '/').Split('/').Select(Uri.EscapeDataString))
                : Path.Combine(streamingAssets, path);
        }

        /// <summary>Whether it is an address, on which no stream can be opened. Null is none.</summary>
        public static bool IsAddress(string path) => path != null && path.Contains(Address, StringComparison.Ordinal);

        /// <summary>The name of the file at an address, without folders, query and fragment.</summary>
        public static string FileNameOf(string address)
        {
            int end = address.IndexOfAny(new[] { '?', '#' });
            string name = Path.GetFileName(Uri.UnescapeDataString(end < 0 ? address : address.Substring(0, end)).TrimEnd('/'));
            return name.Length > 0 ? name : "volume";
        }
    }
}
