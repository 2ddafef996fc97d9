using System;

namespace AnatomyCarve
{
    /// <summary>The checks of settings.</summary>
    static class SettingRange
    {
        /// <returns>The value.</returns>
        /// <exception cref="ArgumentOutOfRangeException">It lies outside, or is NaN.</exception>
        public static float Checked(float value, float min, float max, string name) => value >= min && value <= max
            ? value
            : throw new ArgumentOutOfRangeException(name, value, FormattableString.Invariant($"{name} is {min} to {max}."));

        /// <returns>The value.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The enum has no such value.</exception>
        public static T Defined<T>(T value, string name) where T : struct, Enum => Enum.IsDefined(typeof(T), value)
            ? value
            : throw new ArgumentOutOfRangeException(name, value, $"{name} is {string.Join(", ", Enum.GetNames(typeof(T)))}.");
    }
}
