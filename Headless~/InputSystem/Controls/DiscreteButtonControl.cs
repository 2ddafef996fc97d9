using System;

namespace UnityEngine.InputSystem.Controls
{
    /// <summary>A button that is down while a whole number lies within a range, such as either of two Shift keys.</summary>
    public unsafe class DiscreteButtonControl : ButtonControl
    {
        public int minValue;
        public int maxValue;
        public int wrapAtValue;
        public int nullValue;
        public WriteMode writeMode;

        /// <summary>What writing does.</summary>
        public enum WriteMode
        {
            WriteDisabled = 0,
            WriteNullAndMaxValue = 1,
        }

        public override float ReadUnprocessedValueFromState(void* statePtr)
        {
            var number = m_StateBlock.ReadInt(statePtr);
            // A range whose end lies before its beginning goes through the wrap, as that of a hat switch does.
            var within = minValue <= maxValue
                ? number >= minValue && number <= maxValue
                : (number >= minValue && number <= wrapAtValue) || (number != nullValue && number <= maxValue);
            return Preprocess(within ? 1f : 0f);
        }

        public override void WriteValueIntoState(float value, void* statePtr)
        {
            if (writeMode != WriteMode.WriteNullAndMaxValue)
                throw new NotSupportedException($"'{this}' cannot be written: several states mean that it is down");
            m_StateBlock.WriteInt(statePtr, value >= pressPointOrDefault ? maxValue : nullValue);
        }
    }
}
