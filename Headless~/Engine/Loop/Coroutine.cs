using System.Collections;

namespace UnityEngine
{
    /// <summary>Base of what a coroutine may yield to wait for the engine.</summary>
    public class YieldInstruction
    {
    }

    /// <summary>A running coroutine, which others may wait for.</summary>
    public sealed class Coroutine : YieldInstruction
    {
        Coroutine()
        {
        }

        internal MonoBehaviour Owner { get; private set; }

        internal IEnumerator Routine { get; private set; }

        /// <summary>The coroutine whose step started this one by yielding an enumerator; it ends with it.</summary>
        internal Coroutine Parent { get; private set; }

        internal Coroutine Child { get; set; }

        /// <summary>The one that waits for this to end.</summary>
        internal Coroutine Waiter { get; set; }

        internal bool IsDone { get; set; }

        /// <summary>Stopped or failed: it never goes on, nor does its waiter.</summary>
        internal bool IsDead { get; set; }

        internal static Coroutine Create(MonoBehaviour owner, IEnumerator routine, Coroutine parent) =>
            new() { Owner = owner, Routine = routine, Parent = parent };
    }
}
