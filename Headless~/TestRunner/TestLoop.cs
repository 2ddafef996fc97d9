using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.ExceptionServices;

namespace UnityEngine.TestTools
{
    /// <summary>Steps tests as a coroutine of the object that Unity's runner has too, while it steps the player loop.</summary>
    static class TestLoop
    {
        /// <summary>One frame of a headset.</summary>
        const float FrameSeconds = 1f / 72f;

        sealed class Outcome
        {
            internal Exception Exception;
            internal bool IsOver;
        }

        /// <summary>Runs a routine to its end, or to its first exception, which it throws.</summary>
        /// <exception cref="TimeoutException">It took longer; that is looked at between frames.</exception>
        internal static void Run(IEnumerator routine, int timeoutMs)
        {
            var runner = new GameObject("Code-based tests runner");
            // It outlives the scenes that a test loads.
            Object.DontDestroyOnLoad(runner);
            try
            {
                var outcome = new Outcome();
                runner.AddComponent<TestRunnerBehaviour>().StartCoroutine(Drive(routine, outcome));
                var clock = Stopwatch.StartNew();
                while (!outcome.IsOver)
                {
                    if (clock.ElapsedMilliseconds > timeoutMs)
                        throw new TimeoutException($"Timeout value of {timeoutMs}ms was exceeded.");
                    if (!Object.IsAlive(runner))
                        throw new InvalidOperationException("The test destroyed the object 'Code-based tests runner', which runs it");
                    EngineLoop.Step(FrameSeconds);
                }

                if (outcome.Exception != null)
                    ExceptionDispatchInfo.Capture(outcome.Exception).Throw();
            }
            finally
            {
                Object.DestroyImmediate(runner);
            }
        }

        static IEnumerator Drive(IEnumerator routine, Outcome outcome)
        {
            // The first step happens where all steps happen: after Update.
            yield return null;
            var stack = new Stack<IEnumerator>();
            stack.Push(routine);
            while (stack.Count > 0)
            {
                object current = null;
                var moved = false;
                try
                {
                    moved = stack.Peek().MoveNext();
                    current = moved ? stack.Peek().Current : null;
                    LogScope.Current.Evaluate(false);
                    Refuse(current);
                }
                catch (Exception e)
                {
                    outcome.Exception = e;
                    break;
                }

                if (!moved)
                    stack.Pop();
                else if (current is IEnumerator nested)
                    stack.Push(nested);
                else
                    yield return current;
            }

            outcome.IsOver = true;
        }

        static void Refuse(object yielded)
        {
            if (yielded is WaitForEndOfFrame)
                throw new InvalidOperationException("UnityTest yielded WaitForEndOfFrame, which is not evoked in batchmode.");
        }
    }

    /// <summary>What the running test's coroutine belongs to.</summary>
    sealed class TestRunnerBehaviour : MonoBehaviour
    {
    }
}
