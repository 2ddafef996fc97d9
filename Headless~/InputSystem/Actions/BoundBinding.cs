using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.InputSystem
{
    /// <summary>A binding with the controls that it means now.</summary>
    sealed class BoundBinding
    {
        internal BoundBinding(ActionMapState map, InputBinding source, InputAction action)
        {
            Map = map;
            Source = source;
            Action = action;
        }

        internal ActionMapState Map { get; }

        internal InputBinding Source { get; }

        /// <summary>Null if no action of the map is called so.</summary>
        internal InputAction Action { get; }

        internal List<BoundControl> Controls { get; } = new();

        internal InputProcessor[] Processors { get; set; } = Array.Empty<InputProcessor>();

        /// <summary>Of a part: the composite that it is part of, and its number in that.</summary>
        internal BoundBinding Composite { get; set; }

        /// <inheritdoc cref="Composite"/>
        internal int PartNumber { get; set; }

        /// <summary>Of a composite: what makes one value of its parts'.</summary>
        internal InputBindingComposite Instance { get; set; }

        /// <inheritdoc cref="Instance"/>
        internal List<BoundBinding> Parts { get; } = new();

        /// <inheritdoc cref="Instance"/>
        internal float CompositeMagnitude { get; set; }

        /// <summary>Of a composite: the event that it was evaluated for last, which may change several of its parts.</summary>
        internal int LastEventId { get; set; }

        /// <summary>When a control of it was pressed; 0 while none is.</summary>
        internal double PressTime { get; set; }

        /// <summary>Whether the next update looks at what its controls are doing already.</summary>
        internal bool IsCheckPending { get; set; }

        internal bool IsComposite => Instance != null;

        /// <summary>Those that drive the action: of a composite, its parts'.</summary>
        internal IEnumerable<BoundControl> DrivingControls => IsComposite ? Parts.SelectMany(p => p.Controls) : Controls;

        internal TValue Process<TValue>(TValue value, InputControl control) where TValue : struct
        {
            foreach (var processor in Processors)
                if (processor is InputProcessor<TValue> typed)
                    value = typed.Process(value, control);
            return value;
        }
    }

    /// <summary>A control that a binding means.</summary>
    sealed class BoundControl
    {
        internal BoundControl(BoundBinding binding, InputControl control)
        {
            Binding = binding;
            Control = control;
        }

        internal BoundBinding Binding { get; }

        internal InputControl Control { get; }

        /// <summary>As of the last change that the action was told of.</summary>
        internal float Magnitude { get; set; }

        /// <summary>Whether changes are told.</summary>
        internal bool IsEnabled { get; private set; }

        internal void Enable()
        {
            if (IsEnabled)
                return;
            IsEnabled = true;
            Control.device.AddMonitor(this);
        }

        internal void Disable()
        {
            if (!IsEnabled)
                return;
            IsEnabled = false;
            Control.device.RemoveMonitor(this);
        }

        internal float PressPoint => Control is Controls.ButtonControl button ? button.pressPointOrDefault : Controls.ButtonControl.DefaultPressPoint;
    }
}
