using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>
    /// The walk of one ray to the first visible segment, in double precision: the CPU twin of <c>Raymarch.hlsl</c>, on the same samples. The part of the
    /// ray inside the volume's box is cut into steps from where the ray enters (the last step ends where it leaves); each is sampled in its middle, and
    /// a sample of opacity a per reference length adds 1 - (1 - a)^length. Where accumulated alpha reaches the threshold is looked for in parts of
    /// steps: from the step before on, or where alpha stays near it, from where that matter begins. The hit lies at the edge before that point, if there is one
    /// (see <see cref="SegmentHit.PositionLps"/>). Bricks in which nothing is visible are skipped; that changes no result.
    /// </summary>
    public static class SegmentPicker
    {
        /// <summary>Finds the first visible segment on a ray.</summary>
        /// <param name="field">The carved volume.</param>
        /// <param name="ray">The ray in LPS millimetres. It may begin inside the volume.</param>
        /// <param name="settings">Step and threshold.</param>
        /// <param name="maxDistanceMm">How far is looked, in millimetres from the ray's origin.</param>
        /// <param name="minDistanceMm">From where on is looked; 0 or more. Steps count from there or from the box, whichever comes later.</param>
        /// <returns>The hit, or <see cref="SegmentHit.None"/>.</returns>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The ray was never made (its direction is zero), or a distance is NaN or the smaller one negative.</exception>
        /// <exception cref="InvalidOperationException">The field was never updated.</exception>
        public static SegmentHit Pick(
            CarvedField field, RayMm ray, RaySettings settings, double maxDistanceMm = double.PositiveInfinity, double minDistanceMm = 0)
        {
            if (field == null)
                throw new ArgumentNullException(nameof(field));
            if (settings == null)
                throw new ArgumentNullException(nameof(settings));
            if (ray.Direction.Equals(default))
                throw new ArgumentException("The ray has no direction.", nameof(ray));
            if (double.IsNaN(maxDistanceMm) || !(minDistanceMm >= 0))
                throw new ArgumentException(FormattableString.Invariant(
                    $"A ray is looked at from 0 mm or more; it is {minDistanceMm} to {maxDistanceMm} mm."), nameof(minDistanceMm));
            IndexRay path = IndexRay.Of(field, ray);
            double near = minDistanceMm, far = maxDistanceMm;
            if (!path.ClipToBox(ref near, ref far))
                return SegmentHit.None;
            var walk = new RayWalk(field, path, settings, near, far);
            if (!walk.FindFirstVisible(out FirstVisiblePoint first))
                return SegmentHit.None;
            int segment = walk.SegmentAt(first.Position);
            if (segment < 0)
                segment = walk.SegmentAt(first.SampledAt); // has matter around
            double distance = walk.DistanceMm(first.Edge);
            return new SegmentHit(segment, ray.At(distance), distance);
        }
    }
}
