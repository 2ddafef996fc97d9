using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>
    /// The walk of one ray to the first visible segment, in double precision: the CPU twin of <c>Raymarch.hlsl</c>, on the same samples. The part of the
    /// ray inside the volume's box is cut into steps from where the ray enters (the last step ends where it leaves); each is sampled in its
    /// middle, and a sample of opacity a per reference length adds 1 - (1 - a)^length. Where accumulated alpha reaches the threshold is solved in
    /// closed form within the step. Bricks in which nothing is visible are skipped; that changes no result.
    /// </summary>
    public static class SegmentPicker
    {
        const double MaxSteps = 1048576;

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
            return March(field, ray, path, settings, near, far);
        }

        static SegmentHit March(CarvedField field, RayMm ray, in IndexRay path, RaySettings settings, double near, double far)
        {
            double stepMm = settings.StepReference * field.Volume.Geometry.ReferenceLengthMm;
            double steps = Math.Min((far - near) / stepMm, MaxSteps);
            double alpha = 0;
            double n = 0;
            while (n < steps && alpha < settings.OpaqueAlpha)
            {
                double end = Math.Min(n + 1, steps);
                VectorMm index = path.At(near + 0.5 * (n + end) * stepMm);
                double clearUntilMm = path.ClearUntil(field, index);
                if (clearUntilMm > double.NegativeInfinity)
                {
                    n = Math.Max(n + 1, Math.Floor((clearUntilMm - near) / stepMm - 0.5));
                    continue;
                }
                double opacity = field.SampleAntiAliased(index.X, index.Y, index.Z);
                if (opacity > 0)
                {
                    double lengths = (end - n) * settings.StepReference;
                    double logPassing = lengths * Math.Log(1 - opacity);
                    double before = alpha;
                    double passing = opacity < 1 ? Math.Exp(logPassing) : 0; // matter of opacity 1 stops all light, however short the step
                    alpha = before + (1 - before) * (1 - passing);
                    if (alpha >= settings.FirstVisibleAlpha)
                    {
                        double part = opacity < 1 ? Math.Log((1 - settings.FirstVisibleAlpha) / (1 - before)) / logPassing : 0;
                        double distance = near + (n + Math.Max(0, Math.Min(1, part)) * (end - n)) * stepMm;
                        return HitAt(field, ray, path, distance, index);
                    }
                }
                n++;
            }
            return SegmentHit.None;
        }

        static SegmentHit HitAt(CarvedField field, RayMm ray, in IndexRay path, double distance, VectorMm sample)
        {
            VectorMm there = path.At(distance);
            int segment = field.SegmentAt(there.X, there.Y, there.Z);
            if (segment < 0)
                segment = field.SegmentAt(sample.X, sample.Y, sample.Z);
            return new SegmentHit(segment, ray.At(distance), distance);
        }
    }
}
