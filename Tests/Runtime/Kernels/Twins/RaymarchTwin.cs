using System;
using UnityEngine;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>What Raymarch is held to: one ray at a time, in double precision, without any cache.</summary>
    sealed class RaymarchTwin
    {
        /// <summary>A ray's result. Where a hair's breadth decides (a voxel boundary, a threshold), a field says that it is undecided.</summary>
        public sealed class Ray
        {
            public readonly double[] Color = new double[4];
            public double DepthMm = double.PositiveInfinity;
            public int Segment = RayScene.NoSegment;
            public bool ColorUndecided, VisibilityUndecided, SegmentUndecided, DepthUndecided;
            public int Samples;
            public bool Found; // the first visible point, by the finer sum
        }

        const double HairVoxels = 1e-4;
        const double HairAlpha = 1e-4;
        const double HairWeight = 1e-6;
        const int MostShaded = 7, FurtherSteps = 32; // steps
        const double Nearly = 0.9; // of the threshold
        const double EdgeReach = 0.5, Plateau = 2.5; // reference lengths
        const double ShadedWeight = 1.0 / 128, ShadedAlpha = 1 - 1.0 / 512;

        readonly RayScene scene;
        readonly KernelGrid grid;

        public RaymarchTwin(RayScene scene)
        {
            this.scene = scene;
            grid = scene.Grid;
        }

        public Ray March(int x, int y)
        {
            var ray = new Ray();
            double[] origin = new double[3], direction = new double[3];
            for (int axis = 0; axis < 3; axis++)
            {
                origin[axis] = scene.Origin[axis] + (x + 0.5) * scene.OriginDx[axis] + (y + 0.5) * scene.OriginDy[axis];
                direction[axis] = scene.Direction[axis] + (x + 0.5) * scene.DirectionDx[axis] + (y + 0.5) * scene.DirectionDy[axis];
            }
            double mmPerT = Length(direction);
            double near = scene.NearT, far = scene.FarT;
            if (scene.SceneDepth != null)
                far = Math.Min(far, scene.SceneDepth[x + scene.Width * y]);
            double[] start = ToIndexVector(origin), velocity = ToIndexVector(direction);
            double[] middle = { (grid.SizeI - 1) * 0.5, (grid.SizeJ - 1) * 0.5, (grid.SizeK - 1) * 0.5 };
            for (int axis = 0; axis < 3; axis++)
            {
                start[axis] += middle[axis];
                Clip(start[axis], velocity[axis], middle[axis] + 0.5, ref near, ref far, middle[axis]);
            }
            if (!(far > near))
                return ray;
            double[] toViewer = RayScene.Scale(direction, -1 / mmPerT);
            double stepT = scene.Step * grid.ReferenceMm / mmPerT;
            double steps = (far - near) / stepT;
            int pairing = scene.Step > 0.5 ? 0 : 1;
            int from = -1, until = int.MaxValue; // the stretch's steps
            double beforeLast = 0, weight = 0, moment = 0;
            int nearly = -1, reached = -1; // the steps in which alpha comes near the threshold, and reaches it
            (int step, double alpha) matter = (-1, 0), search = (0, 0); // where the matter begins that the ray is in; where the finer sum begins
            double peak = 0; // the highest opacity from where alpha comes near the threshold on
            for (int n = 0; n < steps && ray.Color[3] < scene.OpaqueAlpha; n++)
            {
                if (n >= until)
                {
                    ShadeStretch(ray, start, velocity, near, stepT, moment / weight, weight, toViewer);
                    (from, until, weight, moment) = (-1, int.MaxValue, 0, 0);
                }
                ray.Samples++;
                double before = ray.Color[3], end = Math.Min(n + 1, steps);
                double opacity = Trilinear(At(start, velocity, near + 0.5 * (n + end) * stepT));
                if (opacity > 0)
                {
                    from = from < 0 ? n : from;
                    double added = (1 - before) * (1 - Math.Pow(1 - opacity, (end - n) * scene.Step));
                    ray.Color[3] = before + added;
                    weight += added;
                    moment += added * 0.5 * (n + end);
                    int pairEnd = (n | pairing) + 1;
                    pairEnd = weight < ShadedWeight ? Math.Min(pairEnd + 2, (from | pairing) + MostShaded) : pairEnd;
                    until = ray.Color[3] < ShadedAlpha ? pairEnd : n + 1;
                    ray.ColorUndecided |= Math.Abs(weight - ShadedWeight) < HairWeight || Math.Abs(ray.Color[3] - ShadedAlpha) < HairWeight;
                    ray.ColorUndecided |= Math.Abs(ray.Color[3] - scene.OpaqueAlpha) < HairAlpha;
                    ray.VisibilityUndecided |= Math.Abs(ray.Color[3] - scene.VisibleAlpha) < HairAlpha;
                    ray.VisibilityUndecided |= Math.Abs(ray.Color[3] - Nearly * scene.VisibleAlpha) < HairAlpha;
                    bool isReached = before < scene.VisibleAlpha && ray.Color[3] >= scene.VisibleAlpha;
                    reached = isReached ? n : reached;
                    matter = matter.step < 0 ? (n, before) : matter;
                    if (nearly < 0 ? ray.Color[3] >= Nearly * scene.VisibleAlpha : isReached && n <= nearly + 1)
                    {
                        nearly = n;
                        search = isReached || n > matter.step + FurtherSteps ? (n, beforeLast) : matter;
                    }
                    if (nearly >= 0 && before < ShadedAlpha && n <= Math.Max(nearly, reached) + Plateau / scene.Step)
                        peak = Math.Max(peak, opacity);
                }
                else
                {
                    matter.step = -1;
                }
                beforeLast = before;
            }
            if (weight > 0)
                ShadeStretch(ray, start, velocity, near, stepT, moment / weight, weight, toViewer);
            if (nearly >= 0)
                FindVisible(ray, start, velocity, near, stepT, mmPerT, steps, nearly, reached, search, peak);
            return ray;
        }

        void ShadeStretch(Ray ray, double[] start, double[] velocity, double near, double stepT, double position, double weight, double[] toViewer)
        {
            double[] p = At(start, velocity, near + position * stepT);
            double[] shaded = Shade(BaseColor(p, start, velocity, stepT, out bool undecided), p, toViewer, out bool turnUndecided);
            for (int c = 0; c < 3; c++)
                ray.Color[c] += weight * shaded[c];
            ray.ColorUndecided |= (undecided || turnUndecided) && weight > 1e-3;
        }

        void FindVisible(Ray ray, double[] start, double[] velocity, double near, double stepT, double mmPerT, double steps, int nearly, int reached,
            (int step, double alpha) search, double peak)
        {
            double OpacityAt(double place) => Trilinear(At(start, velocity, near + place * stepT));
            peak = Math.Max(peak, OpacityAt(Math.Min(Math.Max(nearly, reached) + 1 + Plateau / scene.Step, steps)));
            double begin = Math.Max(search.step - 1, 0), first = Math.Max(begin + 0.5 - Math.Max(Math.Ceiling(EdgeReach / scene.Step), 1), 0);
            ray.Samples += 1 + (int)Math.Round(4 * (begin - first));
            double position = VisiblePosition(ray, start, velocity, near, stepT, begin,
                Math.Min(Math.Max(nearly, reached) + 1 + FurtherSteps, steps), search.alpha, out double sampled);
            double depth;
            ray.Found = position >= 0;
            if (!ray.Found && reached < 0)
                return;
            if (!ray.Found)
            {
                position = Math.Min(reached + 1, steps);
                sampled = 0.5 * (reached + position);
                depth = position;
            }
            else
            {
                depth = Edge(ray, OpacityAt, first, position, sampled, peak);
            }
            ray.DepthMm = (near + stepT * depth) * mmPerT;
            double t = near + stepT * position;
            ray.Segment = SegmentAround(At(start, velocity, t), out ray.SegmentUndecided);
            if (ray.Segment != RayScene.NoSegment)
                return;
            ray.Segment = SegmentAround(At(start, velocity, near + sampled * stepT), out bool undecided);
            ray.SegmentUndecided |= undecided;
        }

        /// <summary>
        /// Goes back from the part where the first visible point was found, quarter by quarter, to where opacity is below half of the peak; from there (or from where
        /// the quarters begin) it is as far to the depth as the peak's opacity needs to the threshold.
        /// </summary>
        double Edge(Ray ray, Func<double, double> opacityAt, double first, double position, double last, double peak)
        {
            double later = opacityAt(last);
            ray.DepthUndecided |= Math.Abs(later - 0.5 * peak) < HairAlpha;
            if (later < 0.5 * peak)
                return position;
            double edge = first, step = last - Math.Floor(4 * last) / 4; // the last part may be short
            for (double place = Math.Floor(4 * last) / 4 - 0.125; place > first; place -= 0.25)
            {
                double opacity = opacityAt(place), distance = step + 0.125;
                ray.DepthUndecided |= Math.Abs(opacity - 0.5 * peak) < HairAlpha;
                if (opacity < 0.5 * peak)
                {
                    edge = place + (0.5 * peak - opacity) / (later - opacity) * distance;
                    break;
                }
                (later, step) = (opacity, 0.125);
            }
            double thickness = Math.Log(1 - scene.VisibleAlpha) / Math.Log(Math.Max(1 - peak, 1 / 255.0)) * Math.Min(255 * (1 - peak), 1);
            return Math.Min(position, Math.Max(edge, position - EdgeReach / scene.Step) + thickness / scene.Step);
        }

        /// <summary>From the beginning of the step before a step on, alpha is accumulated anew in quarters of a step.</summary>
        double VisiblePosition(
            Ray ray, double[] start, double[] velocity, double near, double stepT, double begin, double end, double alpha, out double middle)
        {
            for (double from = begin; from < end; from += 0.25)
            {
                double to = Math.Min(from + 0.25, end);
                middle = 0.5 * (from + to);
                double opacity = Trilinear(At(start, velocity, near + middle * stepT));
                ray.Samples++;
                double lengths = (to - from) * scene.Step, after = 1 - (1 - alpha) * Math.Pow(1 - opacity, lengths);
                ray.VisibilityUndecided |= Math.Abs(after - scene.VisibleAlpha) < HairAlpha && to >= end;
                if (after >= scene.VisibleAlpha)
                {
                    double share = opacity < 1 ? Math.Log((1 - scene.VisibleAlpha) / (1 - alpha)) / (lengths * Math.Log(1 - opacity)) : 0;
                    return from + Math.Min(1, Math.Max(0, share)) * (to - from);
                }
                alpha = after;
            }
            middle = -1;
            return -1;
        }

        static void Clip(double start, double velocity, double half, ref double near, ref double far, double middle)
        {
            double low = middle - half, high = middle + half;
            if (Math.Abs(velocity) < 1e-12)
            {
                if (start < low || start > high)
                    far = double.NegativeInfinity;
                return;
            }
            double a = (low - start) / velocity, b = (high - start) / velocity;
            near = Math.Max(near, Math.Min(a, b));
            far = Math.Min(far, Math.Max(a, b));
        }

        double[] Shade(double[] baseColor, double[] p, double[] toViewer, out bool undecided)
        {
            double[] normal = BlendedNormal(p);
            double length = Length(normal);
            undecided = length > 0 && length < 1e-2;
            double[] n = length > 1e-4 ? RayScene.Scale(normal, 1 / length) : toViewer;
            double facing = Dot(n, toViewer);
            if (facing < 0)
                n = new[] { n[0] - 2 * facing * toViewer[0], n[1] - 2 * facing * toViewer[1], n[2] - 2 * facing * toViewer[2] };
            double[] halfway = new double[3];
            for (int axis = 0; axis < 3; axis++)
                halfway[axis] = scene.Light[axis] + toViewer[axis];
            halfway = OctahedralTwin.Normalized(halfway);
            double diffuse = scene.Diffuse * Math.Max(0, Dot(n, scene.Light));
            double specular = scene.Specular * Math.Pow(Math.Max(0, Dot(n, halfway)), scene.Shininess);
            var color = new double[3];
            for (int c = 0; c < 3; c++)
                color[c] = baseColor[c] * (scene.Ambient + diffuse * scene.LightColor[c]) + specular * scene.LightColor[c];
            return color;
        }

        /// <summary>
        /// The colours of the eight voxels around, by share and opacity; where all are empty, of those a reference length further; where these are, the colour of
        /// the segment of the 64 around.
        /// </summary>
        double[] BaseColor(double[] p, double[] start, double[] velocity, double stepT, out bool undecided)
        {
            double[] ahead = new double[3];
            for (int axis = 0; axis < 3; axis++)
                ahead[axis] = p[axis] + velocity[axis] * stepT / scene.Step;
            double[] color = MatterColor(p, out double share);
            undecided = share < HairVoxels && share != 0; // hardly anything there
            if (share > 0)
                return color;
            color = MatterColor(ahead, out share);
            undecided = share < HairVoxels && share != 0;
            if (share > 0)
                return color;
            int segment = SegmentAround(p, out undecided);
            Vector4 own = scene.Colors[segment == RayScene.NoSegment ? 0 : segment];
            return new double[] { own.x, own.y, own.z };
        }

        double[] MatterColor(double[] p, out double share)
        {
            var sum = new double[4];
            ForCorners(p, (voxel, part) =>
            {
                Vector4 color = scene.Colors[scene.Labels[voxel]];
                double weight = part * scene.Opacity[voxel];
                for (int c = 0; c < 3; c++)
                    sum[c] += weight * color[c];
                sum[3] += weight;
            });
            share = sum[3];
            return new[] { sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3] };
        }

        double[] BlendedNormal(double[] p)
        {
            var sum = new double[3];
            ForCorners(p, (voxel, weight) =>
            {
                double[] normal = OctahedralTwin.Decode(scene.Normals[2 * voxel], scene.Normals[2 * voxel + 1]);
                for (int axis = 0; axis < 3 && normal != null; axis++)
                    sum[axis] += weight * normal[axis];
            });
            return sum;
        }

        double Trilinear(double[] p)
        {
            double sum = 0;
            ForCorners(p, (voxel, weight) => sum += weight * scene.OpacityAA[voxel]);
            return sum;
        }

        void ForCorners(double[] p, Action<int, double> action)
        {
            int i = (int)Math.Floor(p[0]), j = (int)Math.Floor(p[1]), k = (int)Math.Floor(p[2]);
            for (int n = 0; n < 8; n++)
            {
                int di = n & 1, dj = n >> 1 & 1, dk = n >> 2;
                double weight = (di == 0 ? 1 - (p[0] - i) : p[0] - i) * (dj == 0 ? 1 - (p[1] - j) : p[1] - j) * (dk == 0 ? 1 - (p[2] - k) : p[2] - k);
                action(Clamped(i + di, j + dj, k + dk), weight);
            }
        }

        /// <summary>The segment at a point; undecided when a point a hair's breadth away has another.</summary>
        int SegmentAround(double[] p, out bool undecided)
        {
            int segment = SegmentAt(p[0], p[1], p[2]);
            undecided = false;
            for (int n = 0; n < 8; n++)
                undecided |= SegmentAt(
                    p[0] + ((n & 1) == 0 ? -HairVoxels : HairVoxels), p[1] + ((n & 2) == 0 ? -HairVoxels : HairVoxels), p[2] + ((n & 4) == 0 ? -HairVoxels : HairVoxels)) != segment;
            return segment;
        }

        int SegmentAt(double x, double y, double z)
        {
            int i = (int)Math.Floor(x), j = (int)Math.Floor(y), k = (int)Math.Floor(z);
            int voxel = MostOpaque(i, j, k, 0, 1);
            voxel = voxel >= 0 ? voxel : MostOpaque(i, j, k, -1, 2);
            return voxel >= 0 ? scene.Labels[voxel] : RayScene.NoSegment;
        }

        int MostOpaque(int i, int j, int k, int from, int to)
        {
            int best = 0, found = -1;
            for (int dk = from; dk <= to; dk++)
                for (int dj = from; dj <= to; dj++)
                    for (int di = from; di <= to; di++)
                    {
                        int voxel = Clamped(i + di, j + dj, k + dk);
                        if (scene.Opacity[voxel] > best)
                        {
                            best = scene.Opacity[voxel];
                            found = voxel;
                        }
                    }
            return found;
        }

        int Clamped(int i, int j, int k) => grid.Index(
            Math.Min(Math.Max(i, 0), grid.SizeI - 1), Math.Min(Math.Max(j, 0), grid.SizeJ - 1), Math.Min(Math.Max(k, 0), grid.SizeK - 1));

        double[] ToIndexVector(double[] v)
        {
            var index = new double[3];
            for (int row = 0; row < 3; row++)
                index[row] = grid.MmToIndex[row, 0] * v[0] + grid.MmToIndex[row, 1] * v[1] + grid.MmToIndex[row, 2] * v[2];
            return index;
        }

        static double[] At(double[] start, double[] velocity, double t) =>
            new[] { start[0] + t * velocity[0], start[1] + t * velocity[1], start[2] + t * velocity[2] };

        static double Dot(double[] a, double[] b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

        static double Length(double[] v) => Math.Sqrt(Dot(v, v));
    }
}
