using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>Something of a device that has a value: a button, an axis, a stick; the device itself too. Its state lies in the device's memory.</summary>
    public abstract unsafe class InputControl
    {
        protected internal InputStateBlock m_StateBlock;

        internal InternedString m_Layout;
        internal InputDevice m_Device;
        internal InputControl m_Parent;
        internal InputControl[] m_Children = Array.Empty<InputControl>();
        internal InternedString[] m_Usages = Array.Empty<InternedString>();
        internal InternedString[] m_Aliases = Array.Empty<InternedString>();
        internal List<InputProcessor> m_ProcessorStack = new();
        internal string m_DisplayName;
        internal string m_ShortDisplayName;
        string m_Path;

        /// <summary>While the device is built: a control whose state it reads, and the byte at which it was said to lie.</summary>
        internal string SharesStateOf;
        internal uint? FixedByte;

        protected InputControl()
        {
        }

        public string name { get; internal set; }

        /// <summary>What people call it.</summary>
        public string displayName
        {
            get => m_DisplayName ?? name;
            protected set => m_DisplayName = value;
        }

        public string shortDisplayName
        {
            get => string.IsNullOrEmpty(m_ShortDisplayName) ? null : m_ShortDisplayName;
            protected set => m_ShortDisplayName = value;
        }

        /// <summary>"/Mouse/scroll/y".</summary>
        public string path => m_Path ??= InputControlPath.Combine(m_Parent, name);

        public string layout => m_Layout;

        public InputDevice device => m_Device;

        public InputControl parent => m_Parent;

        public ReadOnlyArray<InputControl> children => m_Children;

        public ReadOnlyArray<InternedString> usages => m_Usages;

        public ReadOnlyArray<InternedString> aliases => m_Aliases;

        public InputStateBlock stateBlock => m_StateBlock;

        /// <summary>Whether its value changes without anybody doing anything.</summary>
        public bool noisy { get; internal set; }

        /// <summary>Whether it is made from other controls' state.</summary>
        public bool synthetic { get; internal set; }

        public abstract Type valueType { get; }

        public abstract int valueSizeInBytes { get; }

        /// <summary>How far it is from rest: 0 at rest, 1 for a button that is down. -1 where that means nothing.</summary>
        public float magnitude => EvaluateMagnitude();

        public InputControl this[string path] =>
            InputControlPath.TryFindChild(this, path) ?? throw new KeyNotFoundException($"Cannot find control '{path}' as child of '{this}'");

        protected void* currentStatePtr => m_Device.State.Current;

        protected void* defaultStatePtr => m_Device.State.Default;

        protected void* previousFrameStatePtr => m_Device.State.Previous;

        internal void* StateNow => m_Device.State.Current;

        internal bool IsAtDefault => m_StateBlock.SameIn(m_Device.State.Current, m_Device.State.Default);

        public float EvaluateMagnitude() => EvaluateMagnitude(currentStatePtr);

        public virtual float EvaluateMagnitude(void* statePtr) => -1f;

        /// <summary>Whether the values in two states differ.</summary>
        public abstract bool CompareValue(void* firstStatePtr, void* secondStatePtr);

        public abstract object ReadValueFromBufferAsObject(void* buffer, int bufferSize);

        public abstract object ReadValueFromStateAsObject(void* statePtr);

        public abstract void ReadValueFromStateIntoBuffer(void* statePtr, void* bufferPtr, int bufferSize);

        /// <exception cref="ArgumentException">There is none.</exception>
        public InputControl GetChildControl(string path)
        {
            if (string.IsNullOrEmpty(path))
                throw new ArgumentNullException(nameof(path));
            return TryGetChildControl(path) ?? throw new ArgumentException($"Cannot find input control '{this}/{path}'", nameof(path));
        }

        /// <exception cref="ArgumentException">There is none.</exception>
        /// <exception cref="InvalidOperationException">It is of another type.</exception>
        public TControl GetChildControl<TControl>(string path) where TControl : InputControl
        {
            var control = GetChildControl(path);
            return control as TControl ?? throw new ArgumentException(
                $"Expected control '{path}' to be of type '{typeof(TControl).Name}' but is of type '{control.GetType().Name}' instead!", nameof(path));
        }

        public InputControl TryGetChildControl(string path)
        {
            if (string.IsNullOrEmpty(path))
                throw new ArgumentNullException(nameof(path));
            return InputControlPath.TryFindChild(this, path);
        }

        public TControl TryGetChildControl<TControl>(string path) where TControl : InputControl => TryGetChildControl(path) as TControl;

        public override string ToString() => $"{layout}:{path}";

        /// <summary>When the whole tree of the device is there: takes the children that properties stand for.</summary>
        protected virtual void FinishSetup()
        {
        }

        internal void SendFinishSetup() => FinishSetup();

        internal void AddProcessor(InputProcessor processor) => m_ProcessorStack.Add(processor);
    }
}
