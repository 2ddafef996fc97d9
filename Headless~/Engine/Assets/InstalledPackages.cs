using System;
using System.Collections.Generic;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>A script or another asset of one of Unity's packages.</summary>
    sealed class PackagePart
    {
        /// <summary>The fileID of the class in a .cs file.</summary>
        internal const long ScriptFileId = 11500000;

        internal PackagePart(string package, string name, bool isScript, long[] fileIds)
        {
            Package = package;
            Name = name;
            IsScript = isScript;
            FileIds = fileIds;
        }

        /// <summary>Such as com.unity.ugui.</summary>
        internal string Package { get; }

        /// <summary>A script's class with its namespace; an asset's file name.</summary>
        internal string Name { get; }

        internal bool IsScript { get; }

        internal long[] FileIds { get; }

        /// <exception cref="AssetFormatException">The package is no dependency.</exception>
        internal void EnsureInstalled(YamlDocument document, YamlNode node)
        {
            if (!InstalledPackages.IsInstalled(Package))
                throw document.Error(node, $"refers to {Name} of {Package}, which package.json does not declare as a dependency");
        }
    }

    /// <summary>What of other packages the host knows: their scripts' names (Tables/package-scripts.txt), and which of them are installed.</summary>
    static class InstalledPackages
    {
        static readonly Dictionary<string, string[]> s_Needs = new();
        static readonly Dictionary<string, PackagePart> s_Parts = new();
        static readonly HashSet<string> s_Installed = new();

        static InstalledPackages()
        {
            var package = "";
            foreach (var words in TextTable.Lines("package-scripts.txt").Select(l => l.Split(' ')))
            {
                if (words[0] == "package")
                    s_Needs.Add(package = words[1].Split('@')[0], words.Skip(3).ToArray());
                else if (words[1] == "asset")
                    s_Parts.Add(words[0], new PackagePart(package, words[3], false, Array.ConvertAll(words[2].Split(','), Id)));
                else
                    s_Parts.Add(words[0], new PackagePart(package, words[1], true, new[] { PackagePart.ScriptFileId }));
            }
        }

        /// <summary>Sets what is installed: what package.json declares, and what that needs in turn.</summary>
        internal static void Set(IEnumerable<string> declared)
        {
            s_Installed.Clear();
            var pending = new Queue<string>(declared);
            while (pending.Count > 0)
                if (pending.Dequeue() is var name && s_Installed.Add(name) && s_Needs.TryGetValue(name, out var needs))
                    foreach (var need in needs)
                        pending.Enqueue(need);
        }

        internal static bool IsInstalled(string package) => s_Installed.Contains(package);

        /// <summary>The part that has this GUID; null if none is known.</summary>
        internal static PackagePart Find(string guid) => s_Parts.TryGetValue(guid, out var part) ? part : null;

        static long Id(string text) => YamlNodes.TryLong(text, out var id) ? id : throw new FormatException($"package-scripts.txt: '{text}' is no fileID");
    }
}
