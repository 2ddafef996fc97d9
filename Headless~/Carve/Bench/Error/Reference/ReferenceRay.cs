using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>A ray in continuous voxel indices, by distance in mm, and the cell of eight voxels that it is in.</summary>
    sealed class ReferenceRay
    {
        readonly ReferenceField field;
        readonly VectorMm start, perMm;
        readonly double[] opacities = new double[8];
        readonly VectorMm[] normals = new VectorMm[8];
        readonly (int Segment, double Weight)[] colors = new (int, double)[8];
        (int I, int J, int K) corner = (int.MinValue, 0, 0);
        bool normalsKnown;
        int segment;

        public ReferenceRay(ReferenceField field, RayMm ray)
        {
            this.field = field;
            var origin = field.Geometry.LpsToIjk.TransformPoint(ray.Origin);
            start = new VectorMm(origin.X, origin.Y, origin.Z);
            perMm = field.Geometry.LpsToIjk.TransformVector(ray.Direction);
        }

        /// <summary>The part of the ray in the volume's box; empty where it misses.</summary>
        public (double Near, double Far) Crossing(double near, double far)
        {
            ClipAxis(start.X, perMm.X, field.Bricks.SizeI, ref near, ref far);
            ClipAxis(start.Y, perMm.Y, field.Bricks.SizeJ, ref near, ref far);
            ClipAxis(start.Z, perMm.Z, field.Bricks.SizeK, ref near, ref far);
            return (near, far);
        }

        /// <summary>Opacity per reference length at a distance.</summary>
        public double OpacityAt(double distanceMm)
        {
            Enter(distanceMm, out var x, out var y, out var z);
            double sum = 0;
            for (var n = 0; n < 8; n++) sum += Weight(n, x, y, z) * opacities[n];
            return sum;
        }

        /// <summary>The blend of the eight normals, not of unit length.</summary>
        public VectorMm NormalAt(double distanceMm)
        {
            Enter(distanceMm, out var x, out var y, out var z);
            if (!normalsKnown)
            {
                for (var n = 0; n < 8; n++) normals[n] = field.NormalOf(corner.I + (n & 1), corner.J + (n >> 1 & 1), corner.K + (n >> 2));
                normalsKnown = true;
            }

            VectorMm sum = default;
            for (var n = 0; n < 8; n++) sum += Weight(n, x, y, z) * normals[n];
            return sum;
        }

        /// <summary>How much each segment counts in the colour at a distance: share and opacity before anti-aliasing; none where all eight are empty.</summary>
        public ReadOnlySpan<(int Segment, double Weight)> ColorsAt(double distanceMm)
        {
            Enter(distanceMm, out var x, out var y, out var z);
            Span<double> cellOpacities = stackalloc double[8];
            Span<int> cellSegments = stackalloc int[8];
            field.Cell(corner.I, corner.J, corner.K, cellOpacities, cellSegments);
            for (var n = 0; n < 8; n++) colors[n] = (cellSegments[n], Weight(n, x, y, z) * cellOpacities[n]);
            return colors;
        }

        /// <summary>The segment shown at a distance; -1 = none.</summary>
        public int SegmentAt(double distanceMm)
        {
            Enter(distanceMm, out _, out _, out _);
            if (segment == int.MinValue) segment = field.SegmentAround(corner.I, corner.J, corner.K);
            return segment;
        }

        void Enter(double distanceMm, out double x, out double y, out double z)
        {
            var index = start + distanceMm * perMm;
            var (i, j, k) = ((int)Math.Floor(index.X), (int)Math.Floor(index.Y), (int)Math.Floor(index.Z));
            (x, y, z) = (index.X - i, index.Y - j, index.Z - k);
            if ((i, j, k) == corner) return;
            corner = (i, j, k);
            for (var n = 0; n < 8; n++) opacities[n] = field.AntiAliasedOf(i + (n & 1), j + (n >> 1 & 1), k + (n >> 2));
            normalsKnown = false;
            segment = int.MinValue;
        }

        static double Weight(int n, double x, double y, double z) =>
            ((n & 1) == 0 ? 1 - x : x) * ((n & 2) == 0 ? 1 - y : y) * ((n & 4) == 0 ? 1 - z : z);

        static void ClipAxis(double start, double perMm, int size, ref double near, ref double far)
        {
            if (perMm == 0)
            {
                if (start < -0.5 || start > size - 0.5) far = double.NegativeInfinity;
                return;
            }

            double a = (-0.5 - start) / perMm, b = (size - 0.5 - start) / perMm;
            (near, far) = (Math.Max(near, Math.Min(a, b)), Math.Min(far, Math.Max(a, b)));
        }
    }
}
