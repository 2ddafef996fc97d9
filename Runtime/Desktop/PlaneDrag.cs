using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// A point that is dragged by a ray in a plane parallel to the picture: what was grabbed stays under the mouse. Knows no camera and no mouse.
    /// </summary>
    public readonly struct PlaneDrag
    {
        readonly Plane plane;
        readonly Vector3 grip;

        PlaneDrag(Plane plane, Vector3 grip)
        {
            this.plane = plane;
            this.grip = grip;
        }

        /// <summary>Grabs a point's plane where the ray meets it; the point keeps its distance from there.</summary>
        /// <param name="mouse">The ray through the mouse.</param>
        /// <param name="forward">The direction that the picture is looked at in.</param>
        /// <param name="point">The point that is dragged.</param>
        /// <param name="drag">The drag.</param>
        /// <returns>False where the ray does not meet the plane: the point lies behind.</returns>
        public static bool TryBegin(Ray mouse, Vector3 forward, Vector3 point, out PlaneDrag drag)
        {
            var plane = new Plane(forward, point);
            bool meets = plane.Raycast(mouse, out float distance);
            drag = meets ? new PlaneDrag(plane, point - mouse.GetPoint(distance)) : default;
            return meets;
        }

        /// <summary>Where the point is now.</summary>
        /// <param name="mouse">The ray through the mouse.</param>
        /// <param name="point">The point.</param>
        /// <returns>False where the ray does not meet the plane.</returns>
        public bool TryMove(Ray mouse, out Vector3 point)
        {
            bool meets = plane.Raycast(mouse, out float distance);
            point = meets ? mouse.GetPoint(distance) + grip : default;
            return meets;
        }
    }
}
