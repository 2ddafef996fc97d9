using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class FrameOrderTests : SceneTests
    {
        readonly List<string> m_Log = new();

        [SetUp]
        public void ClearLog() => m_Log.Clear();

        [Test]
        public void Frame_RunsItsPartsInUnitysOrder()
        {
            void Render() => Recorder.Log.Add("onBeforeRender");
            void Cull(Camera c) => Recorder.Log.Add("onPreCull");
            void Early() => Recorder.Log.Add("early");
            Make<FrameRecorder>("a");
            Make<Camera>("camera");
            Frame();
            Application.onBeforeRender += Render;
            Camera.onPreCull += Cull;
            EngineLoop.EarlyUpdate += Early;
            SynchronizationContext.Current.Post(_ => Recorder.Log.Add("posted"), null);
            Recorder.Log.Clear();
            Frame(0.021f);
            Application.onBeforeRender -= Render;
            Camera.onPreCull -= Cull;
            EngineLoop.EarlyUpdate -= Early;
            Assert.That(Recorder.Log.Distinct(),
                Is.EqualTo(new[] { "early", "a.FixedUpdate", "a.Update", "posted", "a.LateUpdate", "onBeforeRender", "onPreCull" }));
        }

        [Test]
        public void Post_FromPostedWork_WaitsForTheNextFrame()
        {
            var context = SynchronizationContext.Current;
            context.Post(_ => context.Post(_ => m_Log.Add("inner"), null), null);
            Frame();
            var early = m_Log.Count;
            Frame();
            Assert.That((early, m_Log.Count), Is.EqualTo((0, 1)));
        }

        [Test]
        public void Post_AfterOneThatThrows_RunsInTheNextFrame()
        {
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            SynchronizationContext.Current.Post(_ => throw new System.InvalidOperationException("no"), null);
            SynchronizationContext.Current.Post(_ => m_Log.Add("second"), null);
            Frame();
            var early = m_Log.Count;
            Frame();
            Assert.That((early, m_Log.Count), Is.EqualTo((0, 1)));
        }

        [Test]
        public void Await_InUpdate_ResumesOnTheMainThread()
        {
            var threads = new List<int>();
            async void Work()
            {
                await Task.Run(() => { });
                threads.Add(Thread.CurrentThread.ManagedThreadId);
            }

            Work();
            // Frames are over in no time; the other thread needs some to begin.
            Assert.That(ObjectsSetUp.Host.RunUntil(() => threads.Count > 0 || Thread.CurrentThread.Join(1), 10000), Is.True);
            Assert.That(threads, Is.EqualTo(new[] { Thread.CurrentThread.ManagedThreadId }));
        }

        [BeforeRenderOrder(-10)]
        void Early() => m_Log.Add("early");

        void Normal() => m_Log.Add("normal");

        [Test]
        public void OnBeforeRender_IsSortedByOrder()
        {
            Application.onBeforeRender += Normal;
            Application.onBeforeRender += Early;
            Frame();
            Application.onBeforeRender -= Normal;
            Application.onBeforeRender -= Early;
            Assert.That(m_Log, Is.EqualTo(new[] { "early", "normal" }));
        }

        [Test]
        public void OnBeforeRender_ThatThrows_StopsTheLaterOnes()
        {
            void Fail() => throw new System.InvalidOperationException("no");
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            Application.onBeforeRender += Fail;
            Application.onBeforeRender += Normal;
            Frame();
            Application.onBeforeRender -= Normal;
            Application.onBeforeRender -= Fail;
            Assert.That(m_Log, Is.Empty);
        }

        [Test]
        public void DeltaTime_OfALongFrame_IsClamped()
        {
            Frame(5f);
            Assert.That((Time.deltaTime, Time.unscaledDeltaTime), Is.EqualTo((Time.maximumDeltaTime, 5f)));
        }

        [Test]
        public void DeltaTime_InFixedUpdate_IsTheFixedStep()
        {
            var seen = 0f;
            Recorder.Reactions["FixedUpdate"] = _ => seen = Time.deltaTime;
            Make<FrameRecorder>("a");
            Frame(0.021f);
            Assert.That(seen, Is.EqualTo(Time.fixedDeltaTime));
        }

        [Test]
        public void MainThreadApi_OnAnotherThread_Throws()
        {
            var g = new GameObject("a");
            var thrown = Task.Run(() => Assert.Catch(() => _ = g.name)).Result;
            Assert.That(thrown, Is.TypeOf<UnityException>().With.Message.StartsWith("get_name can only be called from the main thread."));
        }

        [Test]
        public void Math_OnAnotherThread_Works() =>
            Assert.That(Task.Run(() => Quaternion.Euler(0f, 90f, 0f) * Vector3.forward).Result.x, Is.EqualTo(1f).Within(1E-6f));

        [Test]
        public void LogMessageReceived_ForALogOfAnotherThread_IsNotRaised()
        {
            var main = new List<string>();
            var all = new List<string>();
            void Main(string condition, string stackTrace, LogType type) => main.Add(condition);
            void All(string condition, string stackTrace, LogType type) => all.Add(condition);
            Application.logMessageReceived += Main;
            Application.logMessageReceivedThreaded += All;
            Task.Run(() => Debug.Log("from a worker")).Wait();
            Application.logMessageReceived -= Main;
            Application.logMessageReceivedThreaded -= All;
            Assert.That((main.Count, all.Count), Is.EqualTo((0, 1)));
        }

        static int s_Started;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)]
        static void OnLoad() => s_Started++;

        [Test]
        public void RuntimeInitializeOnLoadMethod_RanAtStart() => Assert.That(s_Started, Is.GreaterThan(0));

        [Test]
        public void Tests_RunOnTheThreadThatStartedTheHost() => Assert.That(MainThread.IsCurrent, Is.True);
    }
}
