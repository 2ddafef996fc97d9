using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>One clip sphere: where it is and which segments it clips. Immutable; equal when all three parts are equal.</summary>
    public sealed class ClipSphere : IEquatable<ClipSphere>
    {
        /// <summary>
        /// The largest radius, and the largest coordinate of a centre, in millimetres: 1e18. Eq. 1 is decided in float, which holds 3.4e38; the square of
        /// the distance of two points within the limit stays below that.
        /// </summary>
        public const double LargestMm = 1e18;

        /// <summary>Makes a sphere.</summary>
        /// <param name="centerLps">Centre in LPS millimetres, each coordinate within +-<see cref="LargestMm"/>.</param>
        /// <param name="radiusMm">Radius (never the diameter) in millimetres, 0 to <see cref="LargestMm"/>; 0 hides nothing.</param>
        /// <param name="mask">The segments that the sphere clips.</param>
        /// <exception cref="ArgumentOutOfRangeException">A number lies outside its range.</exception>
        /// <exception cref="ArgumentNullException"><paramref name="mask"/> is null.</exception>
        public ClipSphere(PointMm centerLps, double radiusMm, SegmentMask mask)
        {
            CheckPlace(centerLps, nameof(centerLps), radiusMm, nameof(radiusMm));
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
        /// <exception cref="ArgumentOutOfRangeException">A coordinate lies outside its range.</exception>
        public ClipSphere WithCenter(PointMm centerLps) => new ClipSphere(centerLps, RadiusMm, Mask);

        /// <summary>The same sphere with another radius in millimetres.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The radius lies outside its range.</exception>
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

        /// <exception cref="ArgumentOutOfRangeException">A number is not one that a clip sphere can have.</exception>
        internal static void CheckPlace(PointMm centerLps, string centerName, double radiusMm, string radiusName)
        {
            if (!IsWithin(centerLps.X) || !IsWithin(centerLps.Y) || !IsWithin(centerLps.Z))
                throw new ArgumentOutOfRangeException(centerName, centerLps, FormattableString.Invariant(
                    $"The coordinates of a clip sphere's centre are {-LargestMm} to {LargestMm} mm."));
            if (!IsWithin(radiusMm) || radiusMm < 0)
                throw new ArgumentOutOfRangeException(radiusName, radiusMm, FormattableString.Invariant(
                    $"A clip sphere's radius is 0 to {LargestMm} mm."));
        }

        /// <summary>False for NaN too.</summary>
        internal static bool IsWithin(double mm) => Math.Abs(mm) <= LargestMm;
    }
}
