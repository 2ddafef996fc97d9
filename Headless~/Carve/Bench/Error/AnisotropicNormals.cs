using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Phantoms;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P17: stored normals of balls on grids whose voxels are twice as long along one axis. Opacities are the ball's true share of each voxel, in eight bits;
    /// counted are the voxels at the surface, of opacity 0.2 to 0.8.
    /// </summary>
    sealed class AnisotropicNormals : IMeasure
    {
        const int Samples = 12;
        const double LowestOpacity = 0.2 * 255, HighestOpacity = 0.8 * 255;

        static readonly double[][] Spacings = [[1, 1, 2], [1, 2, 1], [2, 1, 1]];
        static readonly Ball[] Balls = [new(new PointMm(0.3, -0.2, 0.45), 14.3), new(new PointMm(-0.4, 0.15, -0.3), 20.7)];

        public Quantity Quantity { get; } = new("P17", "stored normals at anisotropy 2, mean and largest", "degrees", [2, 7]);

        public Outcome Run(MeasureContext context)
        {
            var all = new AngleErrors();
            var settings = new JsonObject { ["radiiMm"] = new JsonArray([.. Balls.Select(ball => (JsonNode)ball.RadiusMm)]), ["opacities"] = "0.2 to 0.8" };
            foreach (var spacing in Spacings)
            {
                foreach (var ball in Balls)
                {
                    var errors = Measure(context.Stage, spacing, ball);
                    if (errors == null) return Outcome.NotMeasured("the device has no compact layout");
                    all.Add(errors);
                    settings[FormattableString.Invariant($"{spacing[0]}x{spacing[1]}x{spacing[2]} mm, radius {ball.RadiusMm}")] = errors.ToJson();
                }
            }

            context.Stage.ThrowIfFailed();
            return new Outcome([all.Mean, all.Max], "balls, spacing 1:2", settings);
        }

        static AngleErrors Measure(BenchStage stage, double[] spacing, Ball ball)
        {
            int Voxels(double spacingMm) => (int)Math.Ceiling(2 * (ball.RadiusMm + 5) / spacingMm);
            var geometry = Grids.Centred(Voxels(spacing[0]), Voxels(spacing[1]), Voxels(spacing[2]), spacing[0], spacing[1], spacing[2]);
            var opacities = new byte[geometry.VoxelCount];
            Grids.ForEach(geometry, (i, j, k, voxel) => opacities[voxel] = (byte)Math.Round(255 * ball.Coverage(geometry, i, j, k, Samples)));
            stage.Show(PhantomVolumes.OfOpacities(geometry, opacities));
            stage.Renderer.TransferFunction = PhantomVolumes.EightBits;
            stage.Renderer.Render(ParallelViews.Along(new VectorMm(0, 0, 1), geometry.CentreLps, 10, 8, 100));
            var codes = Texels.ReadPackageTexture(stage.Renderer, "AnatomyCarve normals");
            if (codes == null) return null;
            var errors = new AngleErrors();
            Grids.ForEach(geometry, (i, j, k, voxel) =>
            {
                if (opacities[voxel] >= LowestOpacity && opacities[voxel] <= HighestOpacity)
                {
                    var place = geometry.IjkToLps.TransformPoint(new PointMm(i, j, k));
                    errors.Add(Octahedral.Decode(codes[2 * voxel], codes[2 * voxel + 1]), ball.NormalAt(place));
                }
            });
            return errors;
        }
    }
}
