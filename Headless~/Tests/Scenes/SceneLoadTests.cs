using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using AnatomyCarve.Headless.Tests.Objects;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>What a scene file becomes.</summary>
    public sealed class SceneLoadTests : ProjectTests
    {
        [Test]
        public void Load_Hierarchy_IsAsInTheFile()
        {
            Load(new Yaml().GameObject(10, "b").GameObject(20, "a", 0, [31, 41]).GameObject(30, "second", 21).GameObject(40, "first", 21).Roots(21, 11));
            Assert.That(System.Array.ConvertAll(SceneManager.GetActiveScene().GetRootGameObjects(), g => g.name), Is.EqualTo(new[] { "a", "b" }));
            Assert.That((Find("a").transform.GetChild(0).name, Find("first").transform.parent.name), Is.EqualTo(("second", "a")));
        }

        [Test]
        public void Load_Transform_HasItsPose()
        {
            Load(new Yaml().Add(1, "GameObject", 10, "m_Component:\n- component: {fileID: 11}\nm_Name: a").Add(4, "Transform", 11,
                "m_GameObject: {fileID: 10}\nm_LocalRotation: {x: 0, y: 0.70710677, z: 0, w: 0.70710677}\nm_LocalPosition: {x: 1, y: 2, z: 3}\n"
                + "m_LocalScale: {x: 2, y: 2, z: 2}\nm_Children: []\nm_Father: {fileID: 0}").Roots(11));
            var t = Find("a").transform;
            Assert.That((t.localPosition, t.localScale), Is.EqualTo((new Vector3(1f, 2f, 3f), Vector3.one * 2f)));
            Assert.That(t.localEulerAngles.y, Is.EqualTo(90f).Within(1e-4f));
        }

        [Test]
        public void Load_Camera_HasItsSettings()
        {
            Load(new Yaml().GameObject(10, "a", components: [12]).Add(20, "Camera", 12, "m_GameObject: {fileID: 10}\nm_Enabled: 1\nserializedVersion: 2\n"
                + "m_ClearFlags: 2\nm_BackGroundColor: {r: 0.1, g: 0.2, b: 0.3, a: 1}\nm_NormalizedViewPortRect:\n  serializedVersion: 2\n  x: 0\n  y: 0\n"
                + "  width: 0.5\n  height: 1\nnear clip plane: 0.01\nfar clip plane: 50\nfield of view: 40\northographic: 0\northographic size: 5\n"
                + "m_Depth: -1\nm_CullingMask:\n  serializedVersion: 2\n  m_Bits: 32\nm_TargetEye: 1").Roots(11));
            var camera = Find("a").GetComponent<Camera>();
            Assert.That(camera.stereoTargetEye, Is.EqualTo(StereoTargetEyeMask.Left));
            Assert.That((camera.clearFlags, camera.nearClipPlane, camera.farClipPlane, camera.fieldOfView, camera.depth, camera.cullingMask, camera.rect.width),
                Is.EqualTo((CameraClearFlags.SolidColor, 0.01f, 50f, 40f, -1f, 32, 0.5f)));
        }

        [Test]
        public void Load_RectTransform_HasItsLayout()
        {
            Load(new Yaml().Add(1, "GameObject", 10, "m_Component:\n- component: {fileID: 11}\nm_Name: a").Add(224, "RectTransform", 11,
                "m_GameObject: {fileID: 10}\nm_Children: []\nm_Father: {fileID: 0}\nm_AnchorMin: {x: 0, y: 0}\nm_AnchorMax: {x: 1, y: 0}\n"
                + "m_AnchoredPosition: {x: 4, y: 5}\nm_SizeDelta: {x: 30, y: 20}\nm_Pivot: {x: 0.5, y: 0}").Roots(11));
            var rect = (RectTransform)Find("a").transform;
            Assert.That((rect.anchorMax, rect.anchoredPosition, rect.sizeDelta, rect.pivot, rect.rect.height),
                Is.EqualTo((new Vector2(1f, 0f), new Vector2(4f, 5f), new Vector2(30f, 20f), new Vector2(0.5f, 0f), 20f)));
        }

        [Test]
        public void Load_ScriptFields_AreSetAndTheOthersKept()
        {
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<SceneFields>(),
                "number: 8\noldHidden: 6\nlist:\n- 1\n- 2.5\nnested:\n  set: 7\n  vector: {x: 9}\nitems:\n- set: 1\n- kept: 2").Roots(11));
            var f = Find("a").GetComponent<SceneFields>();
            Assert.That((f.number, f.untouched, f.Hidden, f.list.Length), Is.EqualTo((8, 42, 6, 2)));
            Assert.That((f.nested.set, f.nested.kept, f.nested.vector), Is.EqualTo((7, 9, new Vector3(9f, 2f, 3f))), "what the file does not say stays");
            Assert.That((f.items[0].kept, f.items[1].kept), Is.EqualTo((5, 2)));
        }

        [Test]
        public void Load_References_LeadToTheirObjects()
        {
            Project.Write("Data.asset", new Yaml().Add(114, "MonoBehaviour", 11400000,
                $"m_GameObject: {{fileID: 0}}\nm_Script: {Project.Script<SampleAsset>()}\nm_Name: Data\nnumber: 4").ToString());
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<SceneFields>(),
                "place: {fileID: 21}\nthing: {fileID: 20}\nother: {fileID: 22}\n"
                    + $"asset: {{fileID: 11400000, guid: {Project.Guid("Data.asset")}, type: 2}}")
                .GameObject(20, "b", components: [22]).Script(22, 20, Project.Script<SceneFields>()).Roots(11, 21));
            var f = Find("a").GetComponent<SceneFields>();
            Assert.That((f.place, f.thing, f.other), Is.EqualTo((Find("b").transform, Find("b"), Find("b").GetComponent<SceneFields>())));
            Assert.That(((SampleAsset)f.asset).number, Is.EqualTo(4));
        }

        [Test]
        public void Load_AllScripts_WakeBeforeAnyStarts()
        {
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<Recorder>())
                .GameObject(20, "b", components: [22]).Script(22, 20, Project.Script<EarlyRecorder>()).Roots(11, 21));
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "b.Awake", "b.OnEnable", "a.Awake", "a.OnEnable" }), "lower execution order first");
            Host.Step();
            Assert.That(Recorder.Log[4..6], Is.EqualTo(new[] { "b.Start", "a.Start" }));
        }

        [Test]
        public void Load_SleepingObjectsAndDisabledScripts_StayAsTheyAre()
        {
            Load(new Yaml().GameObject(10, "a", 0, [21], [12], active: false).Script(12, 10, Project.Script<Recorder>())
                .GameObject(20, "inner", 11, components: [22]).Script(22, 20, Project.Script<Recorder>())
                .GameObject(30, "c", components: [32]).Script(32, 30, Project.Script<Recorder>(), enabled: false).Roots(11, 31));
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "c.Awake" }));
            SceneManager.GetActiveScene().GetRootGameObjects()[0].SetActive(true);
            Assert.That(Recorder.Log[1..], Is.EqualTo(new[] { "a.Awake", "a.OnEnable", "inner.Awake", "inner.OnEnable" }));
        }

        [Test]
        public void Load_SecondScene_EndsTheFirst()
        {
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<Recorder>()).Roots(11));
            Recorder.Log.Clear();
            Host.LoadScene(Project.Write("Second.unity", new Yaml().GameObject(10, "b").Roots(11).ToString()));
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "a.OnDisable", "a.OnDestroy" }));
            Assert.That((SceneManager.GetActiveScene().name, SceneManager.sceneCount, Find("a") == null), Is.EqualTo(("Second", 1, true)));
        }

        [Test]
        public void Load_BrokenScene_LeavesTheFirst()
        {
            Load(new Yaml().GameObject(10, "a").Roots(11));
            var broken = Project.Write("Broken.unity", new Yaml().GameObject(10, "b").Roots(99).ToString());
            Assert.That(() => Host.LoadScene(broken), Throws.TypeOf<AssetFormatException>());
            Assert.That((SceneManager.GetActiveScene().name, SceneManager.GetActiveScene().rootCount, Find("a") != null), Is.EqualTo(("Test", 1, true)));
        }

        [Test]
        public void Load_OldScene_NeedsNoSceneRoots()
        {
            Load(new Yaml().GameObject(10, "a").GameObject(20, "b"));
            Assert.That(SceneManager.GetActiveScene().rootCount, Is.EqualTo(2));
        }

        [Test]
        public void Unload_Scene_EndsItsObjects()
        {
            Load(new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<Recorder>()).Roots(11));
            Host.UnloadScene();
            Assert.That((Recorder.Log[^1], SceneManager.GetActiveScene().name), Is.EqualTo(("a.OnDestroy", "")));
        }

        [Test]
        public void Load_MissingFile_NamesIt() =>
            Assert.That(() => Host.LoadScene("Nowhere.unity"), Throws.InstanceOf<System.IO.FileNotFoundException>().With.Message.Contains("Nowhere.unity"));
    }
}
