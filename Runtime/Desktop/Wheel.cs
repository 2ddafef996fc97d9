using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>What a mouse wheel turned.</summary>
    static class Wheel
    {
        // What Windows reports for a notch, where the project's input settings leave that as it is.
        const float WindowsNotch = 120f;

        // Some drivers report a fast turn as hundreds of notches at once.
        const float MostPerFrame = 10f;

        /// <summary>Notches in this frame, up positive; fractions from touch pads.</summary>
        public static float Notches(InputAction wheel) => Notches(
            wheel.ReadValue<float>(),
            InputSystem.settings.scrollDeltaBehavior == InputSettings.ScrollDeltaBehavior.KeepPlatformSpecificInputRange
            && (Application.platform == RuntimePlatform.WindowsPlayer || Application.platform == RuntimePlatform.WindowsEditor));

        internal static float Notches(float reported, bool isWindowsRange) =>
            Mathf.Clamp(isWindowsRange ? reported / WindowsNotch : reported, -MostPerFrame, MostPerFrame);
    }
}
