using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>The running scripts and their per-frame messages.</summary>
    static class ScriptLoop
    {
        static readonly List<MonoBehaviour> s_Running = new();
        static readonly List<MonoBehaviour> s_ToStart = new();

        internal static void Add(MonoBehaviour script)
        {
            s_Running.Add(script);
            if (!script.didStart)
                s_ToStart.Add(script);
        }

        internal static void Remove(MonoBehaviour script)
        {
            s_Running.RemoveAll(s => ReferenceEquals(s, script));
            s_ToStart.RemoveAll(s => ReferenceEquals(s, script));
        }

        internal static void Forget()
        {
            s_Running.Clear();
            s_ToStart.Clear();
        }

        /// <summary>Start for all that wait for it, including those that such a Start brings.</summary>
        internal static void RunStarts()
        {
            while (s_ToStart.Count > 0)
            {
                var batch = Ordered(s_ToStart);
                s_ToStart.Clear();
                foreach (var script in batch)
                    if (Object.IsAlive(script))
                        script.StartIfNeeded();
            }
        }

        /// <summary>Sends a message to the scripts that run now, in execution order; those that come meanwhile wait for the next time.</summary>
        internal static void Send(Func<Messages, Message> which)
        {
            foreach (var script in Ordered(s_Running))
                if (script.IsRunning && script.didStart && which(script.Messages).Exists)
                    which(script.Messages).Send(script);
        }

        internal static void SendToAll(Func<Messages, Message> which)
        {
            foreach (var script in Ordered(s_Running))
                if (script.IsRunning)
                    which(script.Messages).Send(script);
        }

        static List<MonoBehaviour> Ordered(List<MonoBehaviour> scripts) => scripts.OrderBy(s => s.ExecutionOrder).ToList();
    }
}
