using System;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>What a loader is told to load, and loading it from the Inspector.</summary>
    static class LoaderSource
    {
        /// <summary>Whether it is told anything.</summary>
        public static bool IsNamed(VolumeLoader loader) => loader.Asset != null || loader.IntensityPath.Length > 0;

        /// <summary>Loads it, in Play or outside. What goes wrong is logged, and told by the loader to who listens.</summary>
        public static async void Load(VolumeLoader loader)
        {
            try
            {
                if (loader.Asset != null)
                    await loader.LoadAsync(loader.Asset);
                else
                    await loader.LoadAsync(loader.IntensityPath, loader.LabelsPath);
            }
            catch (OperationCanceledException)
            {
                // Another load took its place, or it was cancelled.
            }
            catch (Exception e)
            {
                Debug.LogException(e, loader);
            }
            EditorViews.Refresh();
        }
    }
}
