using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.InputSystem;

namespace AnatomyCarve.Desktop
{
    /// <summary>
    /// The actions that one component uses, found by name in the map <see cref="MapName"/> of its asset. Whatever is missing is said in one sentence;
    /// the component is not to run then.
    /// </summary>
    sealed class ControlSet
    {
        /// <summary>The name of the action map.</summary>
        public const string MapName = "Desktop";

        // What an asset may call a control of that kind; without an expectation any control may be bound.
        static readonly string[] Buttons = { "Button", "Key", "Axis", "" };
        static readonly string[] Axes = { "Axis", "Analog", "Button", "" };
        static readonly string[] Vectors = { "Vector2", "Delta", "Stick", "Dpad", "" };

        readonly MonoBehaviour user;
        readonly AnatomyCarveDesktop shared;
        readonly InputActionAsset asset;
        readonly InputActionMap map;
        readonly List<string> problems = new List<string>();
        bool enabled;

        /// <summary>Looks the map up.</summary>
        /// <param name="wired">The component's own asset; null = the package's.</param>
        /// <param name="user">The component, which messages name.</param>
        public ControlSet(InputActionAsset wired, MonoBehaviour user)
        {
            this.user = user;
#if !ENABLE_INPUT_SYSTEM
            problems.Add("the project uses the old Input Manager (Project Settings > Player > Active Input Handling: Input System Package or Both)");
#endif
            shared = AnatomyCarveDesktop.Load();
            if (shared == null)
            {
                problems.Add("the package's asset 'AnatomyCarveDesktop' is not part of this build");
                return;
            }
            asset = wired != null ? wired : shared.Controls;
            map = asset != null ? asset.FindActionMap(MapName) : null;
            if (map == null)
                problems.Add($"there is no action map '{MapName}'");
        }

        /// <summary>An action that is pressed and released.</summary>
        public InputAction Button(string name) => Find(name, "Button", Buttons);

        /// <summary>An action with a number.</summary>
        public InputAction Axis(string name) => Find(name, "Axis", Axes);

        /// <summary>An action with two numbers.</summary>
        public InputAction Vector2(string name) => Find(name, "Vector2", Vectors);

        /// <summary>Enables the map, once all actions are there.</summary>
        /// <returns>Whether they are; if not, an error says what is missing.</returns>
        public bool Enable()
        {
            if (problems.Count > 0)
            {
                string from = asset != null ? $"the input actions '{asset.name}'" : "its input actions";
                Debug.LogError($"{user.GetType().Name} on '{user.name}' cannot use {from} and is disabled: {string.Join("; ", problems)}.", user);
                return false;
            }
            shared.Enable(map);
            enabled = true;
            return true;
        }

        /// <summary>Lets the map go; for another user it stays enabled. Once is enough, more do no harm.</summary>
        public void Release()
        {
            if (enabled)
                shared.Release(map);
            enabled = false;
        }

        InputAction Find(string name, string kind, string[] accepted)
        {
            InputAction action = map?.FindAction(name);
            if (map != null && action == null)
                problems.Add($"there is no action '{MapName}/{name}' ({kind})");
            else if (action != null && Array.IndexOf(accepted, action.expectedControlType ?? "") < 0)
                problems.Add($"the action '{MapName}/{name}' is for controls of the kind {action.expectedControlType}, not {kind}");
            return action;
        }
    }
}
