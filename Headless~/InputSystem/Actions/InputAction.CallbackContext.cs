using System;

namespace UnityEngine.InputSystem
{
    public sealed partial class InputAction
    {
        /// <summary>What a callback is told.</summary>
        public struct CallbackContext
        {
            readonly ActionState m_State;

            internal CallbackContext(ActionState state, InputActionPhase phase)
            {
                m_State = state;
                this.phase = phase;
                time = state.Time;
                startTime = state.StartTime;
                control = state.Driver?.Control;
            }

            public InputActionPhase phase { get; }

            public bool started => phase == InputActionPhase.Started;

            public bool performed => phase == InputActionPhase.Performed;

            public bool canceled => phase == InputActionPhase.Canceled;

            public InputAction action => m_State?.Action;

            /// <summary>The control that drives the action.</summary>
            public InputControl control { get; }

            public double time { get; }

            public double startTime { get; }

            public double duration => time - startTime;

            /// <exception cref="InvalidOperationException">The value is of another type.</exception>
            public TValue ReadValue<TValue>() where TValue : struct => m_State == null ? default : m_State.ReadValue<TValue>(phase.IsInProgress());

            public bool ReadValueAsButton() => m_State != null && phase.IsInProgress() && m_State.IsActuatedAsButton;

            /// <summary>Null when the action was canceled.</summary>
            public object ReadValueAsObject() => m_State != null && phase.IsInProgress() ? m_State.ReadValueAsObject() : null;

            public override string ToString() => $"{{ action={action} phase={phase} time={time} control={control} value={ReadValueAsObject()} }}";
        }
    }
}
