using System;

namespace AnatomyCarve
{
    /// <summary>The check of a setting that has a range.</summary>
    static class SettingRange
    {
        /// <returns>The value.</returns>
        /// <exception cref="ArgumentOutOfRangeException">It lies outside, or is NaN.</exception>
        public static float Checked(float value, float min, float max, string name) => value >= min && value <= max
            ? value
            : throw new ArgumentOutOfRangeException(name, value, FormattableString.Invariant($"{name} is {min} to {max}."));
    }
}
