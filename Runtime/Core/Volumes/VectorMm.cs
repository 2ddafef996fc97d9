using System;
using System.Globalization;

namespace AnatomyCarve.Volumes
{
    /// <summary>A displacement or a direction in LPS millimetres, double precision.</summary>
    public readonly struct VectorMm : IEquatable<VectorMm>
    {
        /// <summary>Towards the patient's left, mm.</summary>
        public readonly double X;

        /// <summary>Towards the patient's back, mm.</summary>
        public readonly double Y;

        /// <summary>Towards the patient's head, mm.</summary>
        public readonly double Z;

        /// <summary>Makes a vector from its three coordinates, mm.</summary>
        public VectorMm(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>The squared length, mm².</summary>
        public double LengthSquared => X * X + Y * Y + Z * Z;

        /// <summary>The length, mm.</summary>
        public double Length => Math.Sqrt(LengthSquared);

        /// <summary>True when no coordinate is NaN or infinite.</summary>
        public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z);

        /// <summary>Sum.</summary>
        public static VectorMm operator +(VectorMm a, VectorMm b) => new VectorMm(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        /// <summary>Difference.</summary>
        public static VectorMm operator -(VectorMm a, VectorMm b) => new VectorMm(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        /// <summary>The opposite vector.</summary>
        public static VectorMm operator -(VectorMm a) => new VectorMm(-a.X, -a.Y, -a.Z);

        /// <summary>The vector, scaled.</summary>
        public static VectorMm operator *(VectorMm a, double factor) => new VectorMm(a.X * factor, a.Y * factor, a.Z * factor);

        /// <summary>The vector, scaled.</summary>
        public static VectorMm operator *(double factor, VectorMm a) => a * factor;

        /// <summary>The vector, divided by a number.</summary>
        public static VectorMm operator /(VectorMm a, double divisor) => new VectorMm(a.X / divisor, a.Y / divisor, a.Z / divisor);

        /// <summary>Equal in every coordinate, exactly.</summary>
        public static bool operator ==(VectorMm a, VectorMm b) => a.Equals(b);

        /// <summary>Different in at least one coordinate.</summary>
        public static bool operator !=(VectorMm a, VectorMm b) => !a.Equals(b);

        /// <summary>The scalar product of two vectors.</summary>
        public static double Dot(VectorMm a, VectorMm b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        /// <summary>The vector product of two vectors.</summary>
        public static VectorMm Cross(VectorMm a, VectorMm b) =>
            new VectorMm(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

        /// <summary>The scalar product with another vector.</summary>
        public double Dot(VectorMm other) => Dot(this, other);

        /// <summary>The vector product with another vector.</summary>
        public VectorMm Cross(VectorMm other) => Cross(this, other);

        /// <summary>The vector of length 1 in the same direction; the zero vector stays zero.</summary>
        public VectorMm Normalized()
        {
            double length = Length;
            return length > 0 ? this / length : this;
        }

        /// <inheritdoc/>
        public bool Equals(VectorMm other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is VectorMm other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(X, Y, Z);

        /// <summary>"(x, y, z) mm", in the invariant culture.</summary>
        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "({0:0.###}, {1:0.###}, {2:0.###}) mm", X, Y, Z);
    }
}
