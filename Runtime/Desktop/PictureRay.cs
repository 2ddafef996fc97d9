using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>A camera's picture: where the mouse is in it, and how large things are in it.</summary>
    static class PictureRay
    {
        /// <summary>A frame that took longer, as the first one does, moves no further than this many seconds.</summary>
        public const float LongestFrame = 0.1f;

        /// <summary>Whether there is a mouse, and it is over the camera's part of the window.</summary>
        public static bool Contains(Camera camera, InputAction point) =>
            point.activeControl != null && camera.pixelRect.Contains(point.ReadValue<Vector2>());

        /// <summary>The ray from the camera through the mouse, in world space.</summary>
        public static Ray Of(Camera camera, InputAction point) => camera.ScreenPointToRay(point.ReadValue<Vector2>());

        /// <summary>The height of a perspective picture at a distance along the view, in world units.</summary>
        public static float PerspectiveHeight(Camera camera, float distance) => 2f * distance * Mathf.Tan(0.5f * camera.fieldOfView * Mathf.Deg2Rad);

        /// <summary>The picture's height at a distance along the view, in world units.</summary>
        public static float Height(Camera camera, float distance) =>
            camera.orthographic ? 2f * camera.orthographicSize : PerspectiveHeight(camera, distance);
    }
}
