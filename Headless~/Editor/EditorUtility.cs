using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor
{
    /// <summary>What the Editor notes of objects.</summary>
    public class EditorUtility
    {
        static readonly HashSet<int> s_Dirty = new();

        public EditorUtility()
        {
        }

        /// <summary>Notes that an asset has to be saved. Headless nothing is saved.</summary>
        public static void SetDirty(Object target)
        {
            MainThread.Check("SetDirty");
            s_Dirty.Add(target.GetInstanceID());
        }

        public static void ClearDirty(Object target) => s_Dirty.Remove(target.GetInstanceID());

        public static bool IsDirty(Object target) => s_Dirty.Contains(target.GetInstanceID());

        /// <summary>True for assets, prefabs among them.</summary>
        public static bool IsPersistent(Object target) => target != null && target.IsAsset;

        internal static void Forget() => s_Dirty.Clear();
    }
}
