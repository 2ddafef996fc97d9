using System;
using System.Collections.Generic;
using UnityEngine.InputSystem.Controls;

namespace UnityEngine.InputSystem
{
    /// <summary>What a composite may ask of its parts.</summary>
    public unsafe struct InputBindingCompositeContext
    {
        readonly BoundBinding m_Composite;

        internal InputBindingCompositeContext(BoundBinding composite) => m_Composite = composite;

        public IEnumerable<PartBinding> controls
        {
            get
            {
                foreach (var part in m_Composite.Parts)
                    foreach (var control in part.Controls)
                        yield return new PartBinding { part = part.PartNumber, control = control.Control };
            }
        }

        /// <summary>The highest magnitude of a part's controls.</summary>
        public float EvaluateMagnitude(int partNumber)
        {
            var highest = float.MinValue;
            foreach (var part in m_Composite.Parts)
                if (part.PartNumber == partNumber)
                    foreach (var control in part.Controls)
                        highest = Mathf.Max(control.Control.magnitude, highest);
            return highest;
        }

        /// <summary>The greatest value of a part's controls.</summary>
        public TValue ReadValue<TValue>(int partNumber) where TValue : struct, IComparable<TValue> => Greatest<TValue>(partNumber, out _);

        /// <summary>Whether the part's control with the greatest value is pressed.</summary>
        public bool ReadValueAsButton(int partNumber)
        {
            if (m_Composite == null)
                return false;
            var value = Greatest<float>(partNumber, out var source);
            return source is ButtonControl button ? button.isPressed : value >= ButtonControl.DefaultPressPoint;
        }

        /// <summary>The value of the part's most actuated control.</summary>
        public void ReadValue(int partNumber, void* buffer, int bufferSize)
        {
            if (MostActuated(partNumber) is { } control)
                BindingValues.ReadControl(control, buffer, bufferSize);
        }

        /// <inheritdoc cref="ReadValue(int,void*,int)"/>
        public object ReadValueAsObject(int partNumber) =>
            MostActuated(partNumber) is { } control ? BindingValues.ReadControlAsObject(control) : null;

        /// <summary>When the part was pressed; -1 if it is not.</summary>
        public double GetPressTime(int partNumber)
        {
            var first = double.MaxValue;
            foreach (var part in m_Composite.Parts)
                if (part.PartNumber == partNumber && part.PressTime != 0 && part.PressTime < first)
                    first = part.PressTime;
            return first == double.MaxValue ? -1 : first;
        }

        TValue Greatest<TValue>(int partNumber, out InputControl source) where TValue : struct, IComparable<TValue>
        {
            source = null;
            var greatest = default(TValue);
            foreach (var part in m_Composite.Parts)
            {
                if (part.PartNumber != partNumber)
                    continue;
                foreach (var control in part.Controls)
                {
                    var value = BindingValues.ReadControl<TValue>(control, part.Action);
                    if (source != null && value.CompareTo(greatest) <= 0)
                        continue;
                    greatest = value;
                    source = control.Control;
                }
            }

            return greatest;
        }

        BoundControl MostActuated(int partNumber)
        {
            BoundControl most = null;
            var highest = float.MinValue;
            foreach (var part in m_Composite.Parts)
            {
                if (part.PartNumber != partNumber)
                    continue;
                foreach (var control in part.Controls)
                {
                    var magnitude = control.Control.magnitude;
                    if (magnitude < highest)
                        continue;
                    most = control;
                    highest = magnitude;
                }
            }

            return most;
        }

        /// <summary>A control of a part.</summary>
        public struct PartBinding
        {
            public int part { get; set; }

            public InputControl control { get; set; }
        }
    }
}
