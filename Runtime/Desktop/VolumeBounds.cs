using System;
using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>The box that a volume fills in the world, for instance to show all of it: <c>view.Frame(VolumeBounds.Of(loader))</c>.</summary>
    public static class VolumeBounds
    {
        /// <summary>The smallest box along the world's axes that holds the volume.</summary>
        /// <param name="loader">The volume's loader.</param>
        /// <exception cref="ArgumentNullException"><paramref name="loader"/> is null.</exception>
        /// <exception cref="InvalidOperationException">No volume is loaded.</exception>
        public static Bounds Of(VolumeLoader loader)
        {
            if (loader == null)
                throw new ArgumentNullException(nameof(loader));
            if (loader.Volume == null)
                throw new InvalidOperationException($"{loader.name}: no volume is loaded, so it has no bounds.");
            return VolumeBox.BoundsIn(loader.Volume.Geometry, loader.transform.localToWorldMatrix);
        }
    }
}
