using UnityEngine;

namespace UnityEditor
{
    /// <summary>What the Editor does with prefabs' instances.</summary>
    public sealed class PrefabUtility
    {
        public PrefabUtility()
        {
        }

        /// <summary>
        /// Notes how an instance differs from its prefab, for saving; for other objects it does nothing. Headless nothing is saved, and no instance remembers
        /// its prefab, so there are only others.
        /// </summary>
        public static void RecordPrefabInstancePropertyModifications(Object targetObject) => MainThread.Check("RecordPrefabInstancePropertyModifications");
    }
}
