using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>What mouse and keys do to an orbit.</summary>
    sealed class OrbitControls
    {
        // Distances that a key slides, and by which it comes nearer, in a second: shares of the picture's height and of the distance.
        const float SlidePerSecond = 0.5f, ApproachPerSecond = 1f;

        readonly ControlSet set;
        readonly InputAction orbit, pan, drag, zoom, turn, slide, approach, reset, holdSphere, point;
        bool orbits, pans;

        public OrbitControls(InputActionAsset controls, MonoBehaviour user)
        {
            set = new ControlSet(controls, user);
            orbit = set.Button("Orbit");
            pan = set.Button("Pan");
            drag = set.Vector2("Drag");
            zoom = set.Axis("Zoom");
            turn = set.Vector2("Turn");
            slide = set.Vector2("Slide");
            approach = set.Axis("Approach");
            reset = set.Button("Reset View");
            holdSphere = set.Button("Hold Sphere");
            point = set.Vector2("Point");
        }

        public bool Enable() => set.Enable();

        public void Release()
        {
            orbits = pans = false;
            set.Release();
        }

        /// <summary>Takes one frame's input in.</summary>
        public void Apply(Orbit view, Camera camera, InputGate gate, float seconds, float degreesPerHeight, float zoomPerNotch, float degreesPerSecond)
        {
            bool pointerIsOurs = PictureRay.Contains(camera, point) && !InputGate.IsPointerBlocked(gate);
            orbits = Goes(orbits, orbit, pointerIsOurs);
            pans = Goes(pans, pan, pointerIsOurs);
            Drag(view, camera, degreesPerHeight);
            // While the sphere is held, the wheel is the sphere's.
            if (pointerIsOurs && !holdSphere.IsPressed())
                view.Scale(Mathf.Exp(-zoomPerNotch * Wheel.Notches(zoom)));
            if (InputGate.AreKeysBlocked(gate))
                return;
            Keys(view, camera, Mathf.Min(seconds, PictureRay.LongestFrame), degreesPerSecond);
            if (reset.WasPerformedThisFrame())
                view.GoHome();
        }

        void Drag(Orbit view, Camera camera, float degreesPerHeight)
        {
            if (!orbits && !pans)
                return;
            Vector2 moved = drag.ReadValue<Vector2>() / Mathf.Max(1, camera.pixelHeight);
            if (pans)
            {
                float height = PictureRay.PerspectiveHeight(camera, view.Goal.Distance);
                view.Slide(-moved.x * height, -moved.y * height);
            }
            else
            {
                view.Turn(moved.x * degreesPerHeight, -moved.y * degreesPerHeight);
            }
        }

        void Keys(Orbit view, Camera camera, float seconds, float degreesPerSecond)
        {
            Vector2 turned = turn.ReadValue<Vector2>() * (degreesPerSecond * seconds);
            if (turned != Vector2.zero)
                view.Turn(-turned.x, turned.y);
            Vector2 slid = slide.ReadValue<Vector2>() * (SlidePerSecond * seconds * PictureRay.PerspectiveHeight(camera, view.Goal.Distance));
            if (slid != Vector2.zero)
                view.Slide(slid.x, slid.y);
            view.Scale(Mathf.Exp(-ApproachPerSecond * seconds * approach.ReadValue<float>()));
        }

        /// <summary>A drag begins where the mouse is ours, and goes on wherever it gets to until its button is released.</summary>
        static bool Goes(bool going, InputAction button, bool mayBegin) =>
            going ? button.IsPressed() : mayBegin && button.WasPressedThisFrame();
    }
}
