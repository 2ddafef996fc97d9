using System;
using System.Collections.Generic;
using UnityEngine.InputSystem.Controls;

namespace UnityEngine.InputSystem
{
    /// <summary>Questions that one asks of any control.</summary>
    public static unsafe class InputControlExtensions
    {
        /// <param name="control">A button, or anything with a magnitude.</param>
        /// <param name="buttonPressPoint">Where no button's own press point counts; 0 = the settings' default.</param>
        public static bool IsPressed(this InputControl control, float buttonPressPoint = 0)
        {
            if (control == null)
                throw new ArgumentNullException(nameof(control));
            if (Mathf.Approximately(0, buttonPressPoint))
                buttonPressPoint = control is ButtonControl button ? button.pressPointOrDefault : ButtonControl.DefaultPressPoint;
            return control.IsActuated(buttonPressPoint);
        }

        public static bool IsActuated(this InputControl control, float threshold = 0)
        {
            if (control.CheckStateIsAtDefault())
                return false;
            var magnitude = control.magnitude;
            return magnitude < 0 || (Mathf.Approximately(threshold, 0) ? magnitude > 0 : magnitude >= threshold);
        }

        public static object ReadValueAsObject(this InputControl control)
        {
            if (control == null)
                throw new ArgumentNullException(nameof(control));
            return control.ReadValueFromStateAsObject(control.StateNow);
        }

        /// <summary>Whether its part of the device's memory is as at rest.</summary>
        public static bool CheckStateIsAtDefault(this InputControl control)
        {
            if (control == null)
                throw new ArgumentNullException(nameof(control));
            return control.IsAtDefault;
        }

        public static void FindControlsRecursive<TControl>(this InputControl parent, IList<TControl> controls, Func<TControl, bool> predicate)
            where TControl : InputControl
        {
            if (parent == null)
                throw new ArgumentNullException(nameof(parent));
            if (controls == null)
                throw new ArgumentNullException(nameof(controls));
            if (predicate == null)
                throw new ArgumentNullException(nameof(predicate));
            if (parent is TControl match && predicate(match))
                controls.Add(match);
            foreach (var child in parent.m_Children)
                FindControlsRecursive(child, controls, predicate);
        }
    }
}
