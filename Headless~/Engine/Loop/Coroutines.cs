using System.Collections;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>When a waiting coroutine goes on.</summary>
    enum ResumePoint
    {
        Update,
        FixedUpdate,
        EndOfFrame,
    }

    /// <summary>Steps the coroutines of all scripts.</summary>
    static class Coroutines
    {
        sealed class Wait
        {
            internal Coroutine Coroutine;
            internal ResumePoint Point;
            internal int Frame;
            internal double Due;
            internal AsyncOperation Operation;
        }

        static List<Wait> s_Waiting = new();
        static readonly List<Coroutine> s_Alive = new();

        internal static Coroutine Start(MonoBehaviour owner, IEnumerator routine)
        {
            if (!owner.Owner.IsActive)
            {
                Debug.LogError($"Coroutine couldn't be started because the the game object '{owner.NameForMessages}' is inactive!");
                return null;
            }

            var coroutine = Coroutine.Create(owner, routine, null);
            s_Alive.Add(coroutine);
            Step(coroutine);
            return coroutine;
        }

        internal static void Stop(MonoBehaviour owner, IEnumerator routine)
        {
            if (s_Alive.Find(c => ReferenceEquals(c.Routine, routine) && ReferenceEquals(c.Owner, owner)) is { } found)
                Kill(found);
        }

        internal static void Stop(MonoBehaviour owner, Coroutine coroutine)
        {
            if (ReferenceEquals(coroutine.Owner, owner))
                Kill(coroutine);
            else
                Debug.LogError("Coroutine continue failure");
        }

        internal static void StopAll(MonoBehaviour owner)
        {
            foreach (var coroutine in s_Alive.FindAll(c => ReferenceEquals(c.Owner, owner)))
                Kill(coroutine);
        }

        internal static void Forget()
        {
            s_Waiting.Clear();
            s_Alive.Clear();
        }

        /// <summary>Goes on with all that wait for this point of the frame, in the order in which they began to wait.</summary>
        internal static void Resume(ResumePoint point)
        {
            var due = s_Waiting.FindAll(w => w.Point == point && IsDue(w));
            s_Waiting = s_Waiting.FindAll(w => !due.Contains(w));
            foreach (var wait in due)
                Step(wait.Coroutine);
        }

        static bool IsDue(Wait wait)
        {
            if (wait.Operation != null)
                return wait.Operation.isDone;
            return wait.Point != ResumePoint.Update || (wait.Frame < Time.frameCount && wait.Due <= Time.timeAsDouble);
        }

        static void Step(Coroutine coroutine)
        {
            while (!coroutine.IsDead && !coroutine.IsDone)
            {
                var moved = false;
                object current = null;
                if (!LogRouter.Guard(() => { moved = coroutine.Routine.MoveNext(); current = moved ? coroutine.Routine.Current : null; }))
                {
                    Kill(coroutine);
                    return;
                }

                if (coroutine.IsDead)
                    return;
                if (!moved)
                {
                    Finish(coroutine);
                    return;
                }

                if (!GoesOnAtOnce(coroutine, current))
                    return;
            }
        }

        /// <summary>Arranges for what was yielded.</summary>
        /// <returns>True if it is over already.</returns>
        static bool GoesOnAtOnce(Coroutine coroutine, object yielded)
        {
            switch (yielded)
            {
                case WaitForSeconds seconds:
                    Enqueue(coroutine, ResumePoint.Update, Time.timeAsDouble + seconds.Seconds);
                    return false;
                case WaitForFixedUpdate:
                    Enqueue(coroutine, ResumePoint.FixedUpdate, 0);
                    return false;
                case WaitForEndOfFrame:
                    Enqueue(coroutine, ResumePoint.EndOfFrame, 0);
                    return false;
                case AsyncOperation operation:
                    if (operation.isDone)
                        return true;
                    s_Waiting.Add(new Wait { Coroutine = coroutine, Point = ResumePoint.Update, Frame = Time.frameCount, Operation = operation });
                    return false;
                case Coroutine other:
                    return WaitFor(coroutine, other);
                case IEnumerator nested:
                    var child = Coroutine.Create(coroutine.Owner, nested, coroutine);
                    coroutine.Child = child;
                    s_Alive.Add(child);
                    Step(child);
                    return WaitFor(coroutine, child);
                default:
                    Enqueue(coroutine, ResumePoint.Update, 0);
                    return false;
            }
        }

        static bool WaitFor(Coroutine coroutine, Coroutine other)
        {
            if (other.IsDone)
                return true;
            if (other.Waiter != null)
                Debug.LogError("Another coroutine is already waiting for this coroutine!\nCurrently only one coroutine can wait for another coroutine!");
            else
                other.Waiter = coroutine;
            return false;
        }

        static void Enqueue(Coroutine coroutine, ResumePoint point, double due) =>
            s_Waiting.Add(new Wait { Coroutine = coroutine, Point = point, Frame = Time.frameCount, Due = due });

        static void Finish(Coroutine coroutine)
        {
            coroutine.IsDone = true;
            s_Alive.Remove(coroutine);
            if (coroutine.Waiter is { } waiter)
                Step(waiter);
        }

        /// <summary>Ends a coroutine for good. As in Unity its enumerator is not disposed of, so its finally blocks do not run.</summary>
        static void Kill(Coroutine coroutine)
        {
            coroutine.IsDead = true;
            s_Alive.Remove(coroutine);
            s_Waiting.RemoveAll(w => ReferenceEquals(w.Coroutine, coroutine));
            if (coroutine.Child is { IsDone: false, IsDead: false } child)
                Kill(child);
        }
    }
}
