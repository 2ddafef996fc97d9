using System;
using System.Collections.Generic;
using UnityEngine.InputSystem.Controls;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>Something with controls that can be added to the system.</summary>
    public unsafe class InputDevice : InputControl
    {
        public const int InvalidDeviceId = 0;

        readonly List<BoundControl> m_Monitors = new();
        readonly List<BoundControl> m_Changed = new();
        readonly List<InputControl> m_All = new();
        InputControl[] m_AllArray = Array.Empty<InputControl>();

        public override Type valueType => typeof(byte[]);

        public override int valueSizeInBytes => (int)m_StateBlock.SizeInBytes;

        public int deviceId { get; internal set; }

        /// <summary>Whether the system has it.</summary>
        public bool added { get; internal set; }

        public bool enabled => added;

        /// <summary>Whether the platform reports it, instead of a script. The host's never are.</summary>
        public bool native => false;

        public bool canRunInBackground => true;

        /// <summary>Whether state came in with the update that ran last.</summary>
        public bool wasUpdatedThisFrame => UpdatedIn == InputManager.Instance.UpdateStep;

        public double lastUpdateTime { get; internal set; }

        public ReadOnlyArray<InputControl> allControls => m_AllArray;

        internal DeviceState State { get; set; }

        internal List<ButtonControl> CountedButtons { get; } = new();

        internal uint UpdatedIn { get; private set; } = uint.MaxValue;

        /// <summary>Makes it the one that <c>current</c> of its class means.</summary>
        public virtual void MakeCurrent()
        {
        }

        public override bool CompareValue(void* firstStatePtr, void* secondStatePtr) => !m_StateBlock.SameIn((byte*)firstStatePtr, (byte*)secondStatePtr);

        public override object ReadValueFromBufferAsObject(void* buffer, int bufferSize) =>
            new ReadOnlySpan<byte>(buffer, Math.Min(bufferSize, valueSizeInBytes)).ToArray();

        public override object ReadValueFromStateAsObject(void* statePtr) => ReadValueFromBufferAsObject(statePtr, valueSizeInBytes);

        public override void ReadValueFromStateIntoBuffer(void* statePtr, void* bufferPtr, int bufferSize)
        {
            if (bufferSize < valueSizeInBytes)
                throw new ArgumentException($"Buffer too small (expected: {valueSizeInBytes}, actual: {bufferSize}", nameof(bufferSize));
            new ReadOnlySpan<byte>(statePtr, valueSizeInBytes).CopyTo(new Span<byte>(bufferPtr, bufferSize));
        }

        protected virtual void OnAdded()
        {
        }

        protected virtual void OnRemoved()
        {
        }

        internal void SendAdded() => OnAdded();

        internal void SendRemoved() => OnRemoved();

        /// <summary>At the beginning of an update, before its events: what goes back by itself does so.</summary>
        internal virtual void BeginUpdate()
        {
        }

        /// <summary>Changes an event's bytes, which go to <paramref name="byteOffset"/>, before they become state: movements add up within an update.</summary>
        internal virtual void Prepare(Span<byte> bytes, uint byteOffset)
        {
        }

        internal void CollectControls()
        {
            void Collect(InputControl control)
            {
                foreach (var child in control.m_Children)
                {
                    m_All.Add(child);
                    Collect(child);
                }
            }

            m_All.Clear();
            Collect(this);
            m_AllArray = m_All.ToArray();
        }

        internal void AddMonitor(BoundControl monitor) => m_Monitors.Add(monitor);

        internal void RemoveMonitor(BoundControl monitor) => m_Monitors.Remove(monitor);

        /// <summary>Takes bytes into the state and tells the actions whose controls lie in what changed.</summary>
        internal void Change(ReadOnlySpan<byte> bytes, uint byteOffset, double time, int eventId)
        {
            var step = InputManager.Instance.UpdateStep;
            if (UpdatedIn != step)
            {
                State.KeepAsPrevious();
                UpdatedIn = step;
            }

            State.KeepAsBefore();
            bytes.CopyTo(new Span<byte>(State.Current + byteOffset, State.Size - (int)byteOffset));
            lastUpdateTime = time;
            foreach (var button in CountedButtons)
                button.UpdatePresses();
            Notify(time, eventId);
        }

        /// <summary>All are told that were there when the change came, as long as they are still enabled.</summary>
        void Notify(double time, int eventId)
        {
            m_Changed.Clear();
            foreach (var monitor in m_Monitors)
                if (!monitor.Control.m_StateBlock.SameIn(State.Before, State.Current))
                    m_Changed.Add(monitor);
            for (var i = 0; i < m_Changed.Count; i++)
                if (m_Changed[i].IsEnabled)
                    m_Changed[i].Binding.Map.ProcessChange(m_Changed[i], time, eventId);
        }
    }
}
