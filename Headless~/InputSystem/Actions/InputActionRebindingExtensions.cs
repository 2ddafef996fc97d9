using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>What users see of bindings, and other bindings than the file's.</summary>
    public static class InputActionRebindingExtensions
    {
        /// <summary>An action's bindings as people call them, with " | " between them: "Left Control+Z | F".</summary>
        public static string GetBindingDisplayString(this InputAction action, InputBinding.DisplayStringOptions options = default, string group = null)
        {
            if (action == null)
                throw new ArgumentNullException(nameof(action));
            var mask = !string.IsNullOrEmpty(group) ? InputBinding.MaskByGroup(group)
                : action.m_BindingMask ?? action.actionMap?.bindingMask ?? (action.actionMap?.asset != null ? action.actionMap.asset.bindingMask : null);
            return GetBindingDisplayString(action, mask ?? default, options);
        }

        public static string GetBindingDisplayString(this InputAction action, InputBinding bindingMask, InputBinding.DisplayStringOptions options = default)
        {
            if (action == null)
                throw new ArgumentNullException(nameof(action));
            var bindings = action.bindings;
            var texts = new List<string>();
            for (var i = 0; i < bindings.Count; i++)
                if (!bindings[i].isPartOfComposite && bindingMask.Matches(bindings[i]))
                    texts.Add(action.GetBindingDisplayString(i, options));
            return string.Join(" | ", texts);
        }

        public static string GetBindingDisplayString(this InputAction action, int bindingIndex, InputBinding.DisplayStringOptions options = default) =>
            action.GetBindingDisplayString(bindingIndex, out _, out _, options);

        public static string GetBindingDisplayString(
            this InputAction action, int bindingIndex, out string deviceLayoutName, out string controlPath,
            InputBinding.DisplayStringOptions options = default)
        {
            if (action == null)
                throw new ArgumentNullException(nameof(action));
            deviceLayoutName = null;
            controlPath = null;
            var bindings = action.bindings;
            if (bindingIndex < 0 || bindingIndex >= bindings.Count)
                throw new ArgumentOutOfRangeException(nameof(bindingIndex),
                    $"Binding index {bindingIndex} is out of range on action '{action}' with {bindings.Count} bindings");
            if (bindings[bindingIndex].isComposite)
                return CompositeText(action, bindings, bindingIndex, options);
            var bound = action.MapInUse.ResolvedState.Bindings[action.MapInUse.IndexOf(action, bindingIndex)];
            return bindings[bindingIndex].ToDisplayString(out deviceLayoutName, out controlPath, options, bound.Controls.FirstOrDefault()?.Control);
        }

        /// <summary>Another path for a binding, until it is removed.</summary>
        public static void ApplyBindingOverride(this InputAction action, int bindingIndex, string path)
        {
            if (path == null)
                throw new ArgumentException("Binding path cannot be null", nameof(path));
            Override(action, bindingIndex, path);
        }

        public static void RemoveBindingOverride(this InputAction action, int bindingIndex) => Override(action, bindingIndex, null);

        static void Override(InputAction action, int bindingIndex, string path)
        {
            if (action == null)
                throw new ArgumentNullException(nameof(action));
            var map = action.MapInUse;
            map.m_Bindings[map.IndexOf(action, bindingIndex)].overridePath = path;
            map.ForgetResolution();
        }

        /// <summary>The composite class says how its parts are put together.</summary>
        static string CompositeText(InputAction action, ReadOnlyArray<InputBinding> bindings, int bindingIndex, InputBinding.DisplayStringOptions options)
        {
            var parts = new List<(string Name, string Text)>();
            for (var i = bindingIndex + 1; i < bindings.Count && bindings[i].isPartOfComposite; i++)
                parts.Add((bindings[i].name, action.GetBindingDisplayString(i, options) is { Length: > 0 } text ? text : " "));
            var type = InputManager.Instance.Layouts.Composite(NameWithParameters.Parse(bindings[bindingIndex].effectivePath).Name);
            var format = type?.GetCustomAttribute<DisplayStringFormatAttribute>()?.formatString;
            if (string.IsNullOrEmpty(format))
                return string.Join("/", parts.Select(p => p.Text));
            return Regex.Replace(format, @"\{(\w+)\}", match =>
            {
                var texts = parts.Where(p => string.Equals(p.Name, match.Groups[1].Value, StringComparison.OrdinalIgnoreCase)).Select(p => p.Text);
                return string.Join("|", texts) is { Length: > 0 } text ? text : " ";
            });
        }
    }
}
