using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Headless.Cli.Bench.Time;
using AnatomyCarve.Headless.Cli.Bench.Work;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench
{
    /// <summary>What pictures and edits of any volume cost: counts beside times.</summary>
    static class VolumeBench
    {
        /// <summary>The parts of the volume's smallest side that the spheres' radii are.</summary>
        static readonly double[] RadiusShares = [0.06, 0.17, 0.33];

        /// <summary>How far the spheres move, in parts of their radius.</summary>
        const double MoveShare = 0.125;

        public static readonly string[] RenderTitles = ["picture", "ms", "least", "most", "rays", "samples", "samples a ray", "look-ups a ray"];
        public static readonly string[] EditTitles = ["edit", "ms", "least", "most", "bricks", "voxels", "% of the volume", "sphere tests"];

        /// <summary>Pictures by each preset.</summary>
        public static IReadOnlyList<string[]> Render(MeasureContext context, SegmentedVolume volume, OpacityTransferFunction function, int width, int height)
        {
            var stage = context.Stage;
            stage.Show(volume);
            stage.Renderer.TransferFunction = function;
            var view = new OrbitCamera(20, 10).RaysAround(volume.Geometry, width, height);
            var met = VolumeBox.CountRays(view, volume.Geometry);
            return RenderQuality.Names.Select(name =>
            {
                stage.Renderer.Quality = RenderQuality.Named(name);
                stage.Renderer.CountSamples = false;
                stage.Update();
                var rays = new FreshRays(view);
                var timing = Turns.Measure(context, new TimedWay(name, null, () => stage.Render(rays.Next())))[0];
                stage.Renderer.CountSamples = true;
                var picture = stage.Render(rays.Next());
                var samples = picture.ReadSampleCount();
                return new[]
                {
                    name, Text(timing.Median), Text(timing.Milliseconds.Min()), Text(timing.Milliseconds.Max()), met.ToString(CultureInfo.InvariantCulture),
                    samples.ToString(CultureInfo.InvariantCulture), Text((double)samples / met), Text((double)picture.ReadLookupCount() / met),
                };
            }).ToArray();
        }

        /// <summary>A full update, and spheres of three sizes that move.</summary>
        public static IReadOnlyList<string[]> Edit(MeasureContext context, SegmentedVolume volume, OpacityTransferFunction function)
        {
            var stage = context.Stage;
            var geometry = volume.Geometry;
            stage.Show(volume);
            stage.Renderer.TransferFunction = function;
            var side = new[] { geometry.SizeI * geometry.SpacingMm.X, geometry.SizeJ * geometry.SpacingMm.Y, geometry.SizeK * geometry.SpacingMm.Z }.Min();
            var rows = new List<string[]>();
            void Add(string name, TimedWay way)
            {
                var timing = Turns.Measure(context, way)[0];
                way.Prepare(context.Runs);
                stage.Renderer.Statistics.Reset();
                stage.Update();
                var work = SceneRun.Work(stage);
                var bricks = new[] { work.ClipVoxels.Bricks, work.AntiAlias.Bricks, work.SobelNormals.Bricks }.Max();
                rows.Add(
                [
                    name, Text(timing.Median), Text(timing.Milliseconds.Min()), Text(timing.Milliseconds.Max()), bricks.ToString(CultureInfo.InvariantCulture),
                    work.MostVoxels.ToString(CultureInfo.InvariantCulture), Text(100.0 * work.MostVoxels / geometry.VoxelCount),
                    work.SphereTests.ToString(CultureInfo.InvariantCulture),
                ]);
            }

            Add("full update", new TimedWay("full", _ => FullUpdate.Force(stage), stage.Update));
            foreach (var share in RadiusShares)
            {
                var radius = share * side;
                void Move(int run) => stage.Carving.SetActive(geometry.CentreLps + run % 2 * MoveShare * radius * new VectorMm(0.48, -0.64, 0.6), radius);
                Add($"sphere of {Text(radius)} mm moves {Text(MoveShare * radius)} mm", new TimedWay("moved", Move, stage.Update, WarmUps: 2));
            }

            return rows;
        }

        static string Text(double value) => value.ToString(value >= 100 ? "0" : "0.##", CultureInfo.InvariantCulture);
    }
}
