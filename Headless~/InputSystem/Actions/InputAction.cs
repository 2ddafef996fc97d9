using System;
using System.Linq;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>Something that a user does, whatever controls it is done with.</summary>
    [Serializable]
    public sealed partial class InputAction : ICloneable, IDisposable
    {
        const int InitialStateCheckFlag = 1;

        [SerializeField]
        internal string m_Name;

        [SerializeField]
        internal InputActionType m_Type;

        [SerializeField]
        internal string m_ExpectedControlType;

        [SerializeField]
        internal string m_Id;

        [SerializeField]
        internal string m_Processors;

        [SerializeField]
        internal string m_Interactions;

        [SerializeField]
        InputBinding[] m_SingletonActionBindings;

        [SerializeField]
        int m_Flags;

        [NonSerialized]
        internal InputActionMap m_ActionMap;

        [NonSerialized]
        internal InputBinding? m_BindingMask;

        [NonSerialized]
        ActionState m_State;

        public InputAction()
        {
        }

        public InputAction(
            string name = null, InputActionType type = default, string binding = null, string interactions = null, string processors = null,
            string expectedControlType = null)
        {
            m_Name = name;
            m_Type = type;
            if (!string.IsNullOrEmpty(binding))
                m_SingletonActionBindings = new[]
                {
                    new InputBinding(binding, name, null, processors, interactions) { id = Guid.NewGuid() },
                };
            m_Interactions = binding != null ? null : interactions;
            m_Processors = binding != null ? null : processors;
            m_ExpectedControlType = expectedControlType;
        }

        /// <summary>Raised when a control begins to be actuated.</summary>
        public event Action<CallbackContext> started;

        /// <summary>Raised when the action is done: a button is pressed, a value changes.</summary>
        public event Action<CallbackContext> performed;

        /// <summary>Raised when all controls are at rest again.</summary>
        public event Action<CallbackContext> canceled;

        public string name => m_Name;

        public InputActionType type => m_Type;

        public Guid id
        {
            get
            {
                if (string.IsNullOrEmpty(m_Id))
                    m_Id = Guid.NewGuid().ToString();
                return new Guid(m_Id);
            }
        }

        public string expectedControlType { get => m_ExpectedControlType; set => m_ExpectedControlType = value; }

        public string processors => m_Processors;

        public string interactions => m_Interactions;

        /// <summary>Null for an action of its own, and for one that is its map's only one without a map that anybody made.</summary>
        public InputActionMap actionMap => IsSingleton ? null : m_ActionMap;

        public InputBinding? bindingMask
        {
            get => m_BindingMask;
            set
            {
                m_BindingMask = value;
                MapInUse.ForgetResolution();
            }
        }

        /// <summary>Its bindings, parts of composites included.</summary>
        public ReadOnlyArray<InputBinding> bindings => MapInUse.BindingsOf(this);

        /// <summary>The controls that its bindings mean now.</summary>
        public ReadOnlyArray<InputControl> controls => MapInUse.ResolvedState.ControlsOf(this);

        public InputActionPhase phase => m_State?.Phase ?? InputActionPhase.Disabled;

        public bool inProgress => phase.IsInProgress();

        public bool enabled => phase != InputActionPhase.Disabled;

        public bool triggered => WasPerformedThisFrame();

        /// <summary>The control that drives it; null while it waits.</summary>
        public InputControl activeControl => m_State?.Driver?.Control;

        /// <summary>Whether it looks at its controls when it is enabled; values always do.</summary>
        public bool wantsInitialStateCheck
        {
            get => m_Type == InputActionType.Value || (m_Flags & InitialStateCheckFlag) != 0;
            set => m_Flags = value ? m_Flags | InitialStateCheckFlag : m_Flags & ~InitialStateCheckFlag;
        }

        /// <summary>Made at first use and kept: what the action is doing.</summary>
        internal ActionState State => m_State ??= new ActionState(this);

        internal bool IsSingleton => m_ActionMap == null || m_ActionMap.m_SingletonAction == this;

        /// <summary>The map it is in; an action of its own gets one that nobody sees.</summary>
        internal InputActionMap MapInUse
        {
            get
            {
                if (m_ActionMap == null)
                {
                    for (var i = 0; i < (m_SingletonActionBindings?.Length ?? 0); i++)
                        if (string.IsNullOrEmpty(m_SingletonActionBindings[i].action))
                            m_SingletonActionBindings[i].action = m_Name;
                    m_ActionMap = new InputActionMap(this, m_SingletonActionBindings);
                }

                return m_ActionMap;
            }
        }

        public void Enable()
        {
            if (!enabled)
                MapInUse.ResolvedState.Enable(this);
        }

        public void Disable()
        {
            if (enabled)
                MapInUse.ResolvedState.Disable(this);
        }

        /// <summary>Back to waiting, whatever its controls do; and nothing happened this frame.</summary>
        public void Reset() => State.Reset(enabled ? InputActionPhase.Waiting : InputActionPhase.Disabled, true);

        /// <exception cref="InvalidOperationException">The value is of another type.</exception>
        public TValue ReadValue<TValue>() where TValue : struct => State.ReadValue<TValue>();

        /// <summary>Null while it waits.</summary>
        public object ReadValueAsObject() => State.ReadValueAsObject();

        public float GetControlMagnitude() => inProgress ? State.Magnitude : 0f;

        /// <summary>Whether it was pressed and not released since, whatever its type.</summary>
        public bool IsPressed() => m_State?.IsPressed ?? false;

        public bool IsInProgress() => inProgress;

        public bool WasPressedThisFrame() => m_State != null && m_State.HappenedThisFrame(m_State.PressedIn);

        public bool WasReleasedThisFrame() => m_State != null && m_State.HappenedThisFrame(m_State.ReleasedIn);

        public bool WasPerformedThisFrame() => m_State != null && m_State.HappenedThisFrame(m_State.PerformedIn);

        public bool WasCompletedThisFrame() => m_State != null && m_State.HappenedThisFrame(m_State.CompletedIn);

        /// <summary>An action of its own with the same bindings.</summary>
        public InputAction Clone() => new(m_Name, m_Type)
        {
            m_SingletonActionBindings = bindings.ToArray(),
            m_ExpectedControlType = m_ExpectedControlType,
            m_Interactions = m_Interactions,
            m_Processors = m_Processors,
            m_Flags = m_Flags,
        };

        object ICloneable.Clone() => Clone();

        public void Dispose() => Disable();

        public override string ToString()
        {
            var text = m_Name ?? "<Unnamed>";
            if (!IsSingleton && !string.IsNullOrEmpty(m_ActionMap.name))
                text = $"{m_ActionMap.name}/{text}";
            return m_State == null || controls.Count == 0 ? text : $"{text}[{string.Join(",", controls.Select(c => c.path))}]";
        }

        internal void Raise(InputActionPhase reached, CallbackContext context)
        {
            var callbacks = reached == InputActionPhase.Started ? started : reached == InputActionPhase.Performed ? performed : canceled;
            Raise(m_ActionMap.ActionTriggered, context, "actionTriggered");
            Raise(callbacks, context, reached == InputActionPhase.Started ? "started" : reached == InputActionPhase.Performed ? "performed" : "canceled");
        }

        void Raise(Action<CallbackContext> callbacks, CallbackContext context, string callbackName)
        {
            if (callbacks == null)
                return;
            foreach (var callback in callbacks.GetInvocationList())
                try
                {
                    ((Action<CallbackContext>)callback)(context);
                }
                catch (Exception e)
                {
                    Debug.LogError($"{e.GetType().Name} while executing '{callbackName}' callbacks of '{this}'");
                    Debug.LogException(e);
                }
        }
    }
}
