using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P34: how smooth a label map looks. Balls that a label map holds or not by a voxel's centre, all of opacity 1, are seen in parallel projections
    /// at the default quality; their normals as seen against the balls' own there, where these lie within 70 degrees of the view. Smoothing must not
    /// cost thin structures their opacity: plates and vessels of two voxels' thickness keep at least 90 % of it.
    /// </summary>
    sealed class LabelSurfaces(int pictureSize) : IMeasure
    {
        const int DefaultPictureSize = 128;
        static readonly double MostSlanted = Math.Cos(70 * Math.PI / 180);
        static readonly Ball[] Balls =
        [
            new(new PointMm(0.21, -0.34, 0.13), 8), new(new PointMm(-0.42, 0.27, 0.36), 20), new(new PointMm(0.08, 0.45, -0.29), 28),
        ];

        /// <summary>What thin structures must keep of their opacity.</summary>
        const double MustKeepPercent = 90;

        public LabelSurfaces() : this(DefaultPictureSize)
        {
        }

        public Quantity Quantity { get; } = new(
            "P34", "a label map's surface: seen normals, mean and 99th percentile, while structures two voxels thin keep 90 % of their opacity", "degrees", [1.3, 4.5]);

        public Outcome Run(MeasureContext context)
        {
            AngleErrors all = new(), allAtSurface = new();
            var settings = new JsonObject { ["spacingMm"] = 1, ["views"] = ParallelViews.Directions.Length, ["pixels"] = pictureSize * pictureSize };
            foreach (var ball in Balls)
            {
                var (errors, atSurface) = MeasureBall(context.Stage, ball);
                all.Add(errors);
                allAtSurface.Add(atSurface);
                context.Cancellation.ThrowIfCancellationRequested();
                settings[$"radius {ball.RadiusMm}"] = errors.ToJson();
            }

            var kept = ThinStructures.Kept(context.Stage);
            if (kept == null) return Outcome.NotMeasured("the device has no compact layout");
            settings["kept"] = kept;
            context.Stage.ThrowIfFailed();
            settings["againstTheSurfaceThatTheRayMeets"] = allAtSurface.ToJson();
            settings["leastKept"] = LeastKept(kept);
            // Normals at the cost of what is thin do not count.
            return LeastKept(kept) >= MustKeepPercent
                ? new Outcome([all.Mean, all.Percentile99], "voxelised balls", settings)
                : new Outcome([double.PositiveInfinity, double.PositiveInfinity], "voxelised balls", settings);
        }

        static double LeastKept(JsonObject kept) => kept.Min(structure => (double)structure.Value);

        (AngleErrors Normals, AngleErrors AtSurface) MeasureBall(BenchStage stage, Ball ball)
        {
            var size = (int)(2 * ball.RadiusMm) + 12;
            stage.Show(PhantomVolumes.OfSegments(Grids.Centred(size, size, size), 1, place => ball.Holds(place) ? 1 : 0));
            stage.Renderer.TransferFunction = PhantomVolumes.Everything;
            AngleErrors errors = new(), atSurface = new();
            foreach (var direction in ParallelViews.Directions)
            {
                var rays = ParallelViews.Along(direction, ball.Centre, 2 * ball.RadiusMm, pictureSize, 3 * ball.RadiusMm);
                var seen = SeenNormals.Look(stage.Renderer, rays);
                for (var pixel = 0; pixel < pictureSize * pictureSize; pixel++)
                {
                    var ray = rays.RayThroughPixel(pixel % pictureSize, pixel / pictureSize);
                    var enter = ball.Crossing(ray).In;
                    if (double.IsNaN(enter)) continue;
                    if (-ball.NormalAt(ray.At(enter)).Dot(ray.Direction) < MostSlanted) continue;
                    errors.Add(seen.Normals[pixel], ball.NormalAt(ray.At(seen.Shows(pixel) ? seen.LitMm[pixel] : enter)));
                    atSurface.Add(seen.Normals[pixel], ball.NormalAt(ray.At(enter)));
                }
            }

            return (errors, atSurface);
        }
    }
}
