using System;

namespace UnityEngine.InputSystem.Processors
{
    /// <summary>Times a factor.</summary>
    public class ScaleProcessor : InputProcessor<float>
    {
        public float factor = 1;

        public override float Process(float value, InputControl control) => value * factor;

        public override string ToString() => FormattableString.Invariant($"Scale(factor={factor})");
    }

    /// <summary>The other sign.</summary>
    public class InvertProcessor : InputProcessor<float>
    {
        public override float Process(float value, InputControl control) => -value;

        public override string ToString() => "Invert()";
    }

    /// <summary>Kept within a range.</summary>
    public class ClampProcessor : InputProcessor<float>
    {
        public float min;
        public float max;

        public override float Process(float value, InputControl control) => Mathf.Clamp(value, min, max);

        public override string ToString() => FormattableString.Invariant($"Clamp(min={min},max={max})");
    }

    /// <summary>A range to 0..1, or to -1..1 where its zero lies inside.</summary>
    public class NormalizeProcessor : InputProcessor<float>
    {
        public float min;
        public float max;
        public float zero;

        public static float Normalize(float value, float min, float max, float zero)
        {
            var isSigned = min < Mathf.Max(zero, min);
            if (Mathf.Approximately(value, min))
                return isSigned ? -1f : 0f;
            var share = (value - min) / (max - min);
            return isSigned ? 2f * share - 1f : share;
        }

        public override float Process(float value, InputControl control) => Normalize(value, min, max, zero);

        public override string ToString() => FormattableString.Invariant($"Normalize(min={min},max={max},zero={zero})");
    }

    /// <summary>Nothing below a limit, everything above another one.</summary>
    public class AxisDeadzoneProcessor : InputProcessor<float>
    {
        /// <summary>0 = the settings' default.</summary>
        public float min;

        /// <inheritdoc cref="min"/>
        public float max;

        public override float Process(float value, InputControl control = null) => Deadzone.Apply(value, min, max);

        public override string ToString() => FormattableString.Invariant($"AxisDeadzone(min={Deadzone.Min(min)},max={Deadzone.Max(max)})");
    }

    static class Deadzone
    {
        internal static float Min(float min) => min == 0f ? InputManager.Instance.Settings.defaultDeadzoneMin : min;

        internal static float Max(float max) => max == 0f ? InputManager.Instance.Settings.defaultDeadzoneMax : max;

        internal static float Apply(float value, float min, float max)
        {
            var size = Mathf.Abs(value);
            if (size < Min(min))
                return 0f;
            return Mathf.Sign(value) * (size > Max(max) ? 1f : (size - Min(min)) / (Max(max) - Min(min)));
        }
    }
}
