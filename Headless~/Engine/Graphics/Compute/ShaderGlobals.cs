using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>What Shader.SetGlobal* sets, and names of properties.</summary>
    static class ShaderGlobals
    {
        static readonly Dictionary<string, int> s_Ids = new(StringComparer.Ordinal);
        static readonly List<string> s_Names = new();

        internal static PropertySheet Values { get; } = new();

        internal static KernelResources Resources { get; } = new();

        internal static HashSet<string> Keywords { get; } = new(StringComparer.Ordinal);

        /// <summary>A number for a name, the same for the life of the process. Any thread.</summary>
        internal static int Id(string name)
        {
            if (name == null)
                throw new ArgumentNullException(nameof(name));
            lock (s_Ids)
            {
                if (!s_Ids.TryGetValue(name, out var id))
                {
                    id = s_Names.Count + 1;
                    s_Names.Add(name);
                    s_Ids.Add(name, id);
                }
                return id;
            }
        }

        /// <summary>The name of a number, or null.</summary>
        internal static string Name(int id)
        {
            lock (s_Ids)
                return id > 0 && id <= s_Names.Count ? s_Names[id - 1] : null;
        }

        internal static void Clear()
        {
            Values.Clear();
            Resources.Clear();
            Keywords.Clear();
        }
    }
}
