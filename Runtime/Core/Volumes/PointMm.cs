using System;
using System.Globalization;

namespace AnatomyCarve.Volumes
{
    /// <summary>A place in the patient: LPS millimetres (+x Left, +y Posterior, +z Superior), double precision.</summary>
    public readonly struct PointMm : IEquatable<PointMm>
    {
        /// <summary>Towards the patient's left, mm.</summary>
        public readonly double X;

        /// <summary>Towards the patient's back, mm.</summary>
        public readonly double Y;

        /// <summary>Towards the patient's head, mm.</summary>
        public readonly double Z;

        /// <summary>Makes a point from its three coordinates, mm.</summary>
        public PointMm(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>True when no coordinate is NaN or infinite.</summary>
        public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z);

        /// <summary>The point moved by a vector.</summary>
        public static PointMm operator +(PointMm point, VectorMm vector) =>
            new PointMm(point.X + vector.X, point.Y + vector.Y, point.Z + vector.Z);

        /// <summary>The point moved against a vector.</summary>
        public static PointMm operator -(PointMm point, VectorMm vector) =>
            new PointMm(point.X - vector.X, point.Y - vector.Y, point.Z - vector.Z);

        /// <summary>The vector from <paramref name="from"/> to <paramref name="to"/>.</summary>
        public static VectorMm operator -(PointMm to, PointMm from) =>
            new VectorMm(to.X - from.X, to.Y - from.Y, to.Z - from.Z);

        /// <summary>Equal in every coordinate, exactly.</summary>
        public static bool operator ==(PointMm a, PointMm b) => a.Equals(b);

        /// <summary>Different in at least one coordinate.</summary>
        public static bool operator !=(PointMm a, PointMm b) => !a.Equals(b);

        /// <summary>The distance to another point, mm.</summary>
        public double DistanceTo(PointMm other) => (other - this).Length;

        /// <inheritdoc/>
        public bool Equals(PointMm other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is PointMm other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(X, Y, Z);

        /// <summary>"(x, y, z) mm", in the invariant culture.</summary>
        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "({0:0.###}, {1:0.###}, {2:0.###}) mm", X, Y, Z);
    }
}
