using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>A package's folder as Unity sees it: what is imported, and what is hidden. Paths are relative, with '/'.</summary>
    sealed partial class PackageTree
    {
        public PackageTree(string root)
        {
            Root = root;
            Files = List(root, "", Hidden).ToArray();
            SampleFiles = Directory.Exists(Path.Combine(root, "Samples~"))
                ? List(Path.Combine(root, "Samples~"), "Samples~/", Hidden).ToArray()
                : [];
        }

        public string Root { get; }

        /// <summary>Files that Unity imports with the package, .meta files included.</summary>
        public IReadOnlyList<string> Files { get; }

        /// <summary>Files that Unity imports with a sample, .meta files included.</summary>
        public IReadOnlyList<string> SampleFiles { get; }

        public IEnumerable<string> AllFiles => Files.Concat(SampleFiles);

        /// <summary>Assets and folders, which need a .meta each.</summary>
        public IEnumerable<string> AssetsAndFolders => AllFiles.Where(f => !f.EndsWith(".meta", StringComparison.Ordinal))
            .SelectMany(FileAndFolders).Where(p => p != "Samples~").Distinct();

        public IEnumerable<string> Metas => AllFiles.Where(f => f.EndsWith(".meta", StringComparison.Ordinal));

        public string Full(string path) => Path.Combine(Root, path);

        public string Read(string path) => File.ReadAllText(Full(path));

        /// <summary>The GUID in a .meta file; null where there is none.</summary>
        public string GuidOf(string meta) => GuidLine().Match(Read(meta)) is { Success: true } match ? match.Groups[1].Value : null;

        /// <summary>The repository that this test was built from.</summary>
        public static PackageTree OfRepository()
        {
            for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder != null; folder = folder.Parent)
                if (File.Exists(Path.Combine(folder.FullName, "package.json")))
                    return new PackageTree(folder.FullName);
            throw new InvalidOperationException("The tests do not lie below a package.json.");
        }

        /// <summary>A copy as a package manager installs it and Unity reads it: without hidden files and folders.</summary>
        public PackageTree InstallInto(string folder)
        {
            foreach (string file in Files)
            {
                string target = Path.Combine(folder, file);
                Directory.CreateDirectory(Path.GetDirectoryName(target));
                File.Copy(Full(file), target);
            }
            return new PackageTree(folder);
        }

        /// <summary>Unity's rule for what it does not import.</summary>
        public static bool Hidden(string name) => name.StartsWith('.') || name.EndsWith('~')
            || name.Equals("cvs", StringComparison.OrdinalIgnoreCase) || name.EndsWith(".tmp", StringComparison.OrdinalIgnoreCase);

        public static IEnumerable<string> List(string folder, string prefix, Func<string, bool> skip)
        {
            foreach (string path in Directory.GetFileSystemEntries(folder).Order(StringComparer.Ordinal))
            {
                string name = Path.GetFileName(path);
                if (skip(name))
                    continue;
                if (Directory.Exists(path))
                {
                    foreach (string inner in List(path, prefix + name + "/", skip))
                        yield return inner;
                }
                else
                {
                    yield return prefix + name;
                }
            }
        }

        static IEnumerable<string> FileAndFolders(string file)
        {
            for (string path = file; !string.IsNullOrEmpty(path); path = Path.GetDirectoryName(path).Replace('\\', '/'))
                yield return path;
        }

        [GeneratedRegex(@"^guid: ([0-9a-f]{32})\r?$", RegexOptions.Multiline)]
        private static partial Regex GuidLine();
    }
}
