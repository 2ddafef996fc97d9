using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P11: the depth of the first hit on a hard edge, in steps. Opacity is 0 before a plane and 1 behind it; voxels make a ramp of it. Rays meet it at all
    /// angles up to 55 degrees from its normal, so that the edge lies anywhere in a step.
    /// </summary>
    sealed class FirstHitDepth : IMeasure
    {
        const int Size = 40, Edge = 12, Depth = 24;
        const int PictureSize = 64, Pictures = 6;
        const double DefaultStep = 0.5;
        static readonly double[] OtherSteps = [0.25, 1];

        public Quantity Quantity { get; } = new("P11", "depth of the first hit on a hard edge, RMS", "steps", [0.02]);

        public Outcome Run(MeasureContext context)
        {
            var field = new RayField(Grids.Centred(Size, Size, Depth));
            Grids.ForEach(field.Geometry, (i, j, k, voxel) => field.Opacities[voxel] = k > Edge ? 1 : 0);
            var (rms, largest, rays) = Measure(field, DefaultStep);
            var settings = new JsonObject
            {
                ["voxels"] = $"{Size}x{Size}x{Depth}, 1 mm",
                ["edge"] = $"between k = {Edge} and {Edge + 1}",
                ["stepVoxels"] = DefaultStep,
                ["rays"] = rays,
                ["largest"] = largest,
            };
            foreach (var step in OtherSteps)
            {
                var other = Measure(field, step);
                settings[FormattableString.Invariant($"step {step}")] = new JsonObject { ["rms"] = other.Rms, ["largest"] = other.Largest };
            }

            return new Outcome([rms], "edge from 0 to 1", settings);
        }

        static (double Rms, double Largest, int Rays) Measure(RayField field, double step)
        {
            var random = new Random(11);
            var errors = Enumerable.Range(0, Pictures).SelectMany(_ => Errors(field, RandomView(random), step)).ToArray();
            return (Math.Sqrt(errors.Average(error => error * error)), errors.Max(Math.Abs), errors.Length);
        }

        /// <summary>From in front of the edge, near enough that every ray meets it within the volume.</summary>
        static PictureRays RandomView(Random random)
        {
            double Within(double most) => most * (2 * random.NextDouble() - 1);
            var eye = new PointMm(Within(8), Within(8), -13 - 3 * random.NextDouble());
            return PictureRays.Perspective(eye, new PointMm(Within(3), Within(3), 1), new VectorMm(0.3, 1, 0), 50, PictureSize, PictureSize);
        }

        static double[] Errors(RayField field, PictureRays rays, double step)
        {
            var found = field.March(rays, step, new VectorMm(0, 0, -1)).DepthsMm;
            return found.Select((depth, pixel) =>
            {
                var ray = rays.RayThroughPixel(pixel % PictureSize, pixel / PictureSize);
                return (depth - TrueDepth(field.Geometry, ray)) / step;
            }).ToArray();
        }

        static double TrueDepth(VolumeGeometry geometry, RayMm ray)
        {
            var edgeMm = geometry.IjkToLps.TransformPoint(new PointMm(0, 0, Edge + 0.5)).Z;
            return (edgeMm - ray.Origin.Z) / ray.Direction.Z;
        }
    }
}
