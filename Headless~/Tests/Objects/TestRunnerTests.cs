using System.Collections;
using System.Text.RegularExpressions;
using System.Threading.Tasks;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class TestRunnerTests : SceneTests
    {
        int m_SetUpFrame = -1;
        bool m_IsSetUp;

        [UnitySetUp]
        public IEnumerator SetUpOverFrames()
        {
            m_SetUpFrame = Time.frameCount;
            m_IsSetUp = false;
            yield return null;
            m_IsSetUp = Time.frameCount == m_SetUpFrame + 1;
        }

        [Test]
        public void UnitySetUp_RanBeforeAPlainTest() => Assert.That(m_IsSetUp, Is.True);

        [UnityTest]
        public IEnumerator UnityTest_YieldNull_TakesOneFrame()
        {
            var frame = Time.frameCount;
            yield return null;
            Assert.That(Time.frameCount, Is.EqualTo(frame + 1));
        }

        [UnityTest]
        public IEnumerator UnityTest_NestedEnumerator_IsFollowed()
        {
            var frame = Time.frameCount;
            yield return Frames(3);
            Assert.That(Time.frameCount, Is.EqualTo(frame + 3));
        }

        [UnityTest]
        public IEnumerator UnityTest_WithValues_GetsThem([Values(1, 2)] int a, [Values("x")] string b)
        {
            yield return null;
            Assert.That((a is 1 or 2, b), Is.EqualTo((true, "x")));
        }

        [Test]
        public async Task AsyncTest_AwaitingTheNextFrames_IsPumped()
        {
            var thread = System.Environment.CurrentManagedThreadId;
            await Task.Run(() => { });
            Assert.That(System.Environment.CurrentManagedThreadId, Is.EqualTo(thread));
        }

        [Test]
        public void Expect_AfterTheLog_IsMet()
        {
            Debug.LogError("wrong");
            LogAssert.Expect(LogType.Error, "wrong");
        }

        [Test]
        public void UnexpectedError_FailsTheEvaluation()
        {
            Debug.LogError("wrong");
            Assert.That(() => LogScope.Current.Evaluate(false), Throws.TypeOf<LogFailureException>().With.Message.Contains("[Error] wrong"));
        }

        [Test]
        public void Warning_DoesNotFailTheEvaluation()
        {
            Debug.LogWarning("careful");
            Assert.That(() => LogScope.Current.Evaluate(false), Throws.Nothing);
        }

        [Test]
        public void Warning_FailsNoUnexpectedReceived()
        {
            Debug.LogWarning("careful");
            Assert.That(LogAssert.NoUnexpectedReceived, Throws.TypeOf<LogFailureException>());
        }

        [Test]
        public void ExpectedLog_ThatDoesNotCome_FailsAtTheEnd()
        {
            LogAssert.Expect(LogType.Error, "missing");
            Assert.That(() => LogScope.Current.Evaluate(true), Throws.TypeOf<LogFailureException>().With.Message.Contains("missing"));
        }

        [Test]
        public void ExpectedLogs_OutOfOrder_Fail()
        {
            LogAssert.Expect(LogType.Error, "first");
            LogAssert.Expect(LogType.Error, "second");
            Debug.LogError("second");
            Assert.That(() => LogScope.Current.Evaluate(false), Throws.TypeOf<LogFailureException>().With.Message.Contains("out of order"));
            LogScope.Current.Forget();
        }

        [Test]
        public void Exception_IsLoggedWithTypeAndMessage()
        {
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");
            Debug.LogException(new System.InvalidOperationException("no"));
        }

        [Test]
        public void Expect_WithRegex_MatchesAPart()
        {
            LogAssert.Expect(LogType.Error, new Regex("ron"));
            Debug.LogError("wrong");
        }

        static IEnumerator Frames(int count)
        {
            for (var i = 0; i < count; i++)
                yield return null;
        }
    }
}
