using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>A ray in LPS millimetres.</summary>
    public readonly struct RayMm
    {
        /// <summary>Makes a ray.</summary>
        /// <param name="origin">Where it begins, LPS millimetres, finite.</param>
        /// <param name="direction">Where it goes; finite and not zero, of any length: it is normalised.</param>
        /// <exception cref="ArgumentException">A number is not finite, or the direction is zero.</exception>
        public RayMm(PointMm origin, VectorMm direction)
        {
            if (!origin.IsFinite)
                throw new ArgumentException(FormattableString.Invariant($"A ray's origin is finite; it is {origin}."), nameof(origin));
            double longest = Math.Max(Math.Abs(direction.X), Math.Max(Math.Abs(direction.Y), Math.Abs(direction.Z)));
            if (!direction.IsFinite || !(longest > 0))
                throw new ArgumentException(FormattableString.Invariant($"A ray's direction is finite and not zero; it is {direction}."), nameof(direction));
            Origin = origin;
            var scaled = new VectorMm(direction.X / longest, direction.Y / longest, direction.Z / longest);
            Direction = scaled / scaled.Length;
        }

        /// <summary>Where the ray begins, LPS millimetres.</summary>
        public PointMm Origin { get; }

        /// <summary>Where it goes: a unit vector.</summary>
        public VectorMm Direction { get; }

        /// <summary>The point at a distance from the origin.</summary>
        /// <param name="distanceMm">Millimetres along the ray.</param>
        public PointMm At(double distanceMm) => Origin + distanceMm * Direction;
    }
}
