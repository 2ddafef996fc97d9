using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem.LowLevel
{
    /// <summary>A struct that is a device's state as it lies in memory.</summary>
    public interface IInputStateTypeInfo
    {
        FourCC format { get; }
    }
}
