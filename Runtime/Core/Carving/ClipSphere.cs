using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>One clip sphere: where it is and which segments it clips. Immutable; equal when all three parts are equal.</summary>
    public sealed class ClipSphere : IEquatable<ClipSphere>
    {
        /// <summary>Makes a sphere.</summary>
        /// <param name="centerLps">Centre in LPS millimetres, finite.</param>
        /// <param name="radiusMm">Radius (never the diameter) in millimetres, finite and not negative; 0 hides nothing.</param>
        /// <param name="mask">The segments that the sphere clips.</param>
        /// <exception cref="ArgumentException">A number is not finite, or the radius is negative.</exception>
        /// <exception cref="ArgumentNullException"><paramref name="mask"/> is null.</exception>
        public ClipSphere(PointMm centerLps, double radiusMm, SegmentMask mask)
        {
            if (!IsFinite(centerLps.X) || !IsFinite(centerLps.Y) || !IsFinite(centerLps.Z))
                throw new ArgumentException(FormattableString.Invariant(
                    $"A clip sphere's centre is finite; it is ({centerLps.X}, {centerLps.Y}, {centerLps.Z})."), nameof(centerLps));
            if (!IsFinite(radiusMm) || radiusMm < 0)
                throw new ArgumentException(FormattableString.Invariant(
                    $"A clip sphere's radius is finite and not negative; it is {radiusMm} mm."), nameof(radiusMm));
            CentreLps = centerLps;
            RadiusMm = radiusMm;
            Mask = mask ?? throw new ArgumentNullException(nameof(mask));
        }

        /// <summary>Centre in LPS millimetres.</summary>
        public PointMm CentreLps { get; }

        /// <summary>Radius in millimetres, 0 or more.</summary>
        public double RadiusMm { get; }

        /// <summary>The segments that the sphere clips.</summary>
        public SegmentMask Mask { get; }

        /// <summary>Whether the sphere can hide anything: its radius is above 0 and its mask is not empty.</summary>
        public bool CanClip => RadiusMm > 0 && !Mask.IsNone;

        /// <summary>The same sphere elsewhere.</summary>
        /// <exception cref="ArgumentException">The centre is not finite.</exception>
        public ClipSphere WithCenter(PointMm centerLps) => new ClipSphere(centerLps, RadiusMm, Mask);

        /// <summary>The same sphere with another radius in millimetres.</summary>
        /// <exception cref="ArgumentException">The radius is negative or not finite.</exception>
        public ClipSphere WithRadius(double radiusMm) => new ClipSphere(CentreLps, radiusMm, Mask);

        /// <summary>The same sphere with another mask.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="mask"/> is null.</exception>
        public ClipSphere WithMask(SegmentMask mask) => new ClipSphere(CentreLps, RadiusMm, mask);

        /// <inheritdoc/>
        public bool Equals(ClipSphere other) =>
            ReferenceEquals(this, other)
            || (other is object && CentreLps.Equals(other.CentreLps) && RadiusMm.Equals(other.RadiusMm) && Mask.Equals(other.Mask));

        /// <inheritdoc/>
        public override bool Equals(object obj) => Equals(obj as ClipSphere);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(CentreLps, RadiusMm, Mask);

        /// <summary>For messages: centre, radius, mask.</summary>
        public override string ToString() => FormattableString.Invariant(
            $"({CentreLps.X}, {CentreLps.Y}, {CentreLps.Z}) LPS mm, radius {RadiusMm} mm, clips {Mask}");

        static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
    }
}
