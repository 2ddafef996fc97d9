using System.Collections.Generic;
using System.Threading;

namespace UnityEngine
{
    /// <summary>Carries work to the main thread, once per frame.</summary>
    sealed class UnitySynchronizationContext : SynchronizationContext
    {
        readonly Thread m_Thread;
        readonly List<Work> m_Queue;
        readonly List<Work> m_Current = new();

        internal UnitySynchronizationContext(Thread thread) : this(thread, new List<Work>())
        {
        }

        UnitySynchronizationContext(Thread thread, List<Work> queue)
        {
            m_Thread = thread;
            m_Queue = queue;
        }

        public override void Post(SendOrPostCallback d, object state)
        {
            lock (m_Queue)
                m_Queue.Add(new Work(d, state, null));
        }

        /// <summary>Blocks a worker until the main thread has done it.</summary>
        public override void Send(SendOrPostCallback d, object state)
        {
            if (m_Thread == Thread.CurrentThread)
            {
                d(state);
                return;
            }

            using var done = new ManualResetEventSlim();
            lock (m_Queue)
                m_Queue.Add(new Work(d, state, done));
            done.Wait();
        }

        public override SynchronizationContext CreateCopy() => new UnitySynchronizationContext(m_Thread, m_Queue);

        /// <summary>Runs what was queued before this call; work that comes meanwhile waits for the next frame. After an exception the rest waits too.</summary>
        internal void Run()
        {
            lock (m_Queue)
            {
                m_Current.AddRange(m_Queue);
                m_Queue.Clear();
            }

            while (m_Current.Count > 0)
            {
                var work = m_Current[0];
                m_Current.RemoveAt(0);
                if (!LogRouter.Guard(work.Invoke))
                    return;
            }
        }

        readonly struct Work
        {
            readonly SendOrPostCallback m_Callback;
            readonly object m_State;
            readonly ManualResetEventSlim m_Done;

            internal Work(SendOrPostCallback callback, object state, ManualResetEventSlim done)
            {
                m_Callback = callback;
                m_State = state;
                m_Done = done;
            }

            internal void Invoke()
            {
                try
                {
                    m_Callback(m_State);
                }
                finally
                {
                    m_Done?.Set();
                }
            }
        }
    }
}
