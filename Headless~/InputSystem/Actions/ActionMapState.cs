using System.Collections.Generic;
using System.Linq;
using UnityEngine.InputSystem.LowLevel;

namespace UnityEngine.InputSystem
{
    /// <summary>A map at work: its bindings with their controls, kept up to date while any of its actions is enabled.</summary>
    sealed class ActionMapState
    {
        BoundBinding[] m_Bindings;
        int m_DevicesVersion;

        internal ActionMapState(InputActionMap map)
        {
            Map = map;
            Resolve();
        }

        internal InputActionMap Map { get; }

        internal bool IsUpToDate => m_DevicesVersion == InputManager.Instance.DevicesVersion;

        internal bool HasPendingChecks { get; private set; }

        internal IReadOnlyList<BoundBinding> Bindings => m_Bindings;

        /// <summary>Finds the controls anew. Actions go on if the control that drives them is still meant, and are canceled if not.</summary>
        internal void Resolve()
        {
            foreach (var binding in m_Bindings ?? System.Array.Empty<BoundBinding>())
                foreach (var control in binding.Controls)
                    control.Disable();
            m_DevicesVersion = InputManager.Instance.DevicesVersion;
            m_Bindings = new BindingResolver(this).Resolve();
            foreach (var action in Map.m_Actions)
                Bind(action);
        }

        internal InputControl[] ControlsOf(InputAction action) =>
            action.State.Bindings.SelectMany(b => b.DrivingControls).Select(c => c.Control).Distinct().ToArray();

        internal void Enable(InputAction action)
        {
            action.State.Enable();
            Listen(action);
            InputManager.Instance.Watch(this);
        }

        internal void Disable(InputAction action)
        {
            foreach (var control in action.State.Bindings.SelectMany(b => b.DrivingControls))
                control.Disable();
            action.State.Reset(InputActionPhase.Disabled);
            if (!Map.m_Actions.Any(a => a.enabled))
                InputManager.Instance.Unwatch(this);
        }

        /// <summary>At the first update after enabling: controls that are not at rest count as if they had just moved.</summary>
        internal void CheckInitialState()
        {
            HasPendingChecks = false;
            foreach (var binding in m_Bindings)
            {
                if (!binding.IsCheckPending)
                    continue;
                binding.IsCheckPending = false;
                foreach (var control in binding.DrivingControls.Where(c => c.IsEnabled && !c.Control.IsAtDefault).ToList())
                {
                    if (binding.Action.State.Driver?.Control == control.Control)
                        continue;
                    ProcessChange(control, InputState.currentTime, 0);
                    if (binding.IsComposite)
                        break; // it was looked at as a whole
                }
            }
        }

        /// <summary>A control's state changed. Several changes by one event are one change of a composite.</summary>
        internal void ProcessChange(BoundControl changed, double time, int eventId)
        {
            var binding = changed.Binding;
            var state = binding.Action.State;
            var composite = binding.Composite;
            (composite ?? binding).IsCheckPending = false;
            changed.Magnitude = changed.Control.IsAtDefault ? 0f : changed.Control.magnitude;
            if (changed.Magnitude >= changed.PressPoint && (binding.PressTime == 0 || binding.PressTime > time))
                binding.PressTime = time;
            var trigger = new ActionState.Trigger { Control = changed, Magnitude = changed.Magnitude, Time = time };
            var compositeIsDone = composite != null && eventId != 0 && composite.LastEventId == eventId;
            if (composite != null && !compositeIsDone)
            {
                var context = new InputBindingCompositeContext(composite);
                composite.LastEventId = eventId;
                composite.CompositeMagnitude = trigger.Magnitude = composite.Instance.EvaluateMagnitude(ref context);
            }

            if (!compositeIsDone && ConflictResolution.Ignores(ref trigger, state))
                return;
            state.ProcessButton(trigger);
            if (!compositeIsDone)
                state.ProcessPhase(trigger);
        }

        void Bind(InputAction action)
        {
            var state = action.State;
            var driving = state.Driver;
            state.Bindings.Clear();
            state.Bindings.AddRange(m_Bindings.Where(b => b.Action == action && b.Composite == null));
            state.MayConflict = action.type != InputActionType.PassThrough
                && state.Bindings.Sum(b => b.IsComposite ? System.Math.Min(1, b.DrivingControls.Count()) : b.Controls.Count) > 1;
            if (!action.enabled)
                return;
            if (driving != null)
            {
                var same = state.Bindings.SelectMany(b => b.DrivingControls).FirstOrDefault(c => c.Control == driving.Control && c.Control.device.added);
                if (same != null)
                    Continue(state, driving, same);
                else
                    state.Reset(InputActionPhase.Waiting);
            }

            if (action.enabled) // a listener may have disabled it
                Listen(action);
        }

        static void Continue(ActionState state, BoundControl before, BoundControl now)
        {
            now.Magnitude = before.Magnitude;
            now.Binding.PressTime = before.Binding.PressTime;
            if (now.Binding.Composite != null && before.Binding.Composite != null)
                now.Binding.Composite.CompositeMagnitude = before.Binding.Composite.CompositeMagnitude;
            state.Driver = now;
        }

        void Listen(InputAction action)
        {
            foreach (var binding in action.State.Bindings)
            {
                foreach (var control in binding.DrivingControls)
                    control.Enable();
                if (!action.wantsInitialStateCheck || !binding.DrivingControls.Any())
                    continue;
                binding.IsCheckPending = true;
                HasPendingChecks = true;
            }
        }
    }
}
