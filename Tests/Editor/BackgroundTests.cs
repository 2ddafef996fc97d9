using System;
using System.Threading;
using AnatomyCarve.Editor;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>What Inspectors have computed on another thread.</summary>
    sealed class BackgroundTests
    {
        const int PatienceMs = 30000;

        [Test]
        public void Result_OfASource_ComesWhenItIsComputed()
        {
            using (var gate = new ManualResetEventSlim())
            {
                var background = new Background<string, string>(s =>
                {
                    gate.Wait(PatienceMs);
                    return s + "!";
                });
                Assert.That(background.Of("a"), Is.Null);
                Assert.That(background.IsBusy, Is.True);
                gate.Set();
                Assert.That(Wait(background, "a"), Is.EqualTo("a!"));
                Assert.That(background.IsBusy, Is.False);
            }
        }

        [Test]
        public void Source_AskedTwice_IsComputedOnce()
        {
            int runs = 0;
            var background = new Background<string, string>(s => (Interlocked.Increment(ref runs) * 10).ToString());
            Assert.That(Wait(background, "a"), Is.EqualTo("10"));
            Assert.That(background.Of("a"), Is.EqualTo("10"));
        }

        [Test]
        public void Source_ThatIsReplaced_LeavesNoResult()
        {
            var background = new Background<string, string>(s => s + "!");
            Wait(background, "a");
            Assert.That(Wait(background, "b"), Is.EqualTo("b!"));
            Assert.That(background.Of(null), Is.Null);
            Assert.That(background.IsBusy, Is.False);
        }

        [Test]
        public void Failure_OfTheComputation_IsThrownToWhoAsks()
        {
            var background = new Background<string, string>(s => throw new InvalidOperationException("no"));
            Assert.That(() => Wait(background, "a"), Throws.TypeOf<AggregateException>());
        }

        static string Wait(Background<string, string> background, string source)
        {
            string result = null;
            Assert.That(SpinWait.SpinUntil(() => (result = background.Of(source)) != null, PatienceMs), Is.True, "no result came");
            return result;
        }
    }
}
