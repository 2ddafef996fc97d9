using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>Components that work together: wired in the inspector or by a script, or else on the same GameObject.</summary>
    static class Siblings
    {
        /// <summary>
        /// The one that was wired; else the one on the owner's GameObject. Null where there is none. What was not wired is not written into the field, which
        /// would be saved with the scene.
        /// </summary>
        public static T WiredOrSibling<T>(this Component owner, T wired) where T : Component =>
            wired != null ? wired : owner.TryGetComponent(out T sibling) ? sibling : null;
    }
}
