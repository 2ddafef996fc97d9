namespace UnityEngine.InputSystem.LowLevel
{
    /// <summary>Time and count of the updates.</summary>
    public static class InputState
    {
        /// <summary>The kind of the update that runs or ran last.</summary>
        public static InputUpdateType currentUpdateType => InputManager.Instance.UpdateType;

        /// <summary>Grows by one with each update.</summary>
        public static uint updateCount => InputManager.Instance.UpdateStep;

        /// <summary>Seconds since the start, which events are stamped with. On the host that is the time of the frames, so that runs repeat.</summary>
        public static double currentTime => Time.unscaledTimeAsDouble;
    }
}
