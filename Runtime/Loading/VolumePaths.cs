using System;
using System.IO;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>Where a volume's file lies: an absolute path is taken as it is, a relative one counts from StreamingAssets.</summary>
    static class VolumePaths
    {
        /// <summary>Marks an address that is no path, such as Android's jar:file:///data/app/base.apk!/assets.</summary>
        const string Address = "://";

        /// <param name="path">The path; null or empty = no file.</param>
        /// <param name="streamingAssets">Unity's folder of this name.</param>
        /// <returns>The absolute path; null for no file.</returns>
        /// <exception cref="AnatomyCarveException">The file lies inside a package or on a server, where no stream can be opened.</exception>
        public static string Resolve(string path, string streamingAssets)
        {
            if (string.IsNullOrEmpty(path))
                return null;
            bool complete = Path.IsPathRooted(path) || path.Contains(Address, StringComparison.Ordinal);
            string resolved = complete ? path : Path.Combine(streamingAssets, path);
            if (resolved.Contains(Address, StringComparison.Ordinal))
                throw new AnatomyCarveException(
                    $"{path}: {resolved} is not a file that can be opened: on this platform StreamingAssets lies inside the application's package. "
                    + "Copy the file to Application.persistentDataPath and give its absolute path.");
            return resolved;
        }
    }
}
