using System.Collections.Generic;

namespace UnityEditor
{
    /// <summary>What lasts as long as the Editor runs, also where code is loaded anew.</summary>
    public class SessionState
    {
        static readonly Dictionary<string, bool> s_Bools = new();

        public static void SetBool(string key, bool value) => s_Bools[key] = value;

        public static bool GetBool(string key, bool defaultValue) => s_Bools.TryGetValue(key, out var value) ? value : defaultValue;

        public static void EraseBool(string key) => s_Bools.Remove(key);
    }
}
