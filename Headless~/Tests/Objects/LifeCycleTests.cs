using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class LifeCycleTests : SceneTests
    {
        [Test]
        public void AddComponent_OnActiveObject_RunsAwakeAndOnEnable()
        {
            Make<Recorder>("a");
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "a.Awake", "a.OnEnable" }));
        }

        [Test]
        public void AddComponent_OnInactiveObject_RunsNothing()
        {
            var g = new GameObject("a");
            g.SetActive(false);
            g.AddComponent<Recorder>();
            Assert.That(Recorder.Log, Is.Empty);
        }

        [Test]
        public void SetActive_OnHierarchy_WakesComponentByComponent()
        {
            var g = new GameObject("a");
            g.SetActive(false);
            g.AddComponent<Recorder>();
            var child = new GameObject("b");
            child.transform.SetParent(g.transform);
            child.AddComponent<Recorder>();
            g.SetActive(true);
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "a.Awake", "a.OnEnable", "b.Awake", "b.OnEnable" }));
        }

        [Test]
        public void SetActive_WithExecutionOrder_WakesLowerFirst()
        {
            var g = new GameObject("a");
            g.SetActive(false);
            g.AddComponent<Recorder>();
            var child = new GameObject("b");
            child.transform.SetParent(g.transform);
            child.AddComponent<EarlyRecorder>();
            g.SetActive(true);
            Assert.That(Recorder.Log[0], Is.EqualTo("b.Awake"));
        }

        [Test]
        public void Frame_OfNewScript_StartsBeforeItUpdates()
        {
            Make<FrameRecorder>("a");
            Frame();
            Frame();
            Assert.That(Recorder.Log, Is.EqualTo(new[]
            {
                "a.Awake", "a.OnEnable", "a.Start", "a.FixedUpdate", "a.Update", "a.LateUpdate", "a.FixedUpdate", "a.Update", "a.LateUpdate",
            }).Or.EqualTo(new[] { "a.Awake", "a.OnEnable", "a.Start", "a.Update", "a.LateUpdate", "a.FixedUpdate", "a.Update", "a.LateUpdate" }));
        }

        [Test]
        public void DisabledScript_OnActiveObject_IsAwakeButNotStarted()
        {
            var script = Make<FrameRecorder>("a");
            script.enabled = false;
            Recorder.Log.Clear();
            Frame();
            Assert.That((Recorder.Log.Count, script.didAwake, script.didStart), Is.EqualTo((0, true, false)));
        }

        [Test]
        public void Enabled_SetToFalse_SendsOnDisableAtOnce()
        {
            var script = Make<Recorder>("a");
            script.enabled = false;
            Assert.That(Recorder.Log[^1], Is.EqualTo("a.OnDisable"));
        }

        [Test]
        public void Enabled_SetToTheSame_DoesNothing()
        {
            var script = Make<Recorder>("a");
            script.enabled = true;
            Assert.That(Recorder.Log, Has.Count.EqualTo(2));
        }

        [Test]
        public void ScriptAddedInUpdate_StartsBeforeLateUpdate()
        {
            Recorder.Reactions["Update"] = r =>
            {
                if (r.name == "a")
                    new GameObject("b").AddComponent<FrameRecorder>();
            };
            Make<FrameRecorder>("a");
            Frame();
            Assert.That(Recorder.Log.IndexOf("b.Start"), Is.GreaterThan(0).And.LessThan(Recorder.Log.IndexOf("a.LateUpdate")));
        }

        [Test]
        public void AwakeThatThrows_DisablesTheScript()
        {
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            Recorder.Reactions["Awake"] = _ => throw new System.InvalidOperationException("no");
            var script = Make<Recorder>("a");
            Assert.That((script.enabled, Recorder.Log.Contains("a.OnEnable")), Is.EqualTo((false, false)));
        }

        [Test]
        public void UpdateThatThrows_LeavesOthersAlone()
        {
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            Recorder.Reactions["Update"] = r => { if (r.name == "a") throw new System.InvalidOperationException("no"); };
            Make<FrameRecorder>("a");
            Make<FrameRecorder>("b");
            Frame();
            Assert.That(Recorder.Log, Does.Contain("b.Update").And.Contain("a.LateUpdate"));
        }

        [Test]
        public void UpdateThatThrows_IsCalledAgainNextFrame()
        {
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            Recorder.Reactions["Update"] = _ => throw new System.InvalidOperationException("no");
            Make<FrameRecorder>("a");
            Frame();
            Frame();
            Assert.That(Recorder.Log.FindAll(l => l == "a.Update"), Has.Count.EqualTo(2));
        }

        class Base : MonoBehaviour
        {
            internal string Seen;

            void Awake() => Seen = "base";
        }

        sealed class Derived : Base
        {
            void Awake() => Seen = "derived";
        }

        sealed class Inheriting : Base
        {
        }

        [Test]
        public void PrivateMessage_HiddenByDerivedClass_IsNotCalled() => Assert.That(Make<Derived>("a").Seen, Is.EqualTo("derived"));

        [Test]
        public void PrivateMessage_OfBaseClass_IsFound() => Assert.That(Make<Inheriting>("a").Seen, Is.EqualTo("base"));

        [RequireComponent(typeof(Camera))]
        sealed class NeedsCamera : MonoBehaviour
        {
        }

        [Test]
        public void RequireComponent_OnAdd_BringsTheOther() => Assert.That(Make<NeedsCamera>("a").GetComponent<Camera>(), Is.Not.Null);

        [Test]
        public void RequiredComponent_Destroyed_IsRefused()
        {
            var camera = Make<NeedsCamera>("a").GetComponent<Camera>();
            LogAssert.Expect(LogType.Error, "Can't remove Camera because NeedsCamera (Script) depends on it");
            Object.DestroyImmediate(camera);
            Assert.That(camera != null, Is.True);
        }

        [DisallowMultipleComponent]
        sealed class Single : MonoBehaviour
        {
        }

        [Test]
        public void DisallowMultipleComponent_OnSecond_IsRefused()
        {
            var first = Make<Single>("a");
            LogAssert.Expect(LogType.Error, new Regex("already added"));
            Assert.That(first.gameObject.AddComponent<Single>(), Is.Null);
        }

        [Test]
        public void Transform_Destroyed_IsRefused()
        {
            var t = new GameObject("a").transform;
            LogAssert.Expect(LogType.Error, new Regex("^Can't destroy Transform"));
            Object.DestroyImmediate(t);
            Assert.That(t != null, Is.True);
        }
    }
}
