using System;

namespace AnatomyCarve.Editor
{
    /// <summary>The range of intensities that a plot shows. Immutable.</summary>
    readonly struct ValueWindow : IEquatable<ValueWindow>
    {
        /// <summary>How much nearer than the widest window one can look.</summary>
        const double DeepestZoom = 10000;

        /// <summary>Takes a range; one without extent is widened to 1 around its middle.</summary>
        /// <exception cref="ArgumentException">A bound is not finite, or the upper one lies below the lower one.</exception>
        public ValueWindow(double min, double max)
        {
            if (!double.IsFinite(min) || !double.IsFinite(max) || max < min)
                throw new ArgumentException(FormattableString.Invariant($"A window is a finite range, not {min} to {max}."), nameof(max));
            bool extended = max > min;
            Min = extended ? min : min - 0.5;
            Max = extended ? max : max + 0.5;
        }

        /// <summary>The value at the left edge.</summary>
        public double Min { get; }

        /// <summary>The value at the right edge.</summary>
        public double Max { get; }

        public double Width => Max - Min;

        /// <summary>0 at the left edge, 1 at the right one, beyond that outside.</summary>
        public double FractionOf(double value) => (value - Min) / Width;

        public double ValueAt(double fraction) => Min + fraction * Width;

        /// <summary>The window that holds both.</summary>
        public ValueWindow United(ValueWindow other) => new ValueWindow(Math.Min(Min, other.Min), Math.Max(Max, other.Max));

        /// <summary>Wider on both sides by a share of its width.</summary>
        public ValueWindow WithMargin(double share) => new ValueWindow(Min - share * Width, Max + share * Width);

        /// <summary>A window in which one value stays where it is.</summary>
        /// <param name="factor">The new width over the old one: above 0.</param>
        /// <param name="fixedValue">The value that stays in its place.</param>
        /// <param name="widest">What can be looked at; the result lies within.</param>
        public ValueWindow Zoomed(double factor, double fixedValue, ValueWindow widest)
        {
            double width = Math.Min(Math.Max(Width * factor, widest.Width / DeepestZoom), widest.Width);
            double min = fixedValue - FractionOf(fixedValue) * width;
            return new ValueWindow(min, min + width).Within(widest);
        }

        /// <summary>A window of the same width elsewhere, as far as the widest one lets it.</summary>
        public ValueWindow Panned(double byValue, ValueWindow widest) => new ValueWindow(Min + byValue, Max + byValue).Within(widest);

        public bool Equals(ValueWindow other) => Min.Equals(other.Min) && Max.Equals(other.Max);

        public override bool Equals(object obj) => obj is ValueWindow other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(Min, Max);

        /// <summary>Moved, and narrowed if it has to be, so that it lies within another one.</summary>
        public ValueWindow Within(ValueWindow widest)
        {
            double width = Math.Min(Width, widest.Width);
            double min = Math.Max(widest.Min, Math.Min(Min, widest.Max - width));
            return new ValueWindow(min, Math.Min(min + width, widest.Max));
        }
    }
}
