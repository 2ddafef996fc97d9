using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.InputSystem.Layouts;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem
{
    /// <summary>Devices, events and registrations. Events are taken in once a frame, before Update.</summary>
    public static class InputSystem
    {
        static InputManager Manager => InputManager.Instance;

        /// <summary>Raised when a device was added, removed or got another usage.</summary>
        public static event Action<InputDevice, InputDeviceChange> onDeviceChange
        {
            add => Manager.DeviceChange += value;
            remove => Manager.DeviceChange -= value;
        }

        /// <summary>Raised in each update, before its events.</summary>
        public static event Action onBeforeUpdate
        {
            add => Manager.BeforeUpdate += value;
            remove => Manager.BeforeUpdate -= value;
        }

        /// <summary>Raised in each update, after its events.</summary>
        public static event Action onAfterUpdate
        {
            add => Manager.AfterUpdate += value;
            remove => Manager.AfterUpdate -= value;
        }

        public static Version version => new(1, 14, 0);

        public static ReadOnlyArray<InputDevice> devices => Manager.Devices;

        public static InputSettings settings
        {
            get => Manager.Settings;
            set => Manager.Settings = value;
        }

        public static void RegisterLayout(Type type, string name = null, InputDeviceMatcher? matches = null)
        {
            if (matches != null)
                throw new NotSupportedException("Layouts that are found by a device's description are not implemented headless");
            Manager.Layouts.AddLayout(type, name);
        }

        public static void RegisterLayout<T>(string name = null, InputDeviceMatcher? matches = null) where T : InputControl =>
            RegisterLayout(typeof(T), name, matches);

        public static void RemoveLayout(string name) => Manager.Layouts.RemoveLayout(name);

        public static void RegisterProcessor(Type type, string name = null) => Manager.Layouts.AddProcessor(type, name);

        public static void RegisterProcessor<T>(string name = null) => RegisterProcessor(typeof(T), name);

        public static void RegisterBindingComposite(Type type, string name) => Manager.Layouts.AddComposite(type, name);

        public static void RegisterBindingComposite<T>(string name = null) => RegisterBindingComposite(typeof(T), name);

        public static Type TryGetProcessor(string name) => Manager.Layouts.Processor(name);

        public static Type TryGetBindingComposite(string name) => Manager.Layouts.Composite(name);

        public static bool IsFirstLayoutBasedOnSecond(string firstLayoutName, string secondLayoutName) =>
            Manager.Layouts.IsBasedOn(firstLayoutName, secondLayoutName);

        public static IEnumerable<string> ListLayouts() => Manager.Layouts.Layouts;

        public static IEnumerable<string> ListProcessors() => Manager.Layouts.Processors;

        /// <exception cref="ArgumentException">There is no such layout, or it is no device's.</exception>
        public static InputDevice AddDevice(string layout, string name = null, string variants = null)
        {
            if (string.IsNullOrEmpty(layout))
                throw new ArgumentNullException(nameof(layout));
            if (!string.IsNullOrEmpty(variants))
                throw new NotSupportedException("Variants of layouts are not implemented headless");
            return Manager.AddDevice(layout, name);
        }

        public static TDevice AddDevice<TDevice>(string name = null) where TDevice : InputDevice
        {
            var layout = Manager.Layouts.RegisteredName(typeof(TDevice));
            if (layout == null)
                RegisterLayout(typeof(TDevice), layout = typeof(TDevice).Name);
            return (TDevice)Manager.AddDevice(layout, name);
        }

        public static void RemoveDevice(InputDevice device) => Manager.RemoveDevice(device ?? throw new ArgumentNullException(nameof(device)));

        /// <summary>The device of that name or layout; null if there is none.</summary>
        public static InputDevice GetDevice(string nameOrLayout) =>
            Array.Find(Manager.Devices, d => Same(d.name, nameOrLayout)) ?? Array.Find(Manager.Devices, d => Same(d.layout, nameOrLayout));

        public static TDevice GetDevice<TDevice>() where TDevice : InputDevice => Manager.Devices.OfType<TDevice>().LastOrDefault();

        public static TDevice GetDevice<TDevice>(string usage) where TDevice : InputDevice => Manager.DeviceWithUsage<TDevice>(usage);

        public static InputDevice GetDeviceById(int deviceId) => Array.Find(Manager.Devices, d => d.deviceId == deviceId);

        public static void SetDeviceUsage(InputDevice device, string usage) =>
            ChangeUsages(device, _ => string.IsNullOrEmpty(usage) ? Array.Empty<InternedString>() : new[] { new InternedString(usage) });

        public static void AddDeviceUsage(InputDevice device, string usage) =>
            ChangeUsages(device, known => known.Append(new InternedString(Checked(usage))).Distinct().ToArray());

        public static void RemoveDeviceUsage(InputDevice device, string usage) =>
            ChangeUsages(device, known => known.Where(u => u != Checked(usage)).ToArray());

        /// <summary>The first control of any device that a path means; null if there is none.</summary>
        public static InputControl FindControl(string path)
        {
            if (path == null)
                throw new ArgumentNullException(nameof(path));
            return InputControlPath.FindIn(Manager.Devices, path).FirstOrDefault();
        }

        /// <summary>The device's whole state comes in with the next update.</summary>
        /// <exception cref="ArgumentException">The state is that of another kind of device.</exception>
        /// <exception cref="InvalidOperationException">The system does not have the device.</exception>
        public static void QueueStateEvent<TState>(InputDevice device, TState state, double time = -1) where TState : struct, IInputStateTypeInfo
        {
            if (device == null)
                throw new ArgumentNullException(nameof(device));
            if (device.stateBlock.format != state.format)
                throw new ArgumentException($"State of format '{state.format}' for '{device}', whose format is '{device.stateBlock.format}': Unity would drop it");
            Manager.Queue(device, 0, state, time);
        }

        /// <summary>The state of a control, which has whole bytes, comes in with the next update.</summary>
        /// <exception cref="InvalidOperationException">The control has a part of a byte only.</exception>
        public static void QueueDeltaStateEvent<TDelta>(InputControl control, TDelta delta, double time = -1) where TDelta : struct
        {
            if (control == null)
                throw new ArgumentNullException(nameof(control));
            if (control.stateBlock.bitOffset != 0)
                throw new InvalidOperationException($"Cannot send delta state events against bitfield controls: {control}");
            if (Values.SizeOf<TDelta>() > control.stateBlock.SizeInBytes)
                throw new ArgumentException($"Size {Values.SizeOf<TDelta>()} of delta state of type {typeof(TDelta).Name} is too large for '{control}'", nameof(delta));
            Manager.Queue(control.device, control.stateBlock.byteOffset, delta, time);
        }

        /// <summary>Takes in what is queued, now.</summary>
        public static void Update() => Manager.Update(
            settings.updateMode == InputSettings.UpdateMode.ProcessEventsManually ? InputUpdateType.Manual : InputUpdateType.Dynamic);

        public static List<InputAction> ListEnabledActions() => Manager.EnabledActions().ToList();

        public static void DisableAllEnabledActions()
        {
            foreach (var action in ListEnabledActions())
                action.Disable();
        }

        static void ChangeUsages(InputDevice device, Func<InternedString[], InternedString[]> change)
        {
            if (device == null)
                throw new ArgumentNullException(nameof(device));
            Manager.ChangeUsages(device, () => device.m_Usages = change(device.m_Usages));
        }

        static string Checked(string usage) => string.IsNullOrEmpty(usage) ? throw new ArgumentNullException(nameof(usage)) : usage;

        static bool Same(string a, string b) => string.Equals(a, b, StringComparison.OrdinalIgnoreCase);
    }
}
