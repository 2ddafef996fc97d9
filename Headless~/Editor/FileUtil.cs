using UnityEngine;

namespace UnityEditor
{
    /// <summary>Where the project's files lie.</summary>
    public class FileUtil
    {
        public FileUtil()
        {
        }

        /// <summary>From a path in the project to one that System.IO understands; another path is returned as it is.</summary>
        public static string GetPhysicalPath(string path) => AssetFiles.FullPath(path) ?? path;

        /// <summary>From a path on the disk to one in the project; another path is returned as it is.</summary>
        public static string GetLogicalPath(string path) => AssetFiles.ProjectPath(path);
    }
}
