using System.Text;
using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>What a user is told: which keys and buttons do what, as they are bound at the moment.</summary>
    public static class DesktopHints
    {
        static readonly (string action, string does)[] Lines =
        {
            ("Orbit", "drag: turn the view"),
            ("Pan", "drag: slide the view"),
            ("Zoom", "come nearer"),
            ("Turn", "turn the view"),
            ("Slide", "slide the view"),
            ("Approach", "go away, come nearer"),
            ("Reset View", "view as at first"),
            ("Hold Sphere", "hold: the sphere follows the mouse"),
            ("Resize Sphere", "resize the sphere"),
            ("Move Sphere", "move the sphere"),
            ("Push Sphere", "pull, push the sphere"),
            ("Grow Sphere", "shrink, grow the sphere"),
            ("Toggle Segment", "cut the structure, or leave it whole"),
            ("Fix Sphere", "fix the sphere, take a new one"),
            ("Remove Sphere", "remove the last fixed sphere"),
            ("Reset Mask", "cut all, or none"),
            ("Undo", "undo"),
            ("Redo", "redo"),
            ("Toggle Hints", "hide, show these hints"),
        };

        // Composites of the package's asset that only one platform's users need to know say so by their group.
        static readonly InputBinding Everywhere = InputBinding.MaskByGroup("Keyboard and Mouse");
        static readonly InputBinding OnMacOS = InputBinding.MaskByGroups("Keyboard and Mouse", "macOS");

        /// <summary>A line for each action that is bound to anything: its keys and buttons, a tab, and what it does.</summary>
        /// <param name="controls">An asset with the map 'Desktop'; null = the package's own.</param>
        /// <returns>The lines; empty where there is no such asset or map.</returns>
        public static string Describe(InputActionAsset controls = null)
        {
            AnatomyCarveDesktop shared = controls == null ? AnatomyCarveDesktop.Load() : null;
            InputActionAsset asset = shared != null ? shared.Controls : controls;
            InputActionMap map = asset != null ? asset.FindActionMap(ControlSet.MapName) : null;
            var text = new StringBuilder();
            foreach ((string action, string does) in Lines)
                if (map?.FindAction(action) is InputAction found && Keys(found) is string keys && keys.Length > 0)
                    text.Append(keys).Append('\t').Append(does).Append('\n');
            return text.ToString().TrimEnd();
        }

        /// <summary>An asset of somebody else's may have other groups, or none: then all of its bindings are told.</summary>
        static string Keys(InputAction action)
        {
            bool isMacOS = Application.platform == RuntimePlatform.OSXPlayer || Application.platform == RuntimePlatform.OSXEditor;
            string ours = action.GetBindingDisplayString(isMacOS ? OnMacOS : Everywhere);
            return ours.Length > 0 ? ours : action.GetBindingDisplayString();
        }
    }
}
