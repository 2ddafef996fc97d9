using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using AnatomyCarve.Headless.Tests.Objects;
using AnatomyCarve.Headless.Tests.Scenes;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Tests.Hosting
{
    /// <summary>A script that lives in edit mode too.</summary>
    [ExecuteAlways]
    public sealed class EditRecorder : FrameRecorder
    {
    }

    /// <summary>The old attribute.</summary>
    [ExecuteInEditMode]
    public sealed class OldEditRecorder : Recorder
    {
    }

    /// <summary>Writes down what only the Editor sends.</summary>
    public sealed class Validated : MonoBehaviour
    {
        [SerializeField]
        int number = 1;

        [SerializeField]
        Nested nested = new();

        internal static List<string> Heard { get; } = new();

        internal int Number => number;

        internal int Inner => nested.set;

        void Reset() => Heard.Add("Reset");

        void OnValidate()
        {
            number = Mathf.Max(number, 0);
            Heard.Add("OnValidate");
        }

        void Awake() => Heard.Add("Awake");
    }

    /// <summary>The host as the Editor that is not playing.</summary>
    public sealed class EditModeTests : ProjectTests
    {
        readonly List<string> m_Messages = new();

        [SetUp]
        public void ForgetWhatWasHeard()
        {
            Validated.Heard.Clear();
            m_Messages.Clear();
        }

        UnityHost Edit() => Start(o => (o.PlayMode, o.Log) = (false, (type, text, _) => m_Messages.Add($"{type}: {text}")));

        [Test]
        public void Application_IsTheEditorAtRest()
        {
            Edit();
            var thing = new GameObject("thing");
            Assert.That((Application.isPlaying, Application.isEditor, Application.platform, Application.IsPlaying(thing)),
                Is.EqualTo((false, true, RuntimePlatform.LinuxEditor, false)));
        }

        [Test]
        public void Application_InPlay_IsAPlayer()
        {
            Start();
            Assert.That((Application.isPlaying, Application.isEditor, Application.IsPlaying(new GameObject())), Is.EqualTo((true, false, true)));
        }

        [Test]
        public void Script_WithoutTheAttribute_SleepsButIsEnabled()
        {
            Edit();
            var script = new GameObject("a").AddComponent<FrameRecorder>();
            Host.Step();
            Assert.That((Recorder.Log.Count, script.isActiveAndEnabled, script.didAwake), Is.EqualTo((0, true, false)));
            Object.DestroyImmediate(script.gameObject);
            Assert.That(Recorder.Log, Is.Empty);
        }

        [Test]
        public void Script_WithTheAttribute_Lives()
        {
            Edit();
            var g = new GameObject("a", typeof(EditRecorder));
            Host.Step();
            Object.DestroyImmediate(g);
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "a.Awake", "a.OnEnable", "a.Start", "a.Update", "a.LateUpdate", "a.OnDisable", "a.OnDestroy" }));
        }

        [Test]
        public void Script_WithTheOldAttribute_LivesToo()
        {
            Edit();
            var g = new GameObject("a", typeof(OldEditRecorder));
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "a.Awake", "a.OnEnable" }));
            Object.DestroyImmediate(g);
        }

        [Test]
        public void Tick_RunsAFrameOnlyWhenAsked()
        {
            Edit();
            var g = new GameObject("a", typeof(EditRecorder));
            Assert.That((Host.Tick(), Recorder.Log.Count), Is.EqualTo((false, 2)));
            EditorApplication.QueuePlayerLoopUpdate();
            Assert.That((Host.Tick(), Recorder.Log[^1]), Is.EqualTo((true, "a.LateUpdate")));
            Assert.That(Host.Tick(), Is.False);
            Object.DestroyImmediate(g);
        }

        [Test]
        public void Tick_CallsWhatTheEditorCalls()
        {
            Edit();
            var calls = new List<string>();
            EditorApplication.update += () => calls.Add("update");
            EditorApplication.delayCall += () => calls.Add("delayed");
            Host.Tick();
            Host.Tick();
            Assert.That(calls, Is.EqualTo(new[] { "delayed", "update", "update" }));
        }

        [Test]
        public void Tick_GoesOnWithAsyncMethods()
        {
            Edit();
            var done = false;
            async void Wait()
            {
                await Task.Yield();
                done = true;
            }

            Wait();
            Assert.That(done, Is.False);
            Host.Tick();
            Assert.That(done, Is.True);
        }

        [Test]
        public void Destroy_IsRefused()
        {
            Edit();
            var g = new GameObject("a");
            Object.Destroy(g);
            Host.Step();
            Assert.That((g != null, m_Messages.Count), Is.EqualTo((true, 1)));
            Assert.That(m_Messages[0], Does.StartWith("Error: Destroy may not be called from edit mode! Use DestroyImmediate instead."));
            Object.DestroyImmediate(g);
            Assert.That(g == null, Is.True);
        }

        [Test]
        public void DontDestroyOnLoad_IsRefused()
        {
            Edit();
            Assert.That(() => Object.DontDestroyOnLoad(new GameObject()), Throws.InvalidOperationException);
        }

        [Test]
        public void AddComponent_SendsResetAndOnValidate()
        {
            Edit();
            new GameObject("a", typeof(Validated));
            Assert.That(Validated.Heard, Is.EqualTo(new[] { "Reset", "OnValidate" }));
        }

        [Test]
        public void LoadScene_SendsOnValidate_ToSleepingObjectsToo()
        {
            var scene = new Yaml().GameObject(10, "a", components: [12], active: false).Script(12, 10, Project.Script<Validated>(), "number: -5")
                .GameObject(20, "b", components: [22]).Script(22, 20, Project.Script<EditRecorder>()).Roots(11, 21);
            Edit();
            Load(scene);
            Assert.That((Validated.Heard, Recorder.Log), Is.EqualTo((new List<string> { "OnValidate" }, new List<string> { "b.Awake", "b.OnEnable" })));
            Assert.That(Object.FindFirstObjectByType<Validated>(FindObjectsInactive.Include).Number, Is.Zero);
        }

        [Test]
        public void Prefab_GetsOnValidateWhenItIsLoadedAndWhenItIsCopied()
        {
            var path = Project.Write("A.prefab", new Yaml().GameObject(10, "a", components: [12]).Script(12, 10, Project.Script<Validated>()).ToString());
            Edit();
            var prefab = Host.LoadAsset(path);
            Assert.That(Validated.Heard, Is.EqualTo(new[] { "OnValidate" }));
            Object.DestroyImmediate(Object.Instantiate(prefab));
            Assert.That(Validated.Heard, Has.Count.EqualTo(2));
        }

        [Test]
        public void SetSerializedField_TellsTheScript()
        {
            Edit();
            var script = new GameObject("a").AddComponent<Validated>();
            Host.SetSerializedField(script, "number", -3);
            Host.SetSerializedField(script, "nested.set", 7);
            Assert.That((script.Number, script.Inner, Validated.Heard.Count), Is.EqualTo((0, 7, 4)));
        }

        [Test]
        public void SetSerializedField_Unknown_IsRefused()
        {
            Edit();
            var script = new GameObject("a").AddComponent<Validated>();
            Assert.That(() => Host.SetSerializedField(script, "nunber", 1), Throws.ArgumentException.With.Message.Contains("nunber"));
        }

        [Test]
        public void InPlay_NothingIsValidated()
        {
            Start();
            var script = new GameObject("a").AddComponent<Validated>();
            Host.SetSerializedField(script, "number", -3);
            Assert.That((Validated.Heard, script.Number), Is.EqualTo((new List<string> { "Awake" }, -3)));
        }

        static class Hooks
        {
            internal static int Calls { get; set; }

            [InitializeOnLoadMethod]
            static void OnLoad() => Calls++;

            [RuntimeInitializeOnLoadMethod]
            static void OnPlay() => Calls += 100;
        }

        [Test]
        public void Start_CallsTheEditorsHooks()
        {
            Hooks.Calls = 0;
            Edit();
            Assert.That(Hooks.Calls, Is.EqualTo(1));
        }

        [Test]
        public void Start_InPlay_CallsThePlayersHooks()
        {
            Hooks.Calls = 0;
            Start();
            Assert.That(Hooks.Calls, Is.EqualTo(100));
        }

        [Test]
        public void Dispose_EndsScriptsWithoutQuitting()
        {
            Edit();
            new GameObject("a", typeof(EditRecorder));
            Host.Dispose();
            Assert.That(Recorder.Log[^2..], Is.EqualTo(new[] { "a.OnDisable", "a.OnDestroy" }));
        }
    }
}
