using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>Components that others need.</summary>
    static class Wiring
    {
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
