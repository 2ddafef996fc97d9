using System;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// What the three-dimensional FXAA of opacities is steered by; the same numbers go to the kernel and to its CPU twin, <see cref="AntiAlias"/>.
    /// Immutable; equal when all four numbers are equal.
    /// </summary>
    public sealed class AntiAliasSettings : IEquatable<AntiAliasSettings>
    {
        /// <summary>The default of <see cref="ThresholdAbsolute"/>: a sixteenth of the opacity range.</summary>
        public const float DefaultThresholdAbsolute = 0.0625f;

        /// <summary>The default of <see cref="ThresholdRelative"/>: an eighth of the neighbourhood's maximum.</summary>
        public const float DefaultThresholdRelative = 0.125f;

        /// <summary>The default of <see cref="GradientMinimum"/>. A full step of opacity has a gradient of 0.5.</summary>
        public const float DefaultGradientMinimum = 0.06f;

        /// <summary>The default of <see cref="Strength"/>: the whole blend.</summary>
        public const float DefaultStrength = 1f;

        /// <summary>Makes settings.</summary>
        /// <exception cref="ArgumentOutOfRangeException">A number is not 0 to 1.</exception>
        public AntiAliasSettings(
            float thresholdAbsolute = DefaultThresholdAbsolute,
            float thresholdRelative = DefaultThresholdRelative,
            float gradientMinimum = DefaultGradientMinimum,
            float strength = DefaultStrength)
        {
            ThresholdAbsolute = Checked(thresholdAbsolute, nameof(thresholdAbsolute));
            ThresholdRelative = Checked(thresholdRelative, nameof(thresholdRelative));
            GradientMinimum = Checked(gradientMinimum, nameof(gradientMinimum));
            Strength = Checked(strength, nameof(strength));
        }

        /// <summary>The settings that the package uses unless told otherwise.</summary>
        public static AntiAliasSettings Default { get; } = new AntiAliasSettings();

        /// <summary>No anti-aliasing: every voxel keeps its opacity.</summary>
        public static AntiAliasSettings Off { get; } = new AntiAliasSettings(strength: 0);

        /// <summary>A neighbourhood whose opacities differ by less stays as it is: 0 to 1.</summary>
        public float ThresholdAbsolute { get; }

        /// <summary>A neighbourhood whose opacities differ by less than this share of their maximum stays as it is: 0 to 1.</summary>
        public float ThresholdRelative { get; }

        /// <summary>A voxel with a smaller gradient (opacity per voxel) stays as it is: the ridge of a thin structure has none. 0 to 1.</summary>
        public float GradientMinimum { get; }

        /// <summary>0 = no change, 1 = the whole blend.</summary>
        public float Strength { get; }

        /// <inheritdoc/>
        public bool Equals(AntiAliasSettings other) =>
            other is object
            && ThresholdAbsolute.Equals(other.ThresholdAbsolute)
            && ThresholdRelative.Equals(other.ThresholdRelative)
            && GradientMinimum.Equals(other.GradientMinimum)
            && Strength.Equals(other.Strength);

        /// <inheritdoc/>
        public override bool Equals(object obj) => Equals(obj as AntiAliasSettings);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(ThresholdAbsolute, ThresholdRelative, GradientMinimum, Strength);

        static float Checked(float value, string argument)
        {
            if (!(value >= 0 && value <= 1))
                throw new ArgumentOutOfRangeException(argument, value, "The number is 0 to 1.");
            return value;
        }
    }
}
