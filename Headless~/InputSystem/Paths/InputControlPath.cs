using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.InputSystem
{
    /// <summary>
    /// Texts that say which controls are meant, such as <c>&lt;Mouse&gt;/leftButton</c> or <c>&lt;XRController&gt;{LeftHand}/{PrimaryButton}</c>: the first
    /// part is the device, each further one goes a level down.
    /// </summary>
    public static class InputControlPath
    {
        public const string Wildcard = "*";

        public const string DoubleWildcard = "**";

        public const char Separator = '/';

        /// <summary>What <see cref="ToHumanReadableString(string,HumanReadableStringOptions,InputControl)"/> leaves out.</summary>
        [Flags]
        public enum HumanReadableStringOptions
        {
            None = 0,
            OmitDevice = 1 << 1,
            UseShortNames = 1 << 2,
        }

        /// <summary>The path of a child that is called <paramref name="path"/>.</summary>
        public static string Combine(InputControl parent, string path)
        {
            if (parent == null)
                return string.IsNullOrEmpty(path) ? "" : path[0] == Separator ? path : Separator + path;
            return string.IsNullOrEmpty(path) ? parent.path : $"{parent.path}/{path}";
        }

        /// <summary>Whether a control is among those that a path means.</summary>
        public static bool Matches(string expected, InputControl control)
        {
            if (string.IsNullOrEmpty(expected))
                throw new ArgumentNullException(nameof(expected));
            if (control == null)
                throw new ArgumentNullException(nameof(control));
            return Find(control.device, PathComponent.Parse(expected)).Contains(control);
        }

        /// <summary>The first control that a path means, seen from a control: its first part is the control itself.</summary>
        /// <returns>Null where there is none.</returns>
        public static InputControl TryFindControl(InputControl control, string path, int indexInPath = 0)
        {
            if (control == null)
                throw new ArgumentNullException(nameof(control));
            return string.IsNullOrEmpty(path) ? null : Find(control, PathComponent.Parse(path.Substring(indexInPath))).FirstOrDefault();
        }

        public static TControl TryFindControl<TControl>(InputControl control, string path, int indexInPath = 0) where TControl : InputControl =>
            TryFindControl(control, path, indexInPath) as TControl;

        /// <summary>All controls that a path means, seen from a control.</summary>
        public static InputControl[] TryFindControls(InputControl control, string path, int indexInPath = 0)
        {
            if (control == null)
                throw new ArgumentNullException(nameof(control));
            if (path == null)
                throw new ArgumentNullException(nameof(path));
            return Find(control, PathComponent.Parse(path.Substring(indexInPath))).ToArray();
        }

        /// <summary>The first control below one that a path means: its first part is a child.</summary>
        public static InputControl TryFindChild(InputControl control, string path, int indexInPath = 0)
        {
            if (control == null)
                throw new ArgumentNullException(nameof(control));
            if (path == null)
                throw new ArgumentNullException(nameof(path));
            var components = PathComponent.Parse(path.Substring(indexInPath));
            foreach (var child in control.m_Children)
                if (Find(child, components).FirstOrDefault() is { } found)
                    return found;
            return null;
        }

        public static TControl TryFindChild<TControl>(InputControl control, string path, int indexInPath = 0) where TControl : InputControl =>
            TryFindChild(control, path, indexInPath) as TControl;

        /// <summary>The layout in the first part of a path; null where it says none.</summary>
        public static string TryGetDeviceLayout(string path)
        {
            if (path == null)
                throw new ArgumentNullException(nameof(path));
            var device = PathComponent.Parse(path)[0];
            return device.Layout ?? (device.IsWildcard ? Wildcard : null);
        }

        /// <summary>The usages in the first part of a path; null where it says none.</summary>
        public static string[] TryGetDeviceUsages(string path)
        {
            if (path == null)
                throw new ArgumentNullException(nameof(path));
            var usages = PathComponent.Parse(path)[0].Usages;
            return usages.Count > 0 ? usages.ToArray() : null;
        }

        public static string ToHumanReadableString(
            string path, HumanReadableStringOptions options = HumanReadableStringOptions.None, InputControl control = null) =>
            ToHumanReadableString(path, out _, out _, options, control);

        /// <summary>What people call the control that a path means: "Left Button [Mouse]". Where no control is given, the layouts tell.</summary>
        public static string ToHumanReadableString(
            string path, out string deviceLayoutName, out string controlPath,
            HumanReadableStringOptions options = HumanReadableStringOptions.None, InputControl control = null)
        {
            deviceLayoutName = null;
            controlPath = null;
            if (string.IsNullOrEmpty(path))
                return "";
            var omitsDevice = (options & HumanReadableStringOptions.OmitDevice) != 0;
            if (control != null && Matches(path, control))
            {
                deviceLayoutName = control.device.layout;
                controlPath = control is InputDevice ? null : control.path.Substring(control.device.path.Length + 1);
                var shortName = (options & HumanReadableStringOptions.UseShortNames) != 0 ? control.shortDisplayName : null;
                return (shortName ?? control.displayName) + (omitsDevice ? "" : $" [{control.device.displayName}]");
            }

            return LayoutPath.ToHumanReadableString(PathComponent.Parse(path), options, out deviceLayoutName, out controlPath) is { Length: > 0 } text
                ? text
                : path;
        }

        /// <summary>All controls of all devices that a path means.</summary>
        internal static IEnumerable<InputControl> FindIn(IEnumerable<InputDevice> devices, string path)
        {
            var components = PathComponent.Parse(path);
            return devices.SelectMany(d => Find(d, components));
        }

        static IEnumerable<InputControl> Find(InputControl control, List<PathComponent> components) => Find(control, components, 0);

        static IEnumerable<InputControl> Find(InputControl control, List<PathComponent> components, int index)
        {
            if (!components[index].Matches(control))
                return Enumerable.Empty<InputControl>();
            if (index == components.Count - 1)
                return new[] { control };
            // A usage alone is looked for at any depth of a device.
            var next = components[index + 1];
            var candidates = control is InputDevice device && next.IsUsageOnly ? device.allControls.ToArray() : control.m_Children;
            return candidates.SelectMany(c => Find(c, components, index + 1));
        }
    }
}
