using System;
using System.Collections.Generic;
using UnityEngine.InputSystem.Controls;
using UnityEngine.InputSystem.LowLevel;

namespace UnityEngine.InputSystem
{
    /// <summary>What one action is doing: its phase, and the control that drives it.</summary>
    sealed class ActionState
    {

        internal ActionState(InputAction action) => Action = action;

        internal InputAction Action { get; }

        internal InputActionPhase Phase { get; private set; } = InputActionPhase.Disabled;

        /// <summary>Null while it waits.</summary>
        internal BoundControl Driver { get; set; }

        /// <summary>The bindings that trigger it, without the parts of composites.</summary>
        internal List<BoundBinding> Bindings { get; } = new();

        /// <summary>Whether more than one control could drive it at a time.</summary>
        internal bool MayConflict { get; set; }

        internal bool HasSeveralActuations { get; set; }

        internal float Magnitude { get; set; }

        internal bool IsPressed { get; private set; }

        internal uint PressedIn { get; private set; }

        internal uint ReleasedIn { get; private set; }

        internal uint PerformedIn { get; private set; }

        internal uint CompletedIn { get; private set; }

        internal double Time { get; private set; }

        internal double StartTime { get; private set; }

        internal bool IsActuatedAsButton => Driver != null && Magnitude >= Driver.PressPoint;

        int Frame { get; set; } = -1;

        internal bool HappenedThisFrame(uint step) =>
            step == InputManager.Instance.UpdateStep && step != 0 && Frame == UnityEngine.Time.frameCount;

        internal void Enable() => Phase = InputActionPhase.Waiting;

        /// <summary>Stops whatever it is doing, with a callback.</summary>
        internal void Reset(InputActionPhase to, bool alsoForgetsThisFrame = false)
        {
            if (Phase.IsInProgress())
            {
                Time = InputState.currentTime;
                Change(InputActionPhase.Canceled, Driver, Time, 0f, to);
            }

            Phase = to;
            Driver = null;
            HasSeveralActuations = false;
            IsPressed = false;
            if (!alsoForgetsThisFrame)
                return;
            PressedIn = ReleasedIn = PerformedIn = CompletedIn = 0;
            Frame = -1;
        }

        /// <summary>Presses and releases, which every type of action has.</summary>
        internal void ProcessButton(in Trigger trigger)
        {
            var pressPoint = trigger.Control.PressPoint;
            var releasePoint = pressPoint * ButtonControl.ReleaseThreshold;
            if (trigger.Control.Magnitude <= releasePoint)
                trigger.Control.Binding.PressTime = 0;
            if (!IsPressed && trigger.Magnitude >= pressPoint)
            {
                IsPressed = true;
                PressedIn = InputManager.Instance.UpdateStep;
                Frame = UnityEngine.Time.frameCount;
            }
            else if (IsPressed && trigger.Magnitude <= releasePoint)
            {
                IsPressed = false;
                ReleasedIn = InputManager.Instance.UpdateStep;
                Frame = UnityEngine.Time.frameCount;
            }
        }

        /// <summary>From phase to phase, as an action without interactions goes.</summary>
        internal void ProcessPhase(in Trigger trigger)
        {
            switch (Action.type)
            {
                case InputActionType.PassThrough:
                    Change(InputActionPhase.Performed, trigger.Control, trigger.Time, trigger.Magnitude, InputActionPhase.Performed);
                    break;
                case InputActionType.Button:
                    ProcessButtonPhase(trigger);
                    break;
                default:
                    ProcessValuePhase(trigger);
                    break;
            }
        }

        internal TValue ReadValue<TValue>() where TValue : struct => ReadValue<TValue>(Phase.IsInProgress());

        internal TValue ReadValue<TValue>(bool isInProgress) where TValue : struct
        {
            if (isInProgress && Driver != null)
                return BindingValues.Read<TValue>(Driver, Action);
            return Bindings.Count > 0 ? Bindings[0].Process(default(TValue), null) : default;
        }

        internal object ReadValueAsObject() => Phase.IsInProgress() && Driver != null ? BindingValues.ReadAsObject(Driver) : null;

        void ProcessButtonPhase(in Trigger trigger)
        {
            var pressPoint = trigger.Control.PressPoint;
            var isAtRest = Mathf.Approximately(trigger.Magnitude, 0f);
            if (Phase == InputActionPhase.Waiting && trigger.Magnitude > 0f)
                Change(InputActionPhase.Started, trigger.Control, trigger.Time, trigger.Magnitude, InputActionPhase.Started);
            if (Phase == InputActionPhase.Started)
            {
                if (trigger.Magnitude >= pressPoint)
                    Change(InputActionPhase.Performed, trigger.Control, trigger.Time, trigger.Magnitude, InputActionPhase.Performed);
                else if (isAtRest)
                    Change(InputActionPhase.Canceled, trigger.Control, trigger.Time, 0f, InputActionPhase.Waiting);
            }
            else if (Phase == InputActionPhase.Performed)
            {
                if (isAtRest)
                    Change(InputActionPhase.Canceled, trigger.Control, trigger.Time, 0f, InputActionPhase.Waiting);
                else if (trigger.Magnitude <= pressPoint * ButtonControl.ReleaseThreshold)
                    Change(InputActionPhase.Started, trigger.Control, trigger.Time, trigger.Magnitude, InputActionPhase.Started);
            }
        }

        void ProcessValuePhase(in Trigger trigger)
        {
            // -1 stands for controls whose values have no size, such as rotations: any change counts.
            var isActuated = trigger.Magnitude > 0f || trigger.Magnitude < 0f;
            if (Phase == InputActionPhase.Waiting && isActuated)
                Change(InputActionPhase.Started, trigger.Control, trigger.Time, trigger.Magnitude, InputActionPhase.Started);
            if (Phase != InputActionPhase.Started)
                return;
            if (isActuated)
                Change(InputActionPhase.Performed, trigger.Control, trigger.Time, trigger.Magnitude, InputActionPhase.Started);
            else
                Change(InputActionPhase.Canceled, trigger.Control, trigger.Time, 0f, InputActionPhase.Waiting);
        }

        /// <summary>Reaches a phase, tells the listeners, and goes on to <paramref name="after"/> unless a listener disabled the action.</summary>
        void Change(InputActionPhase reached, BoundControl driver, double time, float magnitude, InputActionPhase after)
        {
            if (Phase == InputActionPhase.Disabled)
                return;
            var step = InputManager.Instance.UpdateStep;
            if (Phase == InputActionPhase.Performed && reached != InputActionPhase.Performed && after != InputActionPhase.Disabled)
                CompletedIn = step;
            if (reached == InputActionPhase.Performed)
                PerformedIn = step;
            if (reached == InputActionPhase.Started)
                StartTime = time;
            Phase = reached;
            Driver = driver;
            Magnitude = magnitude;
            Time = time;
            Frame = UnityEngine.Time.frameCount;
            Action.Raise(reached, new InputAction.CallbackContext(this, reached));
            if (Phase != reached)
                return; // a listener disabled or reset it
            Phase = after;
            if (after == InputActionPhase.Waiting)
            {
                Driver = null;
                Magnitude = 0f;
            }
        }

        /// <summary>A change of a control that may drive the action.</summary>
        internal struct Trigger
        {
            internal BoundControl Control;

            /// <summary>Of a composite's part, that of the whole composite.</summary>
            internal float Magnitude;
            internal double Time;
        }
    }
}
