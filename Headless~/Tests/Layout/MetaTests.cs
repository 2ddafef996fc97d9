using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>The .meta files of the repository, and of a copy as Unity installs it.</summary>
    [TestFixture(false)]
    [TestFixture(true)]
    public partial class MetaTests(bool installed)
    {
        PackageTree tree;
        string copy;

        [OneTimeSetUp]
        public void TakeTree()
        {
            tree = PackageTree.OfRepository();
            if (!installed)
                return;
            copy = Directory.CreateTempSubdirectory("anatomycarve-installed-").FullName;
            tree = tree.InstallInto(copy);
        }

        [OneTimeTearDown]
        public void RemoveCopy()
        {
            if (copy != null)
                Directory.Delete(copy, true);
        }

        [Test]
        public void Assets_AllOfThem_HaveMetas() => Assert.That(tree.AssetsAndFolders.Except(tree.Metas.Select(AssetOf)), Is.Empty);

        [Test]
        public void Metas_AllOfThem_HaveAssets() => Assert.That(tree.Metas.Select(AssetOf).Except(tree.AssetsAndFolders), Is.Empty);

        [Test]
        public void Metas_AllOfThem_HaveGuids() => Assert.That(tree.Metas.Where(m => tree.GuidOf(m) == null), Is.Empty);

        [Test]
        public void Guids_AllOfThem_AreUnique() =>
            Assert.That(tree.Metas.GroupBy(tree.GuidOf).Where(g => g.Count() > 1).Select(g => string.Join(" = ", g)), Is.Empty);

        [Test]
        public void Metas_Importers_FitTheirAssets() => Assert.That(tree.Metas.Where(m => !tree.Read(m).Contains(ImporterOf(AssetOf(m)) + ":")), Is.Empty);

        [Test]
        public void SerializedAssets_References_Resolve()
        {
            HashSet<string> known = tree.Metas.Select(tree.GuidOf).ToHashSet();
            IEnumerable<string> broken = tree.AllFiles.Where(f => f.EndsWith(".asset") || f.EndsWith(".unity") || f.EndsWith(".prefab") || f.EndsWith(".mat"))
                .SelectMany(f => Reference().Matches(tree.Read(f)).Select(m => (f, guid: m.Groups[1].Value)))
                .Where(r => !known.Contains(r.guid) && !BuiltinResources.IsBuiltin(r.guid) && InstalledPackages.Find(r.guid) == null)
                .Select(r => $"{r.f}: {r.guid}");
            Assert.That(broken, Is.Empty);
        }

        [Test]
        public void Names_ThatDifferByCaseOnly_DoNotExist() =>
            Assert.That(tree.AssetsAndFolders.GroupBy(p => p, StringComparer.OrdinalIgnoreCase)
                .Where(g => g.Count() > 1).Select(g => string.Join(" = ", g)), Is.Empty);

        [Test]
        public void Names_AllOfThem_WorkOnEveryPlatform() =>
            Assert.That(tree.AllFiles.Where(f => f.Length >= 140 || !PortableName().IsMatch(f)), Is.Empty);

        static string AssetOf(string meta) => meta[..^".meta".Length];

        string ImporterOf(string asset)
        {
            if (Directory.Exists(tree.Full(asset)))
                return "folderAsset: yes\nDefaultImporter";
            if (asset.EndsWith(".nii.gz", StringComparison.OrdinalIgnoreCase))
                return "ScriptedImporter";
            return Path.GetFileName(asset) == "package.json" ? "PackageManifestImporter" : Path.GetExtension(asset) switch
            {
                ".cs" => "MonoImporter",
                ".asmdef" => "AssemblyDefinitionImporter",
                ".json" or ".md" or ".txt" or ".xml" => "TextScriptImporter",
                ".compute" => "ComputeShaderImporter",
                ".shader" => "ShaderImporter",
                ".hlsl" => "ShaderIncludeImporter",
                ".asset" or ".mat" => "NativeFormatImporter",
                ".prefab" => "PrefabImporter",
                ".inputactions" or ".nrrd" or ".nii" => "ScriptedImporter",
                ".png" => "TextureImporter",
                _ => "DefaultImporter",
            };
        }

        [GeneratedRegex("guid: ([0-9a-f]{32})")]
        private static partial Regex Reference();

        [GeneratedRegex(@"^[A-Za-z0-9._~/+ -]+$")]
        private static partial Regex PortableName();
    }
}
