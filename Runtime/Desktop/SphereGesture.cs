using AnatomyCarve.Carving;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// Moves of the active sphere from when something is held until it is let go: one step to undo. Ends with the carving that it began with, whatever
    /// volume is loaded by then.
    /// </summary>
    sealed class SphereGesture
    {
        CarvingStack carving;

        /// <summary>Begins or goes on, or ends.</summary>
        /// <param name="held">Whether anything is held.</param>
        /// <param name="current">The carving that moves go to; null = none.</param>
        public void Follow(bool held, CarvingStack current)
        {
            if (carving != null && (!held || carving != current))
                End();
            if (carving != null || !held || current == null)
                return;
            carving = current;
            carving.BeginGesture();
        }

        /// <summary>Ends if it is going on.</summary>
        public void End()
        {
            carving?.EndGesture();
            carving = null;
        }
    }
}
