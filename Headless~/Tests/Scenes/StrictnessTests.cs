using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>What Unity would load with something missing, or with something ignored, is an error here that names file and line.</summary>
    public sealed class StrictnessTests : ProjectTests
    {
        const string Guid = "0123456789abcdef0123456789abcdef";
        const string Owner = "m_GameObject: {fileID: 10}\n";

        string Script => Project.Script<SceneFields>();

        void Refuses(Yaml scene, params string[] words)
        {
            var path = Project.Write("Test.unity", scene.ToString());
            var message = Assert.Throws<AssetFormatException>(() => Host.LoadScene(path)).Message;
            Assert.That(message, Does.StartWith(path + ": line "));
            foreach (var word in words)
                Assert.That(message, Does.Contain(word));
            Assert.That(Object.FindObjectsByType<GameObject>(FindObjectsInactive.Include, FindObjectsSortMode.None), Is.Empty);
        }

        Yaml WithScript(string fields) => new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Script, fields).Roots(11);

        [Test]
        public void UnknownField_OfAScript()
        {
            var scene = WithScript("number: 3\nnunber: 4");
            var line = 1 + System.Array.FindIndex(scene.ToString().Split('\n'), l => l.Contains("nunber"));
            Refuses(scene, $"line {line}:", "SceneFields", "'nunber'");
        }

        [Test]
        public void UnknownField_OfANestedClass() => Refuses(WithScript("nested:\n  kpt: 4"), "Nested", "'kpt'");

        [Test]
        public void UnknownComponent_OfAVector() => Refuses(WithScript("nested:\n  vector: {x: 1, w: 2}"), "'w'");

        [TestCase("number: much", "'much'")]
        [TestCase("number: {x: 1}", "single value")]
        [TestCase("list: 3", "never packed")]
        [TestCase("text:\n- a", "single value")]
        public void Value_OfAnotherKind(string field, string expected) => Refuses(WithScript(field), expected);

        [TestCase("place: {fileID: 77}", "77")]
        [TestCase("place: {fileID: 10}", "GameObject where a Transform belongs")]
        [TestCase("anything: {fileID: 4, guid: " + Guid + ", type: 2}", Guid)]
        [TestCase("anything: {fileID: 10203, guid: 0000000000000000e000000000000000, type: 0}", "10203")]
        [TestCase("anything: {fileID: 10202, guid: 0000000000000000e000000000000000, type: 3}", "type 0, not 3")]
        [TestCase("anything: {guid: " + Guid + ", type: 2}", "'fileID' is missing")]
        public void Reference_ThatLeadsNowhere(string field, string expected) => Refuses(WithScript(field), expected);

        [Test]
        public void Reference_ToAnAsset_OfTheWrongType()
        {
            Project.Write("Data.asset", new Yaml().Add(114, "MonoBehaviour", 11400000,
                $"m_GameObject: {{fileID: 0}}\nm_Script: {Project.Script<Objects.SampleAsset>()}\nm_Name: Data").ToString());
            Refuses(WithScript($"asset: {{fileID: 11400000, guid: {Project.Guid("Data.asset")}, type: 3}}"), "type 2, not 3");
        }

        [Test]
        public void Reference_ToAnAsset_WithTheWrongFileId()
        {
            Project.Write("Data.asset", new Yaml().Add(114, "MonoBehaviour", 11400000,
                $"m_GameObject: {{fileID: 0}}\nm_Script: {Project.Script<Objects.SampleAsset>()}\nm_Name: Data").ToString());
            Refuses(WithScript($"asset: {{fileID: 11400002, guid: {Project.Guid("Data.asset")}, type: 2}}"), "11400002", "only 11400000");
        }

        [Test]
        public void Reference_InAComponentThatIsDataOnly() =>
            Refuses(new Yaml().GameObject(10, "a", components: [12])
                .Add(54, "Rigidbody", 12, Owner + "m_Mass: 1\nm_CenterOfMass: {fileID: 5}").Roots(11), "fileID 5");

        [Test]
        public void UnknownField_OfANativeClass() =>
            Refuses(new Yaml().GameObject(10, "a", components: [12]).Add(20, "Camera", 12, Owner + "m_FieldOfView: 60").Roots(11), "Camera", "'m_FieldOfView'");

        [Test]
        public void UnknownClass() => Refuses(new Yaml().Add(999, "Wonder", 10, "m_Name: a").Roots(), "999", "Wonder");

        [Test]
        public void ClassName_ThatIsAnothers() => Refuses(new Yaml().Add(20, "Kamera", 10, Owner + "m_Enabled: 1").Roots(), "Camera, not Kamera");

        [Test]
        public void Script_ThatNobodyHas() => Refuses(
            new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, $"{{fileID: 11500000, guid: {Guid}, type: 3}}").Roots(11), Guid);

        [Test]
        public void Script_ThatIsNoComponent() =>
            Refuses(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<Objects.SampleAsset>()).Roots(11), "SampleAsset");

        [Test]
        public void Script_UnderAnotherClassName() => Refuses(new Yaml().GameObject(10, "a", components: [12])
            .Add(114, "MonoBehaviour", 12, $"{Owner}m_Script: {Script}\nm_EditorClassIdentifier: Tests::Some.Other").Roots(11), "Some.Other");

        [Test]
        public void Script_OfAPackageThatIsNoDependency() => Refuses(new Yaml().GameObject(10, "a", components: [12])
            .Script(12, 10, "{fileID: 11500000, guid: a79441f348de89743a2939f4d699eac1, type: 3}").Roots(11),
            "UniversalAdditionalCameraData", "com.unity.render-pipelines.universal", "does not declare");

        [Test]
        public void RequiredComponent_ThatIsMissing() =>
            Refuses(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<Needy>()).Roots(11), "Needy", "SceneFields");

        [Test]
        public void Component_ThatNobodyLists() =>
            Refuses(new Yaml().GameObject(10, "a").Add(20, "Camera", 12, Owner + "m_Enabled: 1").Roots(11), "no GameObject lists", "12");

        [Test]
        public void Component_OfAnotherObject() => Refuses(
            new Yaml().GameObject(10, "a").GameObject(20, "b", components: [12]).Add(20, "Camera", 12, Owner + "m_Enabled: 1").Roots(11, 21), "GameObject 10");

        [Test]
        public void Component_ThatDoesNotExist() => Refuses(new Yaml().GameObject(10, "a", components: [12]).Roots(11), "lists component 12");

        [Test]
        public void Component_ListedTwice() =>
            Refuses(new Yaml().GameObject(10, "a", components: [12, 12]).Add(20, "Camera", 12, Owner + "m_Enabled: 1").Roots(11), "twice");

        [Test]
        public void Transform_ThatIsNotFirst() => Refuses(new Yaml()
            .Add(1, "GameObject", 10, "m_Component:\n- component: {fileID: 12}\n- component: {fileID: 11}\nm_Name: a")
            .Transform(11, 10).Add(20, "Camera", 12, Owner + "m_Enabled: 1").Roots(11), "first component");

        [Test]
        public void Child_ThatNamesAnotherParent() =>
            Refuses(new Yaml().GameObject(10, "a", 0, [21]).GameObject(20, "b").Roots(11, 21), "m_Father is 0");

        [Test]
        public void Parent_ThatDoesNotListItsChild() => Refuses(new Yaml().GameObject(10, "a").GameObject(20, "b", 11).Roots(11), "m_Father 11");

        [Test]
        public void Child_ListedTwice() => Refuses(new Yaml().GameObject(10, "a", 0, [21, 21]).GameObject(20, "b", 11).Roots(11), "child 21 twice");

        [Test]
        public void Root_ThatSceneRootsForgets() => Refuses(new Yaml().GameObject(10, "a").GameObject(20, "b").Roots(11), "SceneRoots", "21");

        [Test]
        public void Root_ThatHasAParent() => Refuses(new Yaml().GameObject(10, "a", 0, [21]).GameObject(20, "b", 11).Roots(11, 21), "21");

        [Test]
        public void Number_UsedTwice() => Refuses(new Yaml().GameObject(10, "a").Transform(11, 10).Roots(11), "number 11");

        [Test]
        public void Tag_ThatNoProjectHas() => Refuses(new Yaml()
            .Add(1, "GameObject", 10, "m_Component:\n- component: {fileID: 11}\nm_Name: a\nm_TagString: Mine")
            .Transform(11, 10).Roots(11), "Mine");

        [TestCaseSource(nameof(Broken))]
        public void File_ThatIsNone((string text, string expected) file)
        {
            var path = Project.Write("Test.unity", file.text);
            Assert.That(() => Host.LoadScene(path), Throws.TypeOf<AssetFormatException>().With.Message.Contains(file.expected));
        }

        static IEnumerable<(string, string)> Broken()
        {
            const string Head = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
            yield return ("", "line 1");
            yield return ("--- !u!1 &1\nGameObject:\n", "%YAML 1.1");
            yield return (Head + "--- !u!1 &0\nGameObject:\n  m_Name: a\n", "line 3");
            yield return (Head + "--- !u!one &1\nGameObject:\n  m_Name: a\n", "line 3");
            yield return (Head + "--- !u!1 &1\nGameObject:\n  m_Name: 'a\n", "line");
            yield return (Head + "--- !u!1 &1\n- a\n", "class name");
            yield return (Head + "--- !u!1 &1\n", "class name");
        }
    }
}
