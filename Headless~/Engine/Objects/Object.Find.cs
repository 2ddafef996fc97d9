using System;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Whether a search meets inactive objects.</summary>
    public enum FindObjectsInactive
    {
        Exclude = 0,
        Include = 1,
    }

    /// <summary>The order of what a search found.</summary>
    public enum FindObjectsSortMode
    {
        None = 0,
        InstanceID = 1,
    }

    public partial class Object
    {
        public static Object[] FindObjectsByType(Type type, FindObjectsSortMode sortMode) => FindObjectsByType(type, FindObjectsInactive.Exclude, sortMode);

        public static Object[] FindObjectsByType(Type type, FindObjectsInactive findObjectsInactive, FindObjectsSortMode sortMode)
        {
            MainThread.Check("FindObjectsByType");
            var found = ObjectRegistry.Snapshot().Where(o => type.IsInstanceOfType(o) && !o.IsAsset && IsFound(o, findObjectsInactive));
            if (sortMode == FindObjectsSortMode.InstanceID)
                found = found.OrderBy(o => o.m_InstanceId);
            var list = found.ToList();
            var array = (Object[])Array.CreateInstance(type, list.Count);
            list.CopyTo(array);
            return array;
        }

        public static T[] FindObjectsByType<T>(FindObjectsSortMode sortMode) where T : Object => (T[])FindObjectsByType(typeof(T), sortMode);

        public static T[] FindObjectsByType<T>(FindObjectsInactive findObjectsInactive, FindObjectsSortMode sortMode) where T : Object =>
            (T[])FindObjectsByType(typeof(T), findObjectsInactive, sortMode);

        /// <summary>The one with the lowest instance ID.</summary>
        public static Object FindFirstObjectByType(Type type) => FindFirstObjectByType(type, FindObjectsInactive.Exclude);

        public static Object FindFirstObjectByType(Type type, FindObjectsInactive findObjectsInactive) =>
            FindObjectsByType(type, findObjectsInactive, FindObjectsSortMode.InstanceID).FirstOrDefault();

        public static T FindFirstObjectByType<T>() where T : Object => (T)FindFirstObjectByType(typeof(T));

        public static T FindFirstObjectByType<T>(FindObjectsInactive findObjectsInactive) where T : Object =>
            (T)FindFirstObjectByType(typeof(T), findObjectsInactive);

        public static Object FindAnyObjectByType(Type type) => FindAnyObjectByType(type, FindObjectsInactive.Exclude);

        public static Object FindAnyObjectByType(Type type, FindObjectsInactive findObjectsInactive) =>
            FindObjectsByType(type, findObjectsInactive, FindObjectsSortMode.None).FirstOrDefault();

        public static T FindAnyObjectByType<T>() where T : Object => (T)FindAnyObjectByType(typeof(T));

        public static T FindAnyObjectByType<T>(FindObjectsInactive findObjectsInactive) where T : Object =>
            (T)FindAnyObjectByType(typeof(T), findObjectsInactive);

        static bool IsFound(Object o, FindObjectsInactive inactive)
        {
            if ((o.m_HideFlags & HideFlags.DontSave) != 0)
                return false;
            var owner = o as GameObject ?? (o as Component)?.Owner;
            return owner is null || (!owner.IsAsset && (inactive == FindObjectsInactive.Include || owner.IsActive));
        }
    }
}
