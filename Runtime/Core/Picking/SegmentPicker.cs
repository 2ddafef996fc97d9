using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>
    /// The walk of one ray to the first visible segment, in double precision: the CPU twin of <c>Raymarch.hlsl</c>, on the same samples. The part of the
    /// ray inside the volume's box is cut into steps from where the ray enters (the last step ends where it leaves); each is sampled in its middle, and
    /// a sample of opacity a per reference length adds 1 - (1 - a)^length. Where accumulated alpha reaches the threshold is looked for in parts of
    /// steps: from the step before on, or where alpha stays near it, from where that matter begins. Bricks in which nothing is visible are skipped; that
    /// changes no result.
    /// </summary>
    public static class SegmentPicker
    {
        const double MaxSteps = 1048576;
        const double Nearly = 0.9; // of the threshold
        const int FurtherSteps = 32; // in which the first visible point is looked for beyond the steps that come near it, and matter's beginning before

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
            Approach approach = MarchUntilReached(field, path, settings, near, stepMm, steps);
            if (approach.Nearly < 0)
                return SegmentHit.None;
            double end = Math.Min(Math.Max(approach.Nearly, approach.Reached) + 1 + FurtherSteps, steps);
            double position = FirstVisiblePosition(
                field, path, settings, near, stepMm, Math.Max(approach.SearchBegin - 1, 0), end, approach.SearchAlpha, out double sampled);
            if (position < 0 && approach.Reached < 0)
                return SegmentHit.None;
            if (position < 0)
            {
                position = Math.Min(approach.Reached + 1, steps);
                sampled = 0.5 * (approach.Reached + position);
            }
            return HitAt(field, ray, path, near + position * stepMm, near + sampled * stepMm);
        }

        /// <summary>Goes by whole steps until alpha reaches the threshold, or the ray ends.</summary>
        static Approach MarchUntilReached(CarvedField field, in IndexRay path, RaySettings settings, double near, double stepMm, double steps)
        {
            var approach = new Approach { Nearly = -1, Reached = -1 };
            double alpha = 0;
            double beforeLast = 0; // alpha before the last step but one
            double lastSeen = -2;
            double matterBegin = 0, matterAlpha = 0; // the step where the matter begins that the ray is in; alpha there
            double n = 0;
            while (n < steps && alpha < settings.OpaqueAlpha && approach.Reached < 0)
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
                    double before = alpha;
                    if (lastSeen != n - 1)
                        (beforeLast, matterBegin, matterAlpha) = (before, n, before); // the step before was empty
                    alpha = before + (1 - before) * (1 - Math.Exp(LogPassing(opacity, (end - n) * settings.StepReference)));
                    bool isReached = alpha >= settings.FirstVisibleAlpha;
                    if (isReached)
                        approach.Reached = n;
                    if (approach.Nearly < 0 ? alpha >= Nearly * settings.FirstVisibleAlpha : isReached && n <= approach.Nearly + 1)
                    {
                        bool fromHere = isReached || n > matterBegin + FurtherSteps;
                        approach.Nearly = n;
                        approach.SearchBegin = fromHere ? n : matterBegin;
                        approach.SearchAlpha = fromHere ? beforeLast : matterAlpha;
                    }
                    beforeLast = before;
                    lastSeen = n;
                }
                n++;
            }
            return approach;
        }

        /// <summary>
        /// Where alpha, accumulated from position begin on (in steps) where it is alpha, reaches the threshold, and the middle of the part in which it does; -1 if
        /// it does not before end. As in the kernel, a step is cut into <see cref="RaySettings.PartsOfStep"/> parts, and the place within its part solved in
        /// closed form.
        /// </summary>
        static double FirstVisiblePosition(
            CarvedField field, in IndexRay path, RaySettings settings, double near, double stepMm, double begin, double end, double alpha, out double middle)
        {
            double wanted = Math.Log((1 - settings.FirstVisibleAlpha) / (1 - alpha)); // the log of the light that is to pass
            double passing = 0;
            for (double from = begin; from < end; from += 1.0 / RaySettings.PartsOfStep)
            {
                double to = Math.Min(from + 1.0 / RaySettings.PartsOfStep, end);
                middle = 0.5 * (from + to);
                VectorMm index = path.At(near + middle * stepMm);
                double here = LogPassing(field.SampleAntiAliased(index.X, index.Y, index.Z), (to - from) * settings.StepReference);
                if (passing + here <= wanted)
                    return from + Math.Max(0, Math.Min(1, (wanted - passing) / here)) * (to - from);
                passing += here;
            }
            middle = -1;
            return -1;
        }

        /// <summary>The log of the light that passes some reference lengths of matter. Matter of opacity 1 stops all, however short they are.</summary>
        static double LogPassing(double opacity, double lengths) => opacity < 1 ? lengths * Math.Log(1 - opacity) : double.NegativeInfinity;

        static SegmentHit HitAt(CarvedField field, RayMm ray, in IndexRay path, double distance, double sampledDistance)
        {
            VectorMm there = path.At(distance);
            int segment = field.SegmentAt(there.X, there.Y, there.Z);
            if (segment < 0)
            {
                VectorMm sample = path.At(sampledDistance); // has matter around
                segment = field.SegmentAt(sample.X, sample.Y, sample.Z);
            }
            return new SegmentHit(segment, ray.At(distance), distance);
        }

        /// <summary>How alpha comes to the threshold, by whole steps.</summary>
        struct Approach
        {
            /// <summary>The steps in which it comes near, and reaches it; -1 = it does not.</summary>
            public double Nearly, Reached;

            /// <summary>The step from whose predecessor on the parts of steps are added up, and alpha there.</summary>
            public double SearchBegin, SearchAlpha;
        }
    }
}
