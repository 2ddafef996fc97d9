using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class DestructionTests : SceneTests
    {
        [Test]
        public void Destroy_BeforeTheFrameEnds_LeavesTheObjectAlive()
        {
            var g = new GameObject("a");
            Object.Destroy(g);
            Assert.That(g != null, Is.True);
        }

        [Test]
        public void Destroy_AfterTheFrame_HasEndedIt()
        {
            var g = new GameObject("a");
            Object.Destroy(g);
            Frame();
            Assert.That(g == null, Is.True);
        }

        [Test]
        public void Destroy_InUpdate_IsDoneBeforeRendering()
        {
            var script = Make<FrameRecorder>("a");
            Recorder.Reactions["Update"] = r => Object.Destroy(r.gameObject);
            var aliveAtRender = true;
            void Look() => aliveAtRender = script != null;
            Application.onBeforeRender += Look;
            Frame();
            Application.onBeforeRender -= Look;
            Assert.That(aliveAtRender, Is.False);
        }

        [Test]
        public void Destroy_WithDelay_WaitsForScaledTime()
        {
            var g = new GameObject("a");
            Object.Destroy(g, 0.05f);
            Frame(0.02f);
            var after20 = g != null;
            Frame(0.02f);
            Frame(0.02f);
            Assert.That((after20, g != null), Is.EqualTo((true, false)));
        }

        [Test]
        public void Destroy_OfNull_IsSilent() => Assert.That(() => Object.Destroy(null), Throws.Nothing);

        [Test]
        public void DestroyImmediate_OfHierarchy_DisablesAllBeforeDestroyingAny()
        {
            var parent = Make<Recorder>("a");
            Make<Recorder>("b").transform.SetParent(parent.transform);
            Recorder.Log.Clear();
            Object.DestroyImmediate(parent.gameObject);
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "a.OnDisable", "b.OnDisable", "a.OnDestroy", "b.OnDestroy" }));
        }

        [Test]
        public void OnDestroy_OfScriptThatNeverWoke_IsNotSent()
        {
            var g = new GameObject("a");
            g.SetActive(false);
            g.AddComponent<Recorder>();
            Object.DestroyImmediate(g);
            Assert.That(Recorder.Log, Is.Empty);
        }

        [Test]
        public void DestroyToken_OnDestroy_IsCancelled()
        {
            var script = Make<Recorder>("a");
            var token = script.destroyCancellationToken;
            Object.DestroyImmediate(script);
            Assert.That(token.IsCancellationRequested, Is.True);
        }

        [Test]
        public void DestroyToken_FirstAskedForAfterDestruction_Throws()
        {
            var script = Make<Recorder>("a");
            Object.DestroyImmediate(script);
            Assert.That(() => script.destroyCancellationToken, Throws.TypeOf<MissingReferenceException>());
        }

        sealed class Data : ScriptableObject
        {
            void OnDisable() => Recorder.Log.Add("OnDisable");

            void OnDestroy() => Recorder.Log.Add("OnDestroy");
        }

        [Test]
        public void ScriptableObject_Destroyed_GetsOnDisableThenOnDestroy()
        {
            Object.DestroyImmediate(ScriptableObject.CreateInstance<Data>());
            Assert.That(Recorder.Log, Is.EqualTo(new[] { "OnDisable", "OnDestroy" }));
        }

        [Test]
        public void CreateInstance_OfOtherType_Throws() =>
            Assert.That(() => ScriptableObject.CreateInstance(typeof(string)), Throws.TypeOf<ArgumentException>());

        [Test]
        public void Asset_Destroyed_IsRefused()
        {
            var data = ScriptableObject.CreateInstance<Data>();
            data.IsAsset = true;
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("^Destroying assets is not permitted"));
            Object.DestroyImmediate(data);
            var alive = data != null;
            Object.DestroyImmediate(data, true);
            Assert.That(alive, Is.True);
        }
    }
}
