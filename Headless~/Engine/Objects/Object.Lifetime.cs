using System;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    public partial class Object
    {
        /// <summary>Destroys the object at the end of the frame's updates, before rendering. Null is let pass.</summary>
        public static void Destroy(Object obj) => Destroy(obj, 0f);

        /// <summary>Destroys the object <paramref name="t"/> seconds (scaled time) from now.</summary>
        public static void Destroy(Object obj, float t)
        {
            MainThread.Check("Destroy");
            if (IsAlive(obj) && Application.InEditMode)
            {
                Debug.LogError("Destroy may not be called from edit mode! Use DestroyImmediate instead.\nDestroying an object in edit mode destroys it "
                    + "permanently.");
                return;
            }

            if (IsAlive(obj) && Destruction.IsAllowed(obj, false))
                Destruction.Schedule(obj, t);
        }

        /// <summary>Destroys the object now; OnDisable and OnDestroy have run on return.</summary>
        public static void DestroyImmediate(Object obj) => DestroyImmediate(obj, false);

        public static void DestroyImmediate(Object obj, bool allowDestroyingAssets)
        {
            MainThread.Check("DestroyImmediate");
            if (IsAlive(obj) && Destruction.IsAllowed(obj, allowDestroyingAssets))
                Destruction.Now(obj);
        }

        /// <summary>Keeps a root object across scene changes.</summary>
        public static void DontDestroyOnLoad(Object target)
        {
            MainThread.Check("DontDestroyOnLoad");
            target.EnsureAlive();
            if (Application.InEditMode)
                throw new InvalidOperationException(
                    "The following game object is invoking the DontDestroyOnLoad method: " + target.NameForMessages
                        + ". Notice that DontDestroyOnLoad can only be used in play mode and, as such, cannot be part of an editor script.");
            var transform = target is GameObject g ? g.transform : (target as Component)?.transform;
            if (transform is { parent: not null })
                Debug.LogWarning("DontDestroyOnLoad only works for root GameObjects or components on root GameObjects.");
            else
                transform?.MoveTo(LoadedScenes.DontDestroy);
        }

        public static Object Instantiate(Object original) => Cloner.Clone(original, null, false);

        public static Object Instantiate(Object original, Transform parent) => Cloner.Clone(original, parent, false);

        public static Object Instantiate(Object original, Transform parent, bool instantiateInWorldSpace) =>
            Cloner.Clone(original, parent, instantiateInWorldSpace);

        public static Object Instantiate(Object original, Vector3 position, Quaternion rotation) => Cloner.Clone(original, null, position, rotation);

        public static Object Instantiate(Object original, Vector3 position, Quaternion rotation, Transform parent) =>
            Cloner.Clone(original, parent, position, rotation);

        /// <summary>A deep copy named "X(Clone)": serialised fields are copied, references inside the hierarchy point into the copy.</summary>
        /// <exception cref="ArgumentException">The original is null.</exception>
        public static T Instantiate<T>(T original) where T : Object => (T)Cloner.Clone(original, null, false);

        public static T Instantiate<T>(T original, Transform parent) where T : Object => (T)Cloner.Clone(original, parent, false);

        public static T Instantiate<T>(T original, Transform parent, bool worldPositionStays) where T : Object =>
            (T)Cloner.Clone(original, parent, worldPositionStays);

        public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation) where T : Object =>
            (T)Cloner.Clone(original, null, position, rotation);

        public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation, Transform parent) where T : Object =>
            (T)Cloner.Clone(original, parent, position, rotation);

        /// <summary>A copy of an object that is neither GameObject nor script; null where none is implemented.</summary>
        internal virtual Object CloneNative() => null;
    }
}
