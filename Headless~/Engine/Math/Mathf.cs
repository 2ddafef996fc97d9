using System;

namespace UnityEngine
{
    /// <summary>Single-precision functions.</summary>
    public struct Mathf
    {
        public const float PI = 3.1415927f;
        public const float Infinity = float.PositiveInfinity;
        public const float NegativeInfinity = float.NegativeInfinity;
        public const float Deg2Rad = PI / 180f;
        public const float Rad2Deg = 57.29578f;

        /// <summary>The smallest float above 0.</summary>
        public static readonly float Epsilon = float.Epsilon;

        public static float Sin(float f) => (float)Math.Sin(f);
        public static float Cos(float f) => (float)Math.Cos(f);
        public static float Tan(float f) => (float)Math.Tan(f);
        public static float Asin(float f) => (float)Math.Asin(f);
        public static float Acos(float f) => (float)Math.Acos(f);
        public static float Atan(float f) => (float)Math.Atan(f);
        public static float Atan2(float y, float x) => (float)Math.Atan2(y, x);
        public static float Sqrt(float f) => (float)Math.Sqrt(f);
        public static float Pow(float f, float p) => (float)Math.Pow(f, p);
        public static float Exp(float power) => (float)Math.Exp(power);
        public static float Log(float f) => (float)Math.Log(f);
        public static float Log(float f, float p) => (float)Math.Log(f, p);
        public static float Log10(float f) => (float)Math.Log10(f);
        public static float Abs(float f) => Math.Abs(f);
        public static int Abs(int value) => Math.Abs(value);
        public static float Ceil(float f) => (float)Math.Ceiling(f);
        public static float Floor(float f) => (float)Math.Floor(f);

        /// <summary>Nearest integer; halves go to the even one.</summary>
        public static float Round(float f) => (float)Math.Round(f);

        public static int CeilToInt(float f) => (int)Math.Ceiling(f);
        public static int FloorToInt(float f) => (int)Math.Floor(f);
        public static int RoundToInt(float f) => (int)Math.Round(f);

        /// <summary>1 for 0 and above, otherwise -1.</summary>
        public static float Sign(float f) => f >= 0f ? 1f : -1f;

        // Written as comparisons, not Math.Min: with a NaN on the left Unity answers with the right one.
        public static float Min(float a, float b) => a < b ? a : b;
        public static int Min(int a, int b) => a < b ? a : b;
        public static float Max(float a, float b) => a > b ? a : b;
        public static int Max(int a, int b) => a > b ? a : b;

        public static float Min(params float[] values)
        {
            var result = values.Length == 0 ? 0f : values[0];
            foreach (var v in values)
                result = v < result ? v : result;
            return result;
        }

        public static int Min(params int[] values)
        {
            var result = values.Length == 0 ? 0 : values[0];
            foreach (var v in values)
                result = Math.Min(result, v);
            return result;
        }

        public static float Max(params float[] values)
        {
            var result = values.Length == 0 ? 0f : values[0];
            foreach (var v in values)
                result = v > result ? v : result;
            return result;
        }

        public static int Max(params int[] values)
        {
            var result = values.Length == 0 ? 0 : values[0];
            foreach (var v in values)
                result = Math.Max(result, v);
            return result;
        }

        public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;
        public static int Clamp(int value, int min, int max) => value < min ? min : value > max ? max : value;
        public static float Clamp01(float value) => value < 0f ? 0f : value > 1f ? 1f : value;
        public static float Lerp(float a, float b, float t) => a + (b - a) * Clamp01(t);
        public static float LerpUnclamped(float a, float b, float t) => a + (b - a) * t;
        public static float InverseLerp(float a, float b, float value) => a == b ? 0f : Clamp01((value - a) / (b - a));
        public static float LerpAngle(float a, float b, float t) => a + DeltaAngle(a, b) * Clamp01(t);

        public static float SmoothStep(float from, float to, float t)
        {
            t = Clamp01(t);
            t = t * t * (3f - 2f * t);
            return to * t + from * (1f - t);
        }

        public static float MoveTowards(float current, float target, float maxDelta) =>
            Abs(target - current) <= maxDelta ? target : current + Sign(target - current) * maxDelta;

        public static float MoveTowardsAngle(float current, float target, float maxDelta)
        {
            var delta = DeltaAngle(current, target);
            return -maxDelta < delta && delta < maxDelta ? target : MoveTowards(current, current + delta, maxDelta);
        }

        /// <summary>The remainder in [0, length].</summary>
        public static float Repeat(float t, float length) => Clamp(t - Floor(t / length) * length, 0f, length);

        public static float PingPong(float t, float length) => length - Abs(Repeat(t, length * 2f) - length);

        /// <summary>The shortest turn in degrees, in (-180, 180].</summary>
        public static float DeltaAngle(float current, float target)
        {
            var delta = Repeat(target - current, 360f);
            return delta > 180f ? delta - 360f : delta;
        }

        public static bool Approximately(float a, float b) => Abs(b - a) < Max(1E-06f * Max(Abs(a), Abs(b)), Epsilon * 8f);

        public static float Gamma(float value, float absmax, float gamma)
        {
            var size = Abs(value);
            if (size > absmax)
                return value;
            var result = Pow(size / absmax, gamma) * absmax;
            return value < 0f ? -result : result;
        }

        /// <summary>sRGB's curve, from stored to linear; beyond 1 a power of 2.2.</summary>
        public static float GammaToLinearSpace(float value) =>
            value <= 0.04045f ? value / 12.92f : value < 1f ? Pow((value + 0.055f) / 1.055f, 2.4f) : value == 1f ? 1f : Pow(value, 2.2f);

        /// <summary>sRGB's curve, from linear to stored; beyond 1 a power of 1/2.2.</summary>
        public static float LinearToGammaSpace(float value) =>
            value <= 0f ? 0f : value <= 0.0031308f ? 12.92f * value : value < 1f ? 1.055f * Pow(value, 1f / 2.4f) - 0.055f : value == 1f ? 1f
                : Pow(value, 1f / 2.2f);

        public static bool IsPowerOfTwo(int value) => (value & (value - 1)) == 0;

        public static int NextPowerOfTwo(int value)
        {
            var v = (uint)(value - 1);
            v |= v >> 1;
            v |= v >> 2;
            v |= v >> 4;
            v |= v >> 8;
            v |= v >> 16;
            return (int)(v + 1);
        }

        public static int ClosestPowerOfTwo(int value)
        {
            var next = NextPowerOfTwo(value);
            var previous = next >> 1;
            return value - previous < next - value ? previous : next;
        }

        public static ushort FloatToHalf(float val) => HalfFloat.FromSingle(val);

        public static float HalfToFloat(ushort val) => HalfFloat.ToSingle(val);

        /// <summary>Moves towards a target like a critically damped spring, without overshooting it.</summary>
        public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
        {
            smoothTime = Max(0.0001f, smoothTime);
            var omega = 2f / smoothTime;
            var x = omega * deltaTime;
            var decay = 1f / (1f + x + 0.48f * x * x + 0.235f * x * x * x);
            var limit = maxSpeed * smoothTime;
            var change = Clamp(current - target, -limit, limit);
            var reachable = current - change;
            var push = (currentVelocity + omega * change) * deltaTime;
            currentVelocity = (currentVelocity - omega * push) * decay;
            var result = reachable + (change + push) * decay;
            if (target - current > 0f != result > target)
                return result;
            currentVelocity = 0f;
            return target;
        }
    }
}
