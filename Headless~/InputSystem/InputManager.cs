using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using UnityEngine.InputSystem.LowLevel;

namespace UnityEngine.InputSystem
{
    /// <summary>What the system holds: layouts, devices, events that wait, actions that are enabled. One per run of the engine.</summary>
    sealed class InputManager
    {
        static InputManager s_Instance;

        readonly List<InputDevice> m_Devices = new();
        readonly List<ActionMapState> m_EnabledMaps = new();
        InputDevice[] m_DeviceArray = Array.Empty<InputDevice>();
        InputSettings m_Settings;
        int m_LastDeviceId;
        Action<EventQueue.Event> m_Take;

        InputManager()
        {
        }

        /// <summary>Made at first use, or by the engine at its start.</summary>
        internal static InputManager Instance
        {
            get
            {
                if (s_Instance == null)
                    Begin();
                return s_Instance;
            }
        }

        internal event Action BeforeUpdate;

        internal event Action AfterUpdate;

        internal event Action<InputDevice, InputDeviceChange> DeviceChange;

        internal LayoutRegistry Layouts { get; } = new();

        internal EventQueue Events { get; } = new();

        internal InputDevice[] Devices => m_DeviceArray;

        internal uint UpdateStep { get; private set; }

        internal InputUpdateType UpdateType { get; private set; }

        /// <summary>Grows when bindings may mean other controls than before.</summary>
        internal int DevicesVersion { get; private set; }

        internal InputSettings Settings
        {
            get
            {
                if (m_Settings == null)
                    m_Settings = ScriptableObject.CreateInstance<InputSettings>();
                return m_Settings;
            }
            set => m_Settings = value != null ? value : throw new ArgumentNullException(nameof(value));
        }

        /// <summary>As the engine starts: nothing is left of an earlier run.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Begin()
        {
            var manager = new InputManager();
            s_Instance = manager;
            BuiltinLayouts.Register(manager.Layouts);
            EngineLoop.PreUpdate += manager.OnPreUpdate;
            Application.quitting += manager.OnQuitting;
        }

        internal InputDevice AddDevice(string layout, string name)
        {
            var device = new DeviceBuilder(Layouts).Build(layout, UniqueName(string.IsNullOrEmpty(name) ? layout : name));
            device.deviceId = ++m_LastDeviceId;
            device.added = true;
            m_Devices.Add(device);
            m_DeviceArray = m_Devices.ToArray();
            device.SendAdded();
            device.MakeCurrent();
            ResolveAgain();
            DeviceChange?.Invoke(device, InputDeviceChange.Added);
            return device;
        }

        internal void RemoveDevice(InputDevice device)
        {
            if (!m_Devices.Remove(device))
                return;
            m_DeviceArray = m_Devices.ToArray();
            device.added = false;
            device.SendRemoved();
            ResolveAgain();
            DeviceChange?.Invoke(device, InputDeviceChange.Removed);
        }

        internal void ChangeUsages(InputDevice device, Action change)
        {
            change();
            if (!device.added)
                return;
            ResolveAgain();
            DeviceChange?.Invoke(device, InputDeviceChange.UsageChanged);
        }

        internal T DeviceWithUsage<T>(string usage) where T : InputDevice =>
            m_Devices.OfType<T>().FirstOrDefault(d => d.m_Usages.Any(u => u == usage));

        internal void Queue<T>(InputDevice device, uint byteOffset, T state, double time) where T : struct
        {
            if (!device.added)
                throw new InvalidOperationException($"Cannot queue state event for device '{device}' because device has not been added to system");
            var bytes = MemoryMarshal.AsBytes(MemoryMarshal.CreateSpan(ref state, 1));
            if (byteOffset + bytes.Length > device.State.Size)
                throw new ArgumentException($"A state of {bytes.Length} bytes at {byteOffset} is too large for '{device}', which has {device.State.Size} bytes");
            Events.Add(device, byteOffset, bytes, time < 0 ? InputState.currentTime : time);
        }

        /// <summary>Takes in what is queued.</summary>
        internal void Update(InputUpdateType type)
        {
            UpdateType = type;
            UpdateStep++;
            foreach (var device in m_DeviceArray)
                device.BeginUpdate();
            InvokeSafely(BeforeUpdate, "InputSystem.onBeforeUpdate");
            foreach (var map in m_EnabledMaps.ToArrayIfAny(m => m.HasPendingChecks))
                map.CheckInitialState();
            if (Events.Count > 0)
                Events.Drain(m_Take ??= Take);
            InvokeSafely(AfterUpdate, "InputSystem.onAfterUpdate");
        }

        internal void Watch(ActionMapState map)
        {
            if (!m_EnabledMaps.Contains(map))
                m_EnabledMaps.Add(map);
        }

        internal void Unwatch(ActionMapState map) => m_EnabledMaps.Remove(map);

        internal IEnumerable<InputAction> EnabledActions() => m_EnabledMaps.SelectMany(m => m.Map.m_Actions.Where(a => a.enabled));

        /// <summary>Callbacks fail one by one, each with its exception in the log.</summary>
        internal static void InvokeSafely(Action callbacks, string name)
        {
            if (callbacks == null)
                return;
            foreach (var callback in callbacks.GetInvocationList())
                try
                {
                    ((Action)callback)();
                }
                catch (Exception e)
                {
                    Debug.LogError($"{e.GetType().Name} while executing '{name}' callbacks");
                    Debug.LogException(e);
                }
        }

        void Take(EventQueue.Event item)
        {
            var device = item.Device;
            if (!device.added)
                return;
            var bytes = new Span<byte>(item.Bytes, 0, item.Size);
            device.Prepare(bytes, item.ByteOffset);
            device.Change(bytes, item.ByteOffset, item.Time, item.Id);
            device.MakeCurrent();
        }

        void ResolveAgain()
        {
            DevicesVersion++;
            foreach (var map in m_EnabledMaps.ToArray())
                map.Resolve();
        }

        string UniqueName(string name)
        {
            var unique = name;
            for (var i = 1; m_Devices.Exists(d => string.Equals(d.name, unique, StringComparison.OrdinalIgnoreCase)); i++)
                unique = name + i;
            return unique;
        }

        void OnPreUpdate()
        {
            if (Settings.updateMode == InputSettings.UpdateMode.ProcessEventsInDynamicUpdate)
                Update(InputUpdateType.Dynamic);
        }

        void OnQuitting()
        {
            foreach (var device in m_Devices.ToList())
                RemoveDevice(device);
            if (m_Settings != null && !m_Settings.IsAsset)
                Object.DestroyImmediate(m_Settings);
        }
    }

    static class ListExtensions
    {
        /// <summary>A copy, as what is done with the items may change the list; none where no item is wanted.</summary>
        internal static T[] ToArrayIfAny<T>(this List<T> list, Predicate<T> wanted) => list.Exists(wanted) ? list.ToArray() : Array.Empty<T>();
    }
}
