using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>What mouse and keys say about the active sphere.</summary>
    sealed class SphereControls
    {
        readonly ControlSet set;
        readonly InputAction resize, move, push, grow, fix, remove, resetMask, undo, redo;

        public SphereControls(InputActionAsset controls, MonoBehaviour user)
        {
            set = new ControlSet(controls, user);
            Point = set.Vector2("Point");
            Hold = set.Button("Hold Sphere");
            resize = set.Axis("Resize Sphere");
            move = set.Vector2("Move Sphere");
            push = set.Axis("Push Sphere");
            grow = set.Axis("Grow Sphere");
            fix = set.Button("Fix Sphere");
            remove = set.Button("Remove Sphere");
            resetMask = set.Button("Reset Mask");
            undo = set.Button("Undo");
            redo = set.Button("Redo");
        }

        /// <summary>Where the mouse is, in pixels.</summary>
        public InputAction Point { get; }

        /// <summary>Held while the sphere follows the mouse.</summary>
        public InputAction Hold { get; }

        /// <summary>Notches that the wheel turned for the sphere.</summary>
        public float ResizeNotches => Wheel.Notches(resize);

        /// <summary>Where the keys move it: to the picture's right and upper edge, and away; each -1 to 1.</summary>
        public Vector3 Motion
        {
            get
            {
                Vector2 plane = move.ReadValue<Vector2>();
                return new Vector3(plane.x, plane.y, push.ReadValue<float>());
            }
        }

        /// <summary>How the keys resize it, -1 to 1.</summary>
        public float Growth => grow.ReadValue<float>();

        public bool Enable() => set.Enable();

        public void Release() => set.Release();

        /// <summary>Does what was pressed in this frame.</summary>
        public void Edit(ClipSphereStack stack)
        {
            if (fix.WasPerformedThisFrame() && stack.Carving.Active is object)
                stack.FixActive();
            if (remove.WasPerformedThisFrame())
                stack.RemoveLast();
            if (resetMask.WasPerformedThisFrame())
                stack.ResetMask();
            // Ctrl+Shift+Z is Ctrl+Z too.
            if (redo.WasPerformedThisFrame())
                stack.Redo();
            else if (undo.WasPerformedThisFrame())
                stack.Undo();
        }
    }
}
