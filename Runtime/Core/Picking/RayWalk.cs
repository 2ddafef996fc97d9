using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>A ray by its steps inside the volume: step n begins n steps from where the ray enters. See <see cref="SegmentPicker"/>.</summary>
    readonly struct RayWalk
    {
        const double MaxSteps = 1048576;
        const double Nearly = 0.9; // of the threshold
        const int FurtherSteps = 32; // in which the first visible point is looked for beyond the steps that come near it, and matter's beginning before
        const double EdgeReach = 0.5; // reference lengths from an edge to the first visible point
        const double OneCode = 1 / 255.0; // opacities nearer to 1 are taken to stop all light, the nearer the more so
        const double Plateau = 2.5; // reference lengths in which matter behind an edge comes to its own opacity

        readonly CarvedField field;
        readonly IndexRay path;
        readonly RaySettings settings;
        readonly double near, stepMm, steps;

        public RayWalk(CarvedField field, in IndexRay path, RaySettings settings, double near, double far)
        {
            this.field = field;
            this.path = path;
            this.settings = settings;
            this.near = near;
            stepMm = settings.StepReference * field.Volume.Geometry.ReferenceLengthMm;
            steps = Math.Min((far - near) / stepMm, MaxSteps); // the last one may be a fraction
        }

        public double DistanceMm(double position) => near + position * stepMm;

        public int SegmentAt(double position)
        {
            VectorMm index = path.At(DistanceMm(position));
            return field.SegmentAt(index.X, index.Y, index.Z);
        }

        public bool FindFirstVisible(out FirstVisiblePoint first)
        {
            first = default;
            Approach approach = MarchPastThreshold();
            if (approach.Nearly < 0)
                return false;
            double around = Math.Max(approach.Nearly, approach.Reached);
            double behind = OpacityAt(Math.Min(around + 1 + Plateau / settings.StepReference, steps)); // where the march may have ended before
            double peak = Math.Max(approach.Peak, behind);
            if (Search(Math.Max(approach.SearchBegin - 1, 0), Math.Min(around + 1 + FurtherSteps, steps), approach.SearchAlpha, peak, ref first))
                return true;
            if (approach.Reached < 0)
                return false;
            first.Position = Math.Min(approach.Reached + 1, steps);
            first.SampledAt = 0.5 * (approach.Reached + first.Position);
            first.Edge = first.Position;
            return true;
        }

        /// <summary>Goes by whole steps until matter's opacity behind the threshold is known, or the ray ends.</summary>
        Approach MarchPastThreshold()
        {
            var approach = new Approach { Nearly = -1, Reached = -1 };
            double plateauSteps = Plateau / settings.StepReference;
            double alpha = 0;
            double beforeLast = 0; // alpha before the last step but one
            double lastSeen = -2;
            double matterBegin = 0, matterAlpha = 0; // the step where the matter begins that the ray is in; alpha there
            double n = 0;
            while (n < steps && alpha < settings.OpaqueAlpha && (approach.Reached < 0 || n <= approach.Reached + plateauSteps))
            {
                double end = Math.Min(n + 1, steps);
                VectorMm index = path.At(DistanceMm(0.5 * (n + end)));
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
                    bool isReached = approach.Reached < 0 && alpha >= settings.FirstVisibleAlpha;
                    if (isReached)
                        approach.Reached = n;
                    if (approach.Nearly < 0 ? alpha >= Nearly * settings.FirstVisibleAlpha : isReached && n <= approach.Nearly + 1)
                    {
                        bool fromHere = isReached || n > matterBegin + FurtherSteps;
                        approach.Nearly = n;
                        approach.SearchBegin = fromHere ? n : matterBegin;
                        approach.SearchAlpha = fromHere ? beforeLast : matterAlpha;
                    }
                    if (approach.Nearly >= 0 && before < RaySettings.DefaultOpaqueAlpha && n <= Math.Max(approach.Nearly, approach.Reached) + plateauSteps)
                        approach.Peak = Math.Max(approach.Peak, opacity);
                    beforeLast = before;
                    lastSeen = n;
                }
                n++;
            }
            return approach;
        }

        /// <summary>
        /// Looks for where alpha, accumulated from position begin on where it is alpha, reaches the threshold; false if it does not before end. As in the kernel, a
        /// step is cut into <see cref="RaySettings.PartsOfStep"/> parts, and the place within its part solved in closed form.
        /// </summary>
        bool Search(double begin, double end, double alpha, double peak, ref FirstVisiblePoint first)
        {
            double wanted = Math.Log((1 - settings.FirstVisibleAlpha) / (1 - alpha)); // the log of the light that is to pass
            double passing = 0;
            // The point is half a step and more behind begin but for odd rays.
            var edge = new RisingEdge(0.5 * peak, Math.Max(begin + 0.5 - Math.Max(Math.Ceiling(EdgeReach / settings.StepReference), 1), 0));
            for (double from = edge.Position; from < end; from += 1.0 / RaySettings.PartsOfStep)
            {
                double to = Math.Min(from + 1.0 / RaySettings.PartsOfStep, end);
                double middle = 0.5 * (from + to);
                double opacity = OpacityAt(middle);
                edge.Add(middle, opacity);
                if (from < begin)
                    continue;
                double here = LogPassing(opacity, (to - from) * settings.StepReference);
                if (passing + here <= wanted)
                {
                    first.Position = from + Math.Max(0, Math.Min(1, (wanted - passing) / here)) * (to - from);
                    first.SampledAt = middle;
                    first.Edge = EdgeBefore(first.Position, edge, peak);
                    return true;
                }
                passing += here;
            }
            return false;
        }

        /// <summary>Where matter of the peak's opacity, with a sharp edge where opacity rises through half of it, would reach the threshold.</summary>
        double EdgeBefore(double position, in RisingEdge edge, double peak)
        {
            if (edge.Position < 0)
                return position;
            double passing = Math.Min(Math.Max(1 - peak, OneCode), 1 - 1e-6); // never 0 / 0
            double thickness = Math.Log(1 - settings.FirstVisibleAlpha) / Math.Log(passing) * Math.Min((1 - peak) / OneCode, 1); // reference lengths
            return Math.Min(position, Math.Max(edge.Position, position - EdgeReach / settings.StepReference) + thickness / settings.StepReference);
        }

        double OpacityAt(double position)
        {
            VectorMm index = path.At(DistanceMm(position));
            return field.SampleAntiAliased(index.X, index.Y, index.Z);
        }

        /// <summary>The log of the light that passes some reference lengths of matter. Matter of opacity 1 stops all, however short they are.</summary>
        static double LogPassing(double opacity, double lengths) => opacity < 1 ? lengths * Math.Log(1 - opacity) : double.NegativeInfinity;

        /// <summary>How alpha comes to the threshold, by whole steps.</summary>
        struct Approach
        {
            /// <summary>The steps in which it comes near, and reaches it; -1 = it does not.</summary>
            public double Nearly, Reached;

            /// <summary>The step from whose predecessor on the parts of steps are added up, and alpha there.</summary>
            public double SearchBegin, SearchAlpha;

            /// <summary>The highest opacity from there on, as far as matter behind the threshold comes to its own.</summary>
            public double Peak;
        }
    }
}
