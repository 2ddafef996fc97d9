using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>Where the mouse is in a camera's picture.</summary>
    static class PictureRay
    {
        /// <summary>Whether there is a mouse, and it is over the camera's part of the window.</summary>
        public static bool Contains(Camera camera, InputAction point) =>
            point.activeControl != null && camera.pixelRect.Contains(point.ReadValue<Vector2>());

        /// <summary>The ray from the camera through the mouse, in world space.</summary>
        public static Ray Of(Camera camera, InputAction point) => camera.ScreenPointToRay(point.ReadValue<Vector2>());
    }
}
