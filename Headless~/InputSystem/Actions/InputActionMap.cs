using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>Actions that belong together, with their bindings.</summary>
    [Serializable]
    public sealed class InputActionMap : ICloneable, ISerializationCallbackReceiver, IInputActionCollection2, IDisposable
    {
        [SerializeField]
        internal string m_Name;

        [SerializeField]
        internal string m_Id;

        [SerializeField]
        internal InputAction[] m_Actions = Array.Empty<InputAction>();

        [SerializeField]
        internal InputBinding[] m_Bindings = Array.Empty<InputBinding>();

        [NonSerialized]
        internal InputActionAsset m_Asset;

        [NonSerialized]
        internal InputAction m_SingletonAction;

        [NonSerialized]
        ActionMapState m_State;

        [NonSerialized]
        InputBinding? m_BindingMask;

        [NonSerialized]
        InputDevice[] m_Devices;

        public InputActionMap()
        {
        }

        public InputActionMap(string name) => m_Name = name;

        /// <summary>The map of an action of its own, which nobody sees.</summary>
        internal InputActionMap(InputAction action, InputBinding[] bindings)
        {
            m_SingletonAction = action;
            m_Actions = new[] { action };
            m_Bindings = bindings ?? Array.Empty<InputBinding>();
        }

        /// <summary>Raised when any of its actions starts, performs or is canceled.</summary>
        public event Action<InputAction.CallbackContext> actionTriggered;

        public string name => m_Name;

        public InputActionAsset asset => m_Asset;

        public Guid id
        {
            get
            {
                if (string.IsNullOrEmpty(m_Id))
                    m_Id = Guid.NewGuid().ToString();
                return new Guid(m_Id);
            }
        }

        /// <summary>Whether any of its actions is enabled.</summary>
        public bool enabled => m_Actions.Any(a => a.enabled);

        public ReadOnlyArray<InputAction> actions => m_Actions;

        public ReadOnlyArray<InputBinding> bindings => m_Bindings;

        public ReadOnlyArray<InputControlScheme> controlSchemes => m_Asset == null ? default : m_Asset.controlSchemes;

        IEnumerable<InputBinding> IInputActionCollection2.bindings => m_Bindings;

        public InputBinding? bindingMask
        {
            get => m_BindingMask;
            set
            {
                m_BindingMask = value;
                ForgetResolution();
            }
        }

        /// <summary>The devices whose controls it uses; null = those of its asset, or else all.</summary>
        public ReadOnlyArray<InputDevice>? devices
        {
            get => m_Devices != null ? new ReadOnlyArray<InputDevice>(m_Devices) : m_Asset != null ? m_Asset.devices : default(ReadOnlyArray<InputDevice>?);
            set
            {
                m_Devices = value?.ToArray();
                ForgetResolution();
            }
        }

        /// <exception cref="KeyNotFoundException">There is none.</exception>
        public InputAction this[string actionNameOrId] =>
            FindAction(actionNameOrId) ?? throw new KeyNotFoundException($"Cannot find action '{actionNameOrId}'");

        internal Action<InputAction.CallbackContext> ActionTriggered => actionTriggered;

        /// <summary>The map's state with the controls that are there now.</summary>
        internal ActionMapState ResolvedState
        {
            get
            {
                if (m_State == null)
                    m_State = new ActionMapState(this);
                else if (!m_State.IsUpToDate)
                    m_State.Resolve();
                return m_State;
            }
        }

        /// <summary>Maps from JSON: an object with <c>maps</c>.</summary>
        public static InputActionMap[] FromJson(string json) => ActionsJson.ReadMaps(json ?? throw new ArgumentNullException(nameof(json)));

        public static string ToJson(IEnumerable<InputActionMap> maps) => ActionsJson.Write(null, maps, null);

        public string ToJson() => ToJson(new[] { this });

        public InputAction FindAction(string actionNameOrId, bool throwIfNotFound = false)
        {
            if (actionNameOrId == null)
                throw new ArgumentNullException(nameof(actionNameOrId));
            var found = Array.Find(m_Actions, a => a.m_Id == actionNameOrId)
                ?? Array.Find(m_Actions, a => string.Equals(a.name, actionNameOrId, StringComparison.OrdinalIgnoreCase));
            if (found == null && throwIfNotFound)
                throw new ArgumentException($"No action '{actionNameOrId}' in '{this}'", nameof(actionNameOrId));
            return found;
        }

        public InputAction FindAction(Guid id) => Array.Find(m_Actions, a => a.id == id);

        public int FindBinding(InputBinding mask, out InputAction action)
        {
            var index = Array.FindIndex(m_Bindings, b => mask.Matches(b));
            action = index < 0 ? null : Array.Find(m_Actions, a => m_Bindings[index].Triggers(a));
            return action == null ? -1 : Array.FindIndex(BindingsOf(action), b => mask.Matches(b));
        }

        public bool Contains(InputAction action) => action != null && action.actionMap == this;

        public bool IsUsableWithDevice(InputDevice device)
        {
            if (device == null)
                throw new ArgumentNullException(nameof(device));
            return m_Bindings.Any(b => !b.isComposite && !string.IsNullOrEmpty(b.effectivePath)
                && InputControlPath.TryFindControl(device, b.effectivePath) != null);
        }

        public void Enable()
        {
            foreach (var action in m_Actions)
                action.Enable();
        }

        public void Disable()
        {
            foreach (var action in m_Actions)
                action.Disable();
        }

        public InputActionMap Clone()
        {
            var copy = FromJson(ToJson())[0];
            foreach (var action in copy.m_Actions)
                action.m_Id = null;
            copy.m_Id = null;
            return copy;
        }

        object ICloneable.Clone() => Clone();

        public void Dispose() => Disable();

        public IEnumerator<InputAction> GetEnumerator() => ((IEnumerable<InputAction>)m_Actions).GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        public void OnBeforeSerialize()
        {
        }

        public void OnAfterDeserialize()
        {
            m_State = null;
            foreach (var action in m_Actions)
                action.m_ActionMap = this;
        }

        public override string ToString() => m_Asset != null ? $"{m_Asset}:{m_Name}" : string.IsNullOrEmpty(m_Name) ? "<unnamed map>" : m_Name;

        /// <summary>An action's bindings, with the parts of its composites.</summary>
        internal InputBinding[] BindingsOf(InputAction action)
        {
            var found = new List<InputBinding>();
            var belongs = false;
            foreach (var binding in m_Bindings)
            {
                belongs = binding.isPartOfComposite ? belongs : m_SingletonAction == action || binding.Triggers(action);
                if (belongs)
                    found.Add(binding);
            }

            return found.ToArray();
        }

        /// <summary>Where in the map an action's binding stands.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The action has no such binding.</exception>
        internal int IndexOf(InputAction action, int bindingOfAction)
        {
            var belongs = false;
            var count = -1;
            for (var i = 0; i < m_Bindings.Length; i++)
            {
                belongs = m_Bindings[i].isPartOfComposite ? belongs : m_SingletonAction == action || m_Bindings[i].Triggers(action);
                if (belongs && ++count == bindingOfAction)
                    return i;
            }

            throw new ArgumentOutOfRangeException(nameof(bindingOfAction),
                $"Binding index {bindingOfAction} is out of range for action '{action}' with {count + 1} bindings");
        }

        internal void Add(InputAction action)
        {
            CheckIsDisabled();
            m_Actions = m_Actions.Append(action).ToArray();
            action.m_ActionMap = this;
            m_State = null;
        }

        internal void Add(InputBinding binding)
        {
            binding.MakeSureItHasAnId();
            m_Bindings = m_Bindings.Append(binding).ToArray();
            ForgetResolution();
        }

        /// <summary>Something changed of what its bindings mean.</summary>
        internal void ForgetResolution()
        {
            if (m_State == null)
                return;
            if (enabled)
                m_State.Resolve();
            else
                m_State = null;
        }

        void CheckIsDisabled()
        {
            if (enabled)
                throw new InvalidOperationException($"Cannot add, remove, or change elements of action map '{this}' while one or more of its actions are enabled");
        }
    }
}
