using System.Collections.Generic;
using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.Layout
{
    /// <summary>The assembly definitions: names, references, flags, and that every script belongs to one.</summary>
    public class AssemblyDefinitionTests
    {
        static readonly PackageTree Tree = PackageTree.OfRepository();

        static readonly Dictionary<string, (string path, JObject json)> Definitions = Tree.AllFiles.Where(f => f.EndsWith(".asmdef"))
            .ToDictionary(f => (string)JObject.Parse(Tree.Read(f))["name"], f => (f, JObject.Parse(Tree.Read(f))));

        static readonly string[] OfUnity =
        [
            "UnityEngine.TestRunner", "UnityEditor.TestRunner", "UnityEngine.UI", "Unity.InputSystem",
            "Unity.XR.CoreUtils", "Unity.XR.Interaction.Toolkit", "Unity.XR.OpenXR",
        ];

        [TestCaseSource(nameof(Names))]
        public void Definition_Name_IsItsFileName(string name) => Assert.That(Path.GetFileNameWithoutExtension(Definitions[name].path), Is.EqualTo(name));

        [TestCaseSource(nameof(Names))]
        public void Definition_References_Resolve(string name) => Assert.That(List(name, "references").Except(OfUnity).Except(Definitions.Keys), Is.Empty);

        [TestCaseSource(nameof(Names))]
        public void Definition_Flags_AreSetOnPurpose(string name)
        {
            foreach (string flag in new[] { "allowUnsafeCode", "overrideReferences", "autoReferenced", "noEngineReferences" })
                Assert.That(Definitions[name].json[flag]?.Type, Is.EqualTo(JTokenType.Boolean), flag);
            Assert.That((bool)Definitions[name].json["overrideReferences"], Is.True, "an assembly names the plug-ins that it uses");
            Assert.That((bool)Definitions[name].json["allowUnsafeCode"], Is.False);
        }

        [TestCaseSource(nameof(Names))]
        public void Definition_OfTests_IsCompiledForTestsOnly(string name)
        {
            bool tests = Definitions[name].path.StartsWith("Tests/");
            Assert.That(List(name, "defineConstraints").Contains("UNITY_INCLUDE_TESTS"), Is.EqualTo(tests));
            Assert.That(List(name, "precompiledReferences").Contains("nunit.framework.dll"), Is.EqualTo(tests));
            Assert.That((bool)Definitions[name].json["autoReferenced"], Is.EqualTo(!tests));
        }

        [Test]
        public void Core_Engine_IsNotReferenced()
        {
            Assert.That((bool)Definitions["AnatomyCarve.Core"].json["noEngineReferences"], Is.True);
            Assert.That(List("AnatomyCarve.Core", "references"), Is.Empty);
            Assert.That(List("AnatomyCarve.Core", "precompiledReferences"), Is.EqualTo(new[] { "Newtonsoft.Json.dll" }));
        }

        [Test]
        public void Runtime_References_PointInwardsOnly() => Assert.That(List("AnatomyCarve", "references"), Is.EqualTo(new[] { "AnatomyCarve.Core" }));

        [Test]
        public void Desktop_References_PointInwardsAndToInputAndInterface() =>
            Assert.That(List("AnatomyCarve.Desktop", "references"), Is.EqualTo(new[] { "AnatomyCarve.Core", "AnatomyCarve", "Unity.InputSystem", "UnityEngine.UI" }));

        [Test]
        public void Editor_Platforms_AreTheEditor() => Assert.That(List("AnatomyCarve.Editor", "includePlatforms"), Is.EqualTo(new[] { "Editor" }));

        [Test]
        public void Scripts_AllOfThem_BelongToADefinition()
        {
            string[] folders = Definitions.Values.Select(d => Path.GetDirectoryName(d.path).Replace('\\', '/') + "/").ToArray();
            Assert.That(Tree.Files.Where(f => f.EndsWith(".cs") && !folders.Any(f.StartsWith)), Is.Empty);
        }

        [Test]
        public void Scripts_OfComponents_AreNamedAfterTheirClass() => Assert.That(
            Tree.Files.Where(f => f.StartsWith("Runtime/") && f.EndsWith(".cs"))
                .Where(f => Tree.Read(f) is var text && (text.Contains(" : MonoBehaviour") || text.Contains(" : ScriptableObject")))
                .Where(f => !Tree.Read(f).Contains($"class {Path.GetFileNameWithoutExtension(f)} : ")), Is.Empty);

        static IEnumerable<string> Names() => Definitions.Keys;

        static string[] List(string name, string field) => Definitions[name].json[field].Select(t => (string)t).ToArray();
    }
}
