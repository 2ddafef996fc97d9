using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.InputSystem
{
    /// <summary>What people call the control that a path means, told by the layouts alone: there may be no such device.</summary>
    static class LayoutPath
    {
        /// <returns>Empty where nothing can be told.</returns>
        internal static string ToHumanReadableString(
            List<PathComponent> components, InputControlPath.HumanReadableStringOptions options, out string deviceLayout, out string controlPath)
        {
            var layouts = InputManager.Instance.Layouts;
            deviceLayout = components[0].Layout;
            controlPath = null;
            var layout = deviceLayout != null && layouts.Has(deviceLayout) ? layouts.Layout(deviceLayout) : null;
            var device = Device(components[0], layout);
            var names = new List<string>();
            var path = new List<string>();
            foreach (var component in components.Skip(1))
            {
                var item = layout?.Items.Find(i => Means(component, i));
                names.Add(Name(component, item, options));
                path.Add(item?.Name ?? component.Name ?? "");
                layout = item?.Layout != null && layouts.Has(item.Layout) ? layouts.Layout(item.Layout) : null;
            }

            controlPath = path.Count > 0 ? string.Join("/", path) : null;
            var text = string.Join("/", names);
            var omitsDevice = (options & InputControlPath.HumanReadableStringOptions.OmitDevice) != 0;
            return omitsDevice || device.Length == 0 ? text : text.Length == 0 ? $" [{device}]" : $"{text} [{device}]";
        }

        static bool Means(PathComponent component, ControlLayout.Item item)
        {
            bool Same(string a, string b) => string.Equals(a, b, StringComparison.OrdinalIgnoreCase);
            if (component.Usages.Count > 0 && (item.Usages == null || !component.Usages.All(u => item.Usages.Any(i => Same(i, u)))))
                return false;
            return component.Name == null || Same(component.Name, item.Name) || (item.Aliases?.Any(a => Same(a, component.Name)) ?? false);
        }

        static string Device(PathComponent component, ControlLayout layout)
        {
            var usages = string.Join(" & ", component.Usages);
            var name = component.Layout == null ? component.IsWildcard ? "Any" : component.Name ?? "" : layout?.DisplayName ?? component.Layout;
            return usages.Length == 0 ? name : $"{usages} {name}".Trim();
        }

        static string Name(PathComponent component, ControlLayout.Item item, InputControlPath.HumanReadableStringOptions options)
        {
            if (item != null && (options & InputControlPath.HumanReadableStringOptions.UseShortNames) != 0 && !string.IsNullOrEmpty(item.ShortDisplayName))
                return item.ShortDisplayName;
            var usages = string.Join(" & ", component.Usages);
            var name = item?.DisplayName ?? component.DisplayName ?? (component.Name == null ? usages : component.Name);
            return component.Usages.Count > 0 && component.Name != null ? $"{usages} {name}" : name;
        }
    }
}
