using System;
using System.Collections.Generic;
using System.IO;

namespace AnatomyCarve.Editor
{
    /// <summary>What the names of volumes' files say: format, scan or segmentation, and which belong together. Paths have '/'.</summary>
    static class VolumeFileNames
    {
        /// <summary>The endings of the formats; the longest that fits counts.</summary>
        static readonly string[] Endings = { ".nii.gz", ".nii", ".nrrd" };

        /// <summary>What follows a scan's name in the name of its segmentation; in this order they are preferred.</summary>
        static readonly string[] Marks = { ".seg", "_labels", "-labels", "_label", "-label", "_seg", "-seg" };

        /// <summary>In this order the formats of a segmentation are preferred: 3D Slicer's has names and colours.</summary>
        static readonly string[] LabelEndings = { ".nrrd", ".nii.gz", ".nii" };

        /// <summary>Whether a file is compressed NIfTI, whose last extension says nothing.</summary>
        public static bool IsCompressedNifti(string path) => path.EndsWith(".nii.gz", StringComparison.OrdinalIgnoreCase);

        /// <summary>Whether a file's name is a segmentation's.</summary>
        public static bool IsSegmentation(string path)
        {
            string name = WithoutEnding(path);
            return Array.Exists(Marks, mark => name.EndsWith(mark, StringComparison.OrdinalIgnoreCase));
        }

        /// <summary>The files that may hold a scan's segmentation, the preferred ones first, whether they exist or not.</summary>
        public static IEnumerable<string> SegmentationsOf(string scanPath)
        {
            string name = WithoutEnding(scanPath);
            foreach (string mark in Marks)
            {
                foreach (string ending in LabelEndings)
                    yield return name + mark + ending;
            }
        }

        /// <summary>A file that is named relative to another one's folder.</summary>
        /// <param name="path">A path in the project.</param>
        /// <param name="relative">Such as head_labels.nii or ../labels/head.nrrd.</param>
        public static string Beside(string path, string relative)
        {
            var parts = new List<string>(path.Split('/'));
            parts.RemoveAt(parts.Count - 1);
            foreach (string part in relative.Replace('\\', '/').Split('/'))
            {
                if (part == ".." && parts.Count > 0)
                    parts.RemoveAt(parts.Count - 1);
                else if (part.Length > 0 && part != ".")
                    parts.Add(part);
            }

            return string.Join("/", parts);
        }

        static string WithoutEnding(string path)
        {
            string ending = Array.Find(Endings, e => path.EndsWith(e, StringComparison.OrdinalIgnoreCase)) ?? Path.GetExtension(path);
            return path.Substring(0, path.Length - ending.Length);
        }
    }
}
