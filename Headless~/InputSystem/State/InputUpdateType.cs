using System;

namespace UnityEngine.InputSystem.LowLevel
{
    /// <summary>When input is taken in.</summary>
    [Flags]
    public enum InputUpdateType
    {
        None = 0,
        Dynamic = 1 << 0,
        Fixed = 1 << 1,
        BeforeRender = 1 << 2,
        Editor = 1 << 3,
        Manual = 1 << 4,
        Default = Dynamic | Fixed | Editor,
    }
}
