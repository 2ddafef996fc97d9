using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>A point of a transfer function. Immutable.</summary>
    public readonly struct TransferPoint : IEquatable<TransferPoint>
    {
        /// <summary>The intensity, in the scan's unit (Hounsfield units for CT).</summary>
        public readonly double Value;

        /// <summary>The opacity of a path of one reference length, 0 to 1.</summary>
        public readonly double Opacity;

        /// <summary>Makes a point.</summary>
        /// <param name="value">The intensity; finite.</param>
        /// <param name="opacity">0 to 1.</param>
        /// <exception cref="ArgumentException">The value is not finite, or the opacity outside 0..1.</exception>
        public TransferPoint(double value, double opacity)
        {
            if (!double.IsFinite(value))
                throw new ArgumentException(FormattableString.Invariant($"A transfer function's value is a finite number, not {value}."), nameof(value));

            // Written so that NaN fails too.
            if (!(opacity >= 0 && opacity <= 1))
                throw new ArgumentException(FormattableString.Invariant($"An opacity is 0 to 1, not {opacity}."), nameof(opacity));
            Value = value;
            Opacity = opacity;
        }

        /// <summary>Equal in both numbers.</summary>
        public static bool operator ==(TransferPoint a, TransferPoint b) => a.Equals(b);

        /// <summary>Different in at least one number.</summary>
        public static bool operator !=(TransferPoint a, TransferPoint b) => !a.Equals(b);

        /// <inheritdoc/>
        public bool Equals(TransferPoint other) => Value.Equals(other.Value) && Opacity.Equals(other.Opacity);

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is TransferPoint other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Value, Opacity);

        /// <summary>"value:opacity", in the invariant culture.</summary>
        public override string ToString() => FormattableString.Invariant($"{Value}:{Opacity}");
    }
}
