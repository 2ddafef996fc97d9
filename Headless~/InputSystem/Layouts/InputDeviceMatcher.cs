namespace UnityEngine.InputSystem.Layouts
{
    /// <summary>Which devices that the platform reports a layout is for. The host's devices are all made by scripts, so it is only in signatures.</summary>
    public struct InputDeviceMatcher
    {
    }
}
