using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>What a ray meets first.</summary>
    public readonly struct SegmentHit : IEquatable<SegmentHit>
    {
        /// <summary>Makes a hit.</summary>
        /// <param name="segment">Dense segment index.</param>
        /// <param name="positionLps">Where, LPS millimetres.</param>
        /// <param name="distanceMm">How far along the ray, millimetres.</param>
        public SegmentHit(int segment, PointMm positionLps, double distanceMm)
        {
            Hit = true;
            Segment = segment;
            PositionLps = positionLps;
            DistanceMm = distanceMm;
        }

        /// <summary>A ray that meets nothing: segment -1, infinitely far.</summary>
        public static SegmentHit None { get; } = new SegmentHit(false);

        SegmentHit(bool hit)
        {
            Hit = hit;
            Segment = -1;
            PositionLps = default;
            DistanceMm = double.PositiveInfinity;
        }

        /// <summary>Whether there is anything.</summary>
        public bool Hit { get; }

        /// <summary>Dense segment index; -1 without a hit.</summary>
        public int Segment { get; }

        /// <summary>
        /// Where the surface is seen, LPS millimetres; meaningless without a hit. That is where accumulated alpha reaches the threshold, or, as voxels make a ramp of an
        /// edge and alpha reaches the threshold only far up it, where it would with a sharp edge in the ramp's middle, up to half a reference length before.
        /// </summary>
        public PointMm PositionLps { get; }

        /// <summary>Millimetres along the ray from its origin; infinite without a hit.</summary>
        public double DistanceMm { get; }

        /// <inheritdoc/>
        public bool Equals(SegmentHit other) =>
            Hit == other.Hit && Segment == other.Segment && PositionLps.Equals(other.PositionLps) && DistanceMm.Equals(other.DistanceMm);

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is SegmentHit other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Hit, Segment, PositionLps, DistanceMm);

        /// <summary>For messages: segment and distance.</summary>
        public override string ToString() =>
            Hit ? FormattableString.Invariant($"segment {Segment} at {DistanceMm} mm") : "no segment";
    }
}
