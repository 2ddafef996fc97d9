using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Something that takes frames. A coroutine may yield it; it is done at the start of a frame, on the main thread.</summary>
    public class AsyncOperation : YieldInstruction
    {
        Action<AsyncOperation> m_Completed;
        bool m_Done;

        public AsyncOperation()
        {
        }

        /// <summary>Raised when the operation is done; at once for a listener that comes later.</summary>
        public event Action<AsyncOperation> completed
        {
            add
            {
                if (m_Done)
                    value(this);
                else
                    m_Completed += value;
            }
            remove => m_Completed -= value;
        }

        public bool isDone => m_Done;

        /// <summary>0 to 1.</summary>
        public float progress => m_Done ? 1f : Progress();

        public int priority { get; set; }

        /// <summary>False holds a loaded scene back.</summary>
        public bool allowSceneActivation { get; set; } = true;

        /// <summary>How far it is while it is not done.</summary>
        internal virtual float Progress() => 0f;

        /// <summary>Ends the operation: called at the start of a frame.</summary>
        internal void Finish()
        {
            m_Done = true;
            var callbacks = m_Completed;
            m_Completed = null;
            foreach (var callback in callbacks?.GetInvocationList() ?? Array.Empty<Delegate>())
                LogRouter.Guard(() => ((Action<AsyncOperation>)callback)(this));
        }
    }

    /// <summary>The operations that run: each is asked at the start of a frame whether it is over.</summary>
    static class AsyncOperations
    {
        static readonly List<(AsyncOperation Operation, Func<bool> IsOver)> s_Running = new();

        internal static void Add(AsyncOperation operation, Func<bool> isOver) => s_Running.Add((operation, isOver));

        internal static void RunCompletions()
        {
            foreach (var entry in s_Running.FindAll(r => r.IsOver()))
            {
                s_Running.Remove(entry);
                entry.Operation.Finish();
            }
        }

        internal static void Forget() => s_Running.Clear();
    }
}
