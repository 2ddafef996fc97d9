using System;

namespace UnityEngine
{
    /// <summary>IEEE 754 binary16, which .NET Standard 2.1 has no type for. Rounds half to even.</summary>
    static class HalfFloat
    {
        internal static ushort FromSingle(float value)
        {
            var bits = (uint)BitConverter.SingleToInt32Bits(value);
            var sign = (ushort)(bits >> 16 & 0x8000);
            var rest = bits & 0x7fffffff;
            if (rest > 0x7f800000)
                return (ushort)(sign | 0x7e00);
            if (rest >= 0x477ff000)
                return (ushort)(sign | 0x7c00);
            if (rest < 0x38800000)
            {
                // Subnormal: the value in units of 2^-24.
                var units = Math.Round(Math.Abs((double)value) * 16777216.0, MidpointRounding.ToEven);
                return (ushort)(sign | (ushort)units);
            }

            var rounded = rest + 0xfff + (rest >> 13 & 1);
            return (ushort)(sign | (rounded - 0x38000000) >> 13);
        }

        internal static float ToSingle(ushort half)
        {
            var sign = (uint)(half & 0x8000) << 16;
            var exponent = half >> 10 & 0x1f;
            var mantissa = (uint)(half & 0x3ff);
            if (exponent == 0)
                return (sign == 0 ? 1f : -1f) * mantissa / 16777216f;
            var bits = exponent == 31 ? sign | 0x7f800000 | mantissa << 13 : sign | (uint)(exponent + 112) << 23 | mantissa << 13;
            return BitConverter.Int32BitsToSingle((int)bits);
        }
    }
}
