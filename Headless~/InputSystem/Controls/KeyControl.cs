namespace UnityEngine.InputSystem.Controls
{
    /// <summary>A key of a keyboard.</summary>
    public class KeyControl : ButtonControl
    {
        public Key keyCode { get; set; }
    }

    /// <summary>Down while any key is.</summary>
    public unsafe class AnyKeyControl : ButtonControl
    {
        public override float ReadUnprocessedValueFromState(void* statePtr) =>
            m_StateBlock.SameIn((byte*)statePtr, (byte*)defaultStatePtr) ? 0f : 1f;
    }
}
