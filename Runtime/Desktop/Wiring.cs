using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>Components that work together: wired in the inspector or by a script, or else on the same GameObject.</summary>
    static class Wiring
    {
        /// <summary>The one that was wired; else the one on the owner's GameObject, which is remembered. Null where there is none.</summary>
        public static T Wired<T>(this Component owner, ref T wired) where T : Component
        {
            if (wired == null)
                owner.TryGetComponent(out wired);
            return wired;
        }

        /// <summary>Whether a component that another one cannot do without is there; says so if not.</summary>
        public static bool Has<T>(this MonoBehaviour owner, T other, string property) where T : Component
        {
            if (other != null)
                return true;
            Debug.LogError(
                $"{owner.GetType().Name} on '{owner.name}' has no {typeof(T).Name} and is disabled: set {property}, or put it on the GameObject of one.", owner);
            return false;
        }
    }
}
