using UnityEngine.InputSystem.LowLevel;

namespace UnityEngine.InputSystem.Controls
{
    /// <summary>A whole number.</summary>
    public unsafe class IntegerControl : InputControl<int>
    {
        public IntegerControl() => m_StateBlock.format = InputStateBlock.FormatInt;

        public override int ReadUnprocessedValueFromState(void* statePtr) => m_StateBlock.ReadInt(statePtr);

        public override void WriteValueIntoState(int value, void* statePtr) => m_StateBlock.WriteInt(statePtr, value);
    }
}
