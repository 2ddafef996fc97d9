using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>All living objects. As in Unity, an object lives until it is destroyed, referenced or not.</summary>
    static class ObjectRegistry
    {
        static readonly Dictionary<int, Object> s_Alive = new();

        internal static int Count
        {
            get { lock (s_Alive) return s_Alive.Count; }
        }

        internal static void Add(Object o)
        {
            lock (s_Alive)
                s_Alive.Add(o.InstanceIdOnAnyThread, o);
        }

        internal static void Remove(Object o)
        {
            lock (s_Alive)
                s_Alive.Remove(o.InstanceIdOnAnyThread);
        }

        internal static void Clear()
        {
            lock (s_Alive)
                s_Alive.Clear();
        }

        /// <summary>A copy, in order of creation.</summary>
        internal static List<Object> Snapshot()
        {
            lock (s_Alive)
                return s_Alive.Values.OrderByDescending(o => o.InstanceIdOnAnyThread).ToList();
        }
    }
}
