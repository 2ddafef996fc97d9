using System;
using UnityEngine;

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

        /// <returns>The colour.</returns>
        /// <exception cref="ArgumentOutOfRangeException">A channel is negative, infinite or NaN.</exception>
        public static Color Checked(Color value, string name) => IsColor(value)
            ? value
            : throw new ArgumentOutOfRangeException(name, value, $"The channels of {name} are finite and not negative.");

        /// <summary>Whether red, green and blue are finite and not negative.</summary>
        public static bool IsColor(Color value) =>
            value.r >= 0f && value.g >= 0f && value.b >= 0f && !float.IsInfinity(value.r) && !float.IsInfinity(value.g) && !float.IsInfinity(value.b);

        /// <returns>The value.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The enum has no such value.</exception>
        public static T Defined<T>(T value, string name) where T : struct, Enum => Enum.IsDefined(typeof(T), value)
            ? value
            : throw new ArgumentOutOfRangeException(name, value, $"{name} is {string.Join(", ", Enum.GetNames(typeof(T)))}.");
    }
}
