using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Phantoms
{
    /// <summary>A ball in LPS mm.</summary>
    readonly record struct Ball(PointMm Centre, double RadiusMm)
    {
        public bool Holds(PointMm place) => (place - Centre).LengthSquared <= RadiusMm * RadiusMm;

        /// <summary>From the centre outwards.</summary>
        public VectorMm NormalAt(PointMm place) => (place - Centre).Normalized();

        /// <summary>Where a ray goes in and out, in mm along it; NaN where it misses.</summary>
        public (double In, double Out) Crossing(RayMm ray)
        {
            var toCentre = Centre - ray.Origin;
            var along = toCentre.Dot(ray.Direction);
            var half = Math.Sqrt(RadiusMm * RadiusMm - (toCentre - along * ray.Direction).LengthSquared);
            return (along - half, along + half);
        }

        /// <summary>The share of a voxel's box within the ball, of samples^3 points in it. The grid's axes are at right angles.</summary>
        public double Coverage(VolumeGeometry geometry, int i, int j, int k, int samples)
        {
            // Most voxels lie wholly within or without.
            var fromSurface = (geometry.IjkToLps.TransformPoint(new PointMm(i, j, k)) - Centre).Length - RadiusMm;
            if (Math.Abs(fromSurface) > 0.5 * geometry.SpacingMm.Length) return fromSurface < 0 ? 1 : 0;
            var inside = 0;
            for (var n = 0; n < samples * samples * samples; n++)
            {
                var place = new PointMm(
                    i - 0.5 + (n % samples + 0.5) / samples,
                    j - 0.5 + (n / samples % samples + 0.5) / samples,
                    k - 0.5 + (n / (samples * samples) + 0.5) / samples);
                if (Holds(geometry.IjkToLps.TransformPoint(place))) inside++;
            }

            return (double)inside / (samples * samples * samples);
        }
    }
}
