using System;

namespace UnityEngine.InputSystem
{
    /// <summary>What happened to a device.</summary>
    public enum InputDeviceChange
    {
        Added,
        Removed,
        Disconnected,
        Reconnected,
        Enabled,
        Disabled,
        UsageChanged,
        ConfigurationChanged,
        SoftReset,
        HardReset,

        [Obsolete("Destroyed enum has been deprecated.")]
        Destroyed,
    }
}
