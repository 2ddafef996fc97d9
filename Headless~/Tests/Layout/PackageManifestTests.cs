using System.Collections.Generic;
using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>package.json and the template of a project's manifest.</summary>
    public class PackageManifestTests
    {
        static readonly PackageTree Tree = PackageTree.OfRepository();
        static readonly JObject Manifest = JObject.Parse(Tree.Read("package.json"));

        [TestCase("name", "com.anatomycarve.vr")]
        [TestCase("displayName", "AnatomyCarve")]
        [TestCase("unity", "6000.0")]
        [TestCase("license", "MIT")]
        public void Manifest_Field_IsAsPromised(string field, string expected) => Assert.That((string)Manifest[field], Is.EqualTo(expected));

        [Test]
        public void Manifest_Version_IsSemantic() => Assert.That((string)Manifest["version"], Does.Match(@"^\d+\.\d+\.\d+$"));

        [Test]
        public void Manifest_Version_IsInTheChangelog() =>
            Assert.That(Tree.Read("CHANGELOG.md"), Does.Contain("[" + (string)Manifest["version"] + "]").Or.Contain("[Unreleased]"));

        [TestCase("com.unity.inputsystem", "1.14.0")]
        [TestCase("com.unity.xr.interaction.toolkit", "3.5.1")]
        [TestCase("com.unity.xr.openxr", "1.17.1")]
        [TestCase("com.unity.ugui", "2.0.0")]
        [TestCase("com.unity.nuget.newtonsoft-json", "3.2.1")]
        public void Manifest_Dependency_HasItsVersion(string package, string version) =>
            Assert.That((string)Manifest["dependencies"][package], Is.EqualTo(version));

        [Test]
        public void Manifest_Dependencies_AreExactVersions() =>
            Assert.That(((JObject)Manifest["dependencies"]).Properties().Select(p => (string)p.Value), Has.All.Match(@"^\d+\.\d+\.\d+$"));

        [TestCase("com.unity.modules.imageconversion", "ImageConversion.")]
        [TestCase("com.unity.modules.unitywebrequest", "UnityWebRequest.")]
        public void Manifest_Module_IsDeclaredWhereItIsCalled(string module, string call) => Assert.That(
            ((JObject)Manifest["dependencies"]).ContainsKey(module),
            Is.EqualTo(Tree.Files.Where(f => f.StartsWith("Runtime/") && f.EndsWith(".cs")).Any(f => Tree.Read(f).Contains(call))));

        [TestCaseSource(nameof(Samples))]
        public void Sample_Folder_ExistsAndHasFiles(string path) => Assert.That(Tree.SampleFiles.Where(f => f.StartsWith(path + "/")), Is.Not.Empty);

        [Test]
        public void Samples_Folders_AreAllListed() => Assert.That(
            Directory.GetDirectories(Tree.Full("Samples~")).Select(d => "Samples~/" + Path.GetFileName(d)), Is.EquivalentTo(Samples()));

        [TestCase("README.md")]
        [TestCase("CHANGELOG.md")]
        [TestCase("LICENSE.md")]
        public void FrontDoor_File_Exists(string file) => Assert.That(Tree.Files, Does.Contain(file));

        [Test]
        public void ProjectTemplate_Package_IsReferredToAndTestable()
        {
            JObject template = JObject.Parse(Tree.Read("Packages/manifest.json"));
            Assert.That((string)template["dependencies"]["com.anatomycarve.vr"], Does.StartWith("file:"));
            Assert.That(template["testables"].Select(t => (string)t), Does.Contain("com.anatomycarve.vr"));
        }

        static IEnumerable<string> Samples() => Manifest["samples"].Select(s => (string)s["path"]);
    }
}
