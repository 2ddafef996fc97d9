using UnityEngine.InputSystem.LowLevel;
using UnityEngine.InputSystem.Processors;

namespace UnityEngine.InputSystem.Controls
{
    /// <summary>One number, usually 0 to 1 or -1 to 1.</summary>
    public unsafe class AxisControl : InputControl<float>
    {
        public Clamp clamp;
        public float clampMin;
        public float clampMax;
        public float clampConstant;
        public bool invert;
        public bool normalize;
        public float normalizeMin;
        public float normalizeMax;
        public float normalizeZero;
        public bool scale;
        public float scaleFactor;

        public AxisControl() => m_StateBlock.format = InputStateBlock.FormatFloat;

        /// <summary>When the value is kept within <see cref="clampMin"/> and <see cref="clampMax"/>.</summary>
        public enum Clamp
        {
            None = 0,
            BeforeNormalize = 1,
            AfterNormalize = 2,
            ToConstantBeforeNormalize = 3,
        }

        public override float ReadUnprocessedValueFromState(void* statePtr) => Preprocess(m_StateBlock.ReadFloat(statePtr));

        public override void WriteValueIntoState(float value, void* statePtr)
        {
            if (invert)
                value = -value;
            if (normalize)
                value = normalizeZero == normalizeMin
                    ? normalizeMin + value * (normalizeMax - normalizeMin)
                    : normalizeMin + (value + 1f) / 2f * (normalizeMax - normalizeMin);
            if (scale)
                value /= scaleFactor;
            m_StateBlock.WriteFloat(statePtr, value);
        }

        public override float EvaluateMagnitude(void* statePtr) => Mathf.Abs(ReadValueFromState(statePtr));

        protected float Preprocess(float value)
        {
            if (scale)
                value *= scaleFactor;
            if (clamp == Clamp.ToConstantBeforeNormalize && (value < clampMin || value > clampMax))
                value = clampConstant;
            else if (clamp == Clamp.BeforeNormalize)
                value = Mathf.Clamp(value, clampMin, clampMax);
            if (normalize)
                value = NormalizeProcessor.Normalize(value, normalizeMin, normalizeMax, normalizeZero);
            if (clamp == Clamp.AfterNormalize)
                value = Mathf.Clamp(value, clampMin, clampMax);
            return invert ? -value : value;
        }
    }
}
