using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>Raises a loader's events.</summary>
    static class LoadEvents
    {
        /// <summary>Tells listeners of a volume, as long as it is the one that is shown: one of them may set another, of which all are told then.</summary>
        /// <param name="listeners">The event; null = nobody listens.</param>
        /// <param name="volume">The volume; null = there is none to be told of.</param>
        /// <param name="isShown">Whether it still is.</param>
        public static void Raise(Action<SegmentedVolume> listeners, SegmentedVolume volume, Func<bool> isShown)
        {
            if (listeners == null || volume == null)
                return;
            foreach (Delegate listener in listeners.GetInvocationList())
                if (isShown())
                    ((Action<SegmentedVolume>)listener)(volume);
        }
    }
}
