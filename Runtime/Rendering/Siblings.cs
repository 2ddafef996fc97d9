using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>Components that work together: wired in the inspector or by a script, or else on the same GameObject.</summary>
    static class Siblings
    {
        /// <summary>The one that was wired; else the one on the owner's GameObject, which is remembered. Null where there is none.</summary>
        public static T WiredOrSibling<T>(this Component owner, ref T wired) where T : Component
        {
            if (wired == null)
                owner.TryGetComponent(out wired);
            return wired;
        }
    }
}
