using UnityEngine;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// The active sphere on the mouse. It begins when the mouse has moved a little, so that who only turns the wheel moves nothing; where depends on what is
    /// under the mouse then: the sphere itself is taken where it is, on the volume's surface it comes there, and beside both it keeps its distance.
    /// </summary>
    sealed class SphereDrag
    {
        const float ThresholdPixels = 3f;

        PlaneDrag drag;
        Vector2 pressedAt;
        Vector3 forward;
        bool isHeld, isDragging;

        /// <summary>Whether the sphere follows the mouse.</summary>
        public bool IsDragging => isDragging;

        /// <summary>The hold was begun or goes on.</summary>
        /// <param name="pixel">Where the mouse is.</param>
        /// <param name="view">The camera.</param>
        /// <param name="sphere">The sphere, which need not exist yet.</param>
        /// <param name="pointer">Finds the surface; may be null.</param>
        public void Follow(Vector2 pixel, Camera view, in WorldSphere sphere, SegmentPointer pointer)
        {
            if (!isHeld)
            {
                isHeld = true;
                pressedAt = pixel;
            }
            Ray mouse = view.ScreenPointToRay(pixel);
            if (!isDragging)
            {
                if ((pixel - pressedAt).sqrMagnitude >= ThresholdPixels * ThresholdPixels)
                    Begin(view, sphere, pointer, mouse);
                return;
            }
            // A view that turned has another plane; the sphere is taken anew where it is.
            if (view.transform.forward != forward)
                Take(mouse, view, sphere.Centre);
            else if (drag.TryMove(mouse, out Vector3 centre))
                sphere.MoveTo(centre);
        }

        /// <summary>The hold was let go.</summary>
        public void End() => isHeld = isDragging = false;

        void Begin(Camera view, in WorldSphere sphere, SegmentPointer pointer, Ray mouse)
        {
            // From where the mouse was when the hold began: what was under it then is what was meant, and stays under it.
            Ray begun = view.ScreenPointToRay(pressedAt);
            bool onSphere = sphere.TryEnter(begun, out float entry);
            bool onSurface = pointer != null && pointer.Point(begun).Hit;
            Vector3 surface = onSurface ? pointer.CurrentPosition : default;
            if (onSurface && !(onSphere && entry <= Vector3.Distance(begun.origin, surface)))
                sphere.MoveTo(surface);
            else if (!sphere.Exists)
                sphere.MoveTo(sphere.Centre);
            Take(begun, view, sphere.Centre);
            if (isDragging && drag.TryMove(mouse, out Vector3 centre))
                sphere.MoveTo(centre);
        }

        void Take(Ray mouse, Camera view, Vector3 centre)
        {
            forward = view.transform.forward;
            isDragging = PlaneDrag.TryBegin(mouse, forward, centre, out drag);
        }
    }
}
