using System;
using System.Globalization;

namespace UnityEngine
{
    /// <summary>How Unity writes its value types: components in parentheses, two decimals, the invariant culture.</summary>
    static class Format
    {
        internal static string Tuple(string format, IFormatProvider provider, string fallback, params float[] values)
        {
            format = string.IsNullOrEmpty(format) ? fallback : format;
            provider ??= CultureInfo.InvariantCulture.NumberFormat;
            return "(" + string.Join(", ", Array.ConvertAll(values, v => v.ToString(format, provider))) + ")";
        }

        internal static string Tuple(string format, IFormatProvider provider, params int[] values)
        {
            provider ??= CultureInfo.InvariantCulture.NumberFormat;
            return "(" + string.Join(", ", Array.ConvertAll(values, v => v.ToString(format, provider))) + ")";
        }
    }
}
