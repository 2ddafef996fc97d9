using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>Where loaded volumes lie in the world.</summary>
    static class VolumeBounds
    {
        /// <param name="renderers">Renderers; others count as nothing.</param>
        /// <param name="bounds">What holds all of their volumes.</param>
        /// <returns>Whether one of them has a volume.</returns>
        public static bool TryGet(Object[] renderers, out Bounds bounds)
        {
            bounds = default;
            bool any = false;
            foreach (Object o in renderers)
            {
                if (!(o is CarvedVolumeRenderer renderer) || renderer.Volume == null)
                    continue;
                Bounds one = VolumeBox.BoundsIn(renderer.Volume.Geometry, renderer.transform.localToWorldMatrix);
                if (any)
                    bounds.Encapsulate(one);
                else
                    bounds = one;
                any = true;
            }
            return any;
        }
    }
}
