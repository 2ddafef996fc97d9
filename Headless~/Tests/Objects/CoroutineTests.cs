using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class CoroutineTests : SceneTests
    {
        readonly List<string> m_Log = new();

        [SetUp]
        public void ClearLog() => m_Log.Clear();

        IEnumerator Steps(params object[] yields)
        {
            for (var i = 0; i < yields.Length; i++)
            {
                m_Log.Add(i.ToString());
                yield return yields[i];
            }

            m_Log.Add("end");
        }

        [Test]
        public void StartCoroutine_RunsToTheFirstYieldAtOnce()
        {
            Make<Recorder>("a").StartCoroutine(Steps(null, null));
            Assert.That(m_Log, Is.EqualTo(new[] { "0" }));
        }

        [Test]
        public void YieldNull_ResumesOncePerFrame()
        {
            Make<Recorder>("a").StartCoroutine(Steps(null, null));
            Frame();
            Assert.That(m_Log, Is.EqualTo(new[] { "0", "1" }));
        }

        [Test]
        public void Coroutine_StartedInUpdate_DoesNotResumeInThatFrame()
        {
            Recorder.Reactions["Update"] = r => { Recorder.Reactions.Remove("Update"); r.StartCoroutine(Steps([null])); };
            Make<FrameRecorder>("a");
            Frame();
            Assert.That(m_Log, Is.EqualTo(new[] { "0" }));
        }

        [Test]
        public void Coroutine_Resumes_BetweenUpdateAndLateUpdate()
        {
            IEnumerator Routine()
            {
                yield return null;
                Recorder.Log.Add("routine");
            }

            Make<FrameRecorder>("a").StartCoroutine(Routine());
            Frame();
            var at = Recorder.Log.IndexOf("routine");
            Assert.That((Recorder.Log[at - 1], Recorder.Log[at + 1]), Is.EqualTo(("a.Update", "a.LateUpdate")));
        }

        [Test]
        public void NestedEnumerator_ThatEndsAtOnce_LetsTheParentGoOnInTheSameFrame()
        {
            Make<Recorder>("a").StartCoroutine(Steps(Steps(), null));
            Assert.That(m_Log, Is.EqualTo(new[] { "0", "end", "1" }));
        }

        [Test]
        public void NestedEnumerator_StartsInTheSameFrame()
        {
            Make<Recorder>("a").StartCoroutine(Steps(Steps(null, null)));
            Frame();
            Frame();
            Assert.That(m_Log, Is.EqualTo(new[] { "0", "0", "1", "end", "end" }));
        }

        [Test]
        public void WaitForSeconds_ResumesAtTheFirstFrameThatIsDue()
        {
            Make<Recorder>("a").StartCoroutine(Steps(new WaitForSeconds(0.03f)));
            Frame(0.02f);
            var early = m_Log.Count;
            Frame(0.02f);
            Assert.That((early, m_Log.Count), Is.EqualTo((1, 2)));
        }

        [Test]
        public void WaitForEndOfFrame_ResumesAfterBeforeRender()
        {
            IEnumerator Routine()
            {
                yield return new WaitForEndOfFrame();
                m_Log.Add("routine");
            }

            void Note() => m_Log.Add("render");
            Application.onBeforeRender += Note;
            Make<Recorder>("a").StartCoroutine(Routine());
            Frame();
            Application.onBeforeRender -= Note;
            Assert.That(m_Log, Is.EqualTo(new[] { "render", "routine" }));
        }

        [Test]
        public void WaitForFixedUpdate_ResumesAfterFixedUpdate()
        {
            IEnumerator Routine()
            {
                yield return new WaitForFixedUpdate();
                Recorder.Log.Add("routine");
            }

            Make<FrameRecorder>("a").StartCoroutine(Routine());
            Frame(0.021f);
            Frame(0.021f);
            Assert.That(Recorder.Log[Recorder.Log.IndexOf("routine") - 1], Is.EqualTo("a.FixedUpdate"));
        }

        [Test]
        public void WaitUntil_AsksOncePerFrame()
        {
            var asked = 0;
            Make<Recorder>("a").StartCoroutine(Steps(new WaitUntil(() => ++asked == 3)));
            Frame();
            Frame();
            Assert.That((asked, m_Log.Count), Is.EqualTo((3, 2)));
        }

        [Test]
        public void SetActiveFalse_KillsCoroutinesForGood()
        {
            var script = Make<Recorder>("a");
            script.StartCoroutine(Steps(null, null));
            script.gameObject.SetActive(false);
            script.gameObject.SetActive(true);
            Frame();
            Assert.That(m_Log, Has.Count.EqualTo(1));
        }

        [Test]
        public void EnabledFalse_DoesNotStopCoroutines()
        {
            var script = Make<Recorder>("a");
            script.StartCoroutine(Steps(null, null));
            script.enabled = false;
            Frame();
            Assert.That(m_Log, Has.Count.EqualTo(2));
        }

        [Test]
        public void StartCoroutine_OnInactiveObject_LogsAnErrorAndReturnsNull()
        {
            var script = Make<Recorder>("a");
            script.gameObject.SetActive(false);
            LogAssert.Expect(LogType.Error, "Coroutine couldn't be started because the the game object 'a' is inactive!");
            Assert.That(script.StartCoroutine(Steps([null])), Is.Null);
        }

        [Test]
        public void StopCoroutine_OfParent_LeavesAnExplicitlyStartedChildRunning()
        {
            var script = Make<Recorder>("a");
            var child = script.StartCoroutine(Steps([null]));
            var parent = script.StartCoroutine(Steps(child, null));
            script.StopCoroutine(parent);
            Frame();
            Assert.That(m_Log, Is.EqualTo(new[] { "0", "0", "end" }));
        }

        [Test]
        public void Exception_InCoroutine_IsLoggedAndEndsItWithItsWaiter()
        {
            static IEnumerator Failing()
            {
                yield return null;
                throw new System.InvalidOperationException("no");
            }

            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            Make<Recorder>("a").StartCoroutine(Steps(Failing()));
            Frame();
            Frame();
            Assert.That(m_Log, Is.EqualTo(new[] { "0" }));
        }

        sealed class StartRoutine : MonoBehaviour
        {
            internal int Step;

            IEnumerator Start()
            {
                Step = 1;
                yield return null;
                Step = 2;
            }
        }

        [Test]
        public void Start_ThatIsAnEnumerator_RunsAsCoroutine()
        {
            var script = Make<StartRoutine>("a");
            Frame();
            var first = script.Step;
            Frame();
            Assert.That((first, script.Step), Is.EqualTo((1, 2)));
        }
    }
}
