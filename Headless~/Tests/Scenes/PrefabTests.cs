using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using AnatomyCarve.Headless.Tests.Objects;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>Prefabs: as assets, instantiated by scripts, and as instances in scenes and in other prefabs.</summary>
    public sealed class PrefabTests : ProjectTests
    {
        const string Path = "Resources/Thing.prefab";

        static string ThingGuid => Project.Guid(Path);

        /// <summary>Root 100 "thing" with scripts 102 (SceneFields) and 103 (Recorder) and a child 200 "inner".</summary>
        void WriteThing() => Project.Write(Path, new Yaml().GameObject(100, "thing", 0, [201], [102, 103])
            .Script(102, 100, Project.Script<SceneFields>(), "number: 5\nplace: {fileID: 201}\nlist:\n- 1\nnested:\n  set: 1")
            .Script(103, 100, Project.Script<Recorder>())
            .GameObject(200, "inner", 101, components: [202]).Script(202, 200, Project.Script<SceneFields>(), "other: {fileID: 102}").ToString());

        void LoadInstance(string[] changes, string more = "m_RemovedComponents: []")
        {
            WriteThing();
            Load(new Yaml().Instance(7, ThingGuid, 0, changes, more).Roots(7));
        }

        static SceneFields Root => Find("thing").GetComponent<SceneFields>();

        [Test]
        public void Asset_OfAPrefab_SleepsOutsideOfScenes()
        {
            WriteThing();
            Assert.That(Host, Is.Not.Null);
            var prefab = Resources.Load<GameObject>("Thing");
            Assert.That((prefab.name, prefab.activeSelf, prefab.activeInHierarchy, prefab.scene.IsValid()), Is.EqualTo(("thing", true, false, false)));
            Assert.That((Recorder.Log.Count, SceneManager.GetActiveScene().rootCount, Find("thing") == null), Is.EqualTo((0, 0, true)));
            Assert.That(Object.FindObjectsByType<SceneFields>(FindObjectsInactive.Include, FindObjectsSortMode.None), Is.Empty);
        }

        [Test]
        public void Instantiate_Prefab_GivesAWakingCopy()
        {
            WriteThing();
            Assert.That(Host, Is.Not.Null);
            var prefab = Resources.Load<GameObject>("Thing");
            var copy = Object.Instantiate(prefab);
            var fields = copy.GetComponent<SceneFields>();
            Assert.That((copy.name, fields.number, fields.place, copy.activeInHierarchy), Is.EqualTo(("thing(Clone)", 5, copy.transform.GetChild(0), true)));
            Assert.That(fields.place.GetComponent<SceneFields>().other, Is.SameAs(fields));
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "thing(Clone).Awake", "thing(Clone).OnEnable" }));
            Assert.That(prefab.GetComponent<SceneFields>().place, Is.Not.SameAs(fields.place));
        }

        [Test]
        public void InstantiatePrefab_OfTheHost_TakesAPath()
        {
            WriteThing();
            Assert.That(Host.InstantiatePrefab(System.IO.Path.Combine(Project.Root, Path)).name, Is.EqualTo("thing"));
        }

        [Test]
        public void Reference_ToAComponentOfAPrefab_LeadsIntoTheAsset()
        {
            WriteThing();
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<SceneFields>(),
                $"other: {{fileID: 102, guid: {ThingGuid}, type: 3}}\nthing: {{fileID: 100, guid: {ThingGuid}, type: 3}}").Roots(11));
            var f = Find("a").GetComponent<SceneFields>();
            Assert.That((f.other.number, f.other.gameObject), Is.EqualTo((5, f.thing)));
        }

        [Test]
        public void Instance_InAScene_IsThePrefabsCopy()
        {
            LoadInstance([]);
            Assert.That((Root.number, Root.place.name, Root.place.parent, Root.place.GetComponent<SceneFields>().other),
                Is.EqualTo((5, "inner", Root.transform, Root)));
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "thing.Awake", "thing.OnEnable" }));
        }

        [Test]
        public void Instance_Changes_AreWrittenIntoTheCopy()
        {
            LoadInstance(["101|m_LocalPosition.x|2", "102|number|6", "102|list.Array.size|3", "102|list.Array.data[1]|8", "102|list.Array.data[2]|9",
                "102|nested.vector.y|7", "200|m_Name|renamed", "102|text|two words", "103|m_Enabled|0"]);
            Assert.That((Root.transform.localPosition.x, Root.number, Root.list, Root.place.name, Root.text),
                Is.EqualTo((2f, 6, new[] { 1f, 8f, 9f }, "renamed", "two words")));
            Assert.That((Root.nested.set, Root.nested.vector), Is.EqualTo((1, new Vector3(1f, 7f, 3f))), "the rest of a structure stays");
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "thing.Awake" }));
        }

        [Test]
        public void Instance_ReferencesBothWays_AreFollowed()
        {
            WriteThing();
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<SceneFields>(), "other: {fileID: 8}\nplace: {fileID: 9}")
                .Instance(7, ThingGuid, 0, ["102|place||{fileID: 11}", "202|other||{fileID: 0}", "102|thing||{fileID: 10}"])
                .StandIn(114, "MonoBehaviour", 8, 102, ThingGuid, 7).StandIn(4, "Transform", 9, 201, ThingGuid, 7).Roots(11, 7));
            var a = Find("a").GetComponent<SceneFields>();
            Assert.That((a.other, a.place), Is.EqualTo((Root, Find("inner").transform)));
            Assert.That((Root.place, Root.thing, a.place.GetComponent<SceneFields>().other), Is.EqualTo((a.transform, a.gameObject, (SceneFields)null)));
        }

        [Test]
        public void Instance_BelowASceneObject_HangsThere()
        {
            WriteThing();
            Load(new Yaml().GameObject(10, "a", 0, [9]).Instance(7, ThingGuid, 11).StandIn(4, "Transform", 9, 101, ThingGuid, 7).Roots(11));
            Assert.That((Root.transform.parent.name, SceneManager.GetActiveScene().rootCount), Is.EqualTo(("a", 1)));
        }

        [Test]
        public void Instance_Additions_HangInIt()
        {
            WriteThing();
            Load(new Yaml().Instance(7, ThingGuid, 0, [], $"m_RemovedComponents: []\nm_RemovedGameObjects: []\nm_AddedGameObjects:\n"
                    + $"- targetCorrespondingSourceObject: {{fileID: 201, guid: {ThingGuid}, type: 3}}\n  insertIndex: -1\n  addedObject: {{fileID: 21}}\n"
                    + $"m_AddedComponents:\n- targetCorrespondingSourceObject: {{fileID: 200, guid: {ThingGuid}, type: 3}}\n  insertIndex: -1\n"
                    + "  addedObject: {fileID: 30}")
                .StandIn(4, "Transform", 9, 201, ThingGuid, 7).StandIn(1, "GameObject", 8, 200, ThingGuid, 7)
                .GameObject(20, "added", 9).Add(20, "Camera", 30, "m_GameObject: {fileID: 8}\nm_Enabled: 1").Roots(7));
            Assert.That((Find("added").transform.parent.name, Find("inner").GetComponent<Camera>() != null), Is.EqualTo(("inner", true)));
        }

        [Test]
        public void Instance_Removals_AreGone()
        {
            LoadInstance([], $"m_RemovedComponents:\n- {{fileID: 103, guid: {ThingGuid}, type: 3}}\n"
                + $"m_RemovedGameObjects:\n- {{fileID: 200, guid: {ThingGuid}, type: 3}}");
            Assert.That((Recorder.Log.Count, Root.transform.childCount, Root.place), Is.EqualTo((0, 0, (Transform)null)));
        }

        [Test]
        public void Prefab_WithinAPrefab_IsReachedByUnitysNumbers()
        {
            WriteThing();
            const long Inner = 0x700000, Outer = 0x50000000;
            var outer = Project.Guid("Outer.prefab");
            Project.Write("Outer.prefab", new Yaml().GameObject(300, "outer", 0, [9]).Instance(Inner, ThingGuid, 301, ["102|number|6"])
                .StandIn(4, "Transform", 9, 101, ThingGuid, Inner).ToString());
            // An object of an instance has the number instance XOR object.
            Load(new Yaml().Instance(Outer, outer, 0, [$"{Inner ^ 102}|text|set from outside", "9|m_LocalPosition.y|4"])
                .StandIn(114, "MonoBehaviour", 50, Inner ^ 202, outer, Outer)
                .GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<SceneFields>(), "other: {fileID: 50}").Roots(Outer, 11));
            Assert.That((Root.number, Root.text, Root.transform.localPosition.y, Root.transform.parent.name), Is.EqualTo((6, "set from outside", 4f, "outer")));
            Assert.That(Find("a").GetComponent<SceneFields>().other, Is.SameAs(Find("inner").GetComponent<SceneFields>()));
        }

        [Test]
        public void Variant_OfAPrefab_IsItsInstance()
        {
            WriteThing();
            Project.Write("Variant.prefab", new Yaml().Instance(7, ThingGuid, 0, ["102|number|11", "100|m_Name|variant"]).ToString());
            var copy = Host.InstantiatePrefab(System.IO.Path.Combine(Project.Root, "Variant.prefab"));
            Assert.That((copy.name, copy.GetComponent<SceneFields>().number), Is.EqualTo(("variant", 11)));
        }

        [TestCase("102|nunber|6", "'nunber'")]
        [TestCase("999|number|6", "999")]
        [TestCase("102|number|many", "'many'")]
        [TestCase("102|list.Array.data[4]|1", "1 items")]
        [TestCase("102|place||{fileID: 88}", "88")]
        [TestCase("102|number.x|1", "no fields")]
        public void Instance_ChangeThatDoesNotFit_IsRefused(string change, string expected)
        {
            WriteThing();
            var path = Project.Write("Test.unity", new Yaml().Instance(7, ThingGuid, 0, [change]).Roots(7).ToString());
            Assert.That(() => Host.LoadScene(path), Throws.TypeOf<AssetFormatException>().With.Message.Contains(expected).And.Message.StartsWith(path));
        }

        [Test]
        public void Instance_OfAnUnknownPrefab_IsRefused() => Assert.That(
            () => Load(new Yaml().Instance(7, "0123456789abcdef0123456789abcdef").Roots(7)),
            Throws.TypeOf<AssetFormatException>().With.Message.Contains("0123456789"));

        [Test]
        public void Prefab_ThatContainsItself_IsRefused()
        {
            var own = Project.Guid("Self.prefab");
            var prefab = new Yaml().GameObject(300, "a", 0, [9]).Instance(7, own, 301).StandIn(4, "Transform", 9, 301, own, 7);
            var path = Project.Write("Self.prefab", prefab.ToString());
            Assert.That(() => Host.InstantiatePrefab(path), Throws.TypeOf<AssetFormatException>().With.Message.Contains("contains itself"));
        }

        [Test]
        public void StandIn_OfNothing_IsRefused() => Assert.That(() =>
        {
            WriteThing();
            Load(new Yaml().Instance(7, ThingGuid).StandIn(4, "Transform", 9, 777, ThingGuid, 7).Roots(7));
        }, Throws.TypeOf<AssetFormatException>().With.Message.Contains("777"));

        [Test]
        public void Prefab_WithTwoRoots_IsRefused()
        {
            var path = Project.Write("Two.prefab", new Yaml().GameObject(300, "a").GameObject(400, "b").ToString());
            Assert.That(() => Host.InstantiatePrefab(path), Throws.TypeOf<AssetFormatException>().With.Message.Contains("2 GameObjects"));
        }
    }
}
