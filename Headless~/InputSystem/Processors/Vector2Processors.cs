using System;

namespace UnityEngine.InputSystem.Processors
{
    /// <summary>Times two factors.</summary>
    public class ScaleVector2Processor : InputProcessor<Vector2>
    {
        public float x = 1;
        public float y = 1;

        public override Vector2 Process(Vector2 value, InputControl control) => new(value.x * x, value.y * y);

        public override string ToString() => FormattableString.Invariant($"ScaleVector2(x={x},y={y})");
    }

    /// <summary>The other sign of either number, or of both.</summary>
    public class InvertVector2Processor : InputProcessor<Vector2>
    {
        public bool invertX = true;
        public bool invertY = true;

        public override Vector2 Process(Vector2 value, InputControl control) => new(invertX ? -value.x : value.x, invertY ? -value.y : value.y);

        public override string ToString() => $"InvertVector2(invertX={invertX},invertY={invertY})";
    }

    /// <summary>Of length 1.</summary>
    public class NormalizeVector2Processor : InputProcessor<Vector2>
    {
        public override Vector2 Process(Vector2 value, InputControl control) => value.normalized;

        public override string ToString() => "NormalizeVector2()";
    }

    /// <summary>Nothing near the middle, full length near the rim.</summary>
    public class StickDeadzoneProcessor : InputProcessor<Vector2>
    {
        /// <summary>0 = the settings' default.</summary>
        public float min;

        /// <inheritdoc cref="min"/>
        public float max;

        public override Vector2 Process(Vector2 value, InputControl control = null)
        {
            var length = value.magnitude;
            var changed = Deadzone.Apply(length, min, max);
            return changed == 0f ? Vector2.zero : value * (changed / length);
        }

        public override string ToString() => FormattableString.Invariant($"StickDeadzone(min={Deadzone.Min(min)},max={Deadzone.Max(max)})");
    }
}
