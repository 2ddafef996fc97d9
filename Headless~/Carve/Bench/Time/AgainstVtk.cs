using System;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Headless.Cli.Bench.Vtk;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Time
{
    /// <summary>P31: the ray pass against VTK's ray casters on the same opacity field, with the same camera, on the same CPU.</summary>
    sealed class AgainstVtk : IMeasure
    {
        const string Scene = "cube-move";
        const int Threads = 2;
        const int MostRuns = 3;

        public Quantity Quantity { get; } = new(
            "P31", "ray pass against VTK on the same CPU: fixed-point ray caster with 2 threads, GPU mapper on llvmpipe", Quantity.TimeUnit, [1 / 2.5, 1 / 25.0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            stage.Update();
            var folder = Directory.CreateTempSubdirectory("carve-vtk-");
            try
            {
                var (vtk, problem) = VtkSession.Start(WriteInputs(stage, scene, folder.FullName));
                if (vtk == null) return Outcome.NotMeasured(problem);
                using (vtk) return Measure(context, scene, vtk);
            }
            catch (IOException exception)
            {
                return Outcome.NotMeasured(exception.Message);
            }
            finally
            {
                folder.Delete(recursive: true);
            }
        }

        static Outcome Measure(MeasureContext context, BenchScene scene, VtkSession vtk)
        {
            var stage = context.Stage;
            var rays = new FreshRays(scene.Rays());
            var timings = Turns.Measure(context, Math.Min(context.Runs, MostRuns),
                new TimedWay("rays", null, () => stage.Render(rays.Next())),
                new TimedWay("vtk fixed-point", null, () => vtk.Ask("fixed")),
                new TimedWay("vtk gpu", null, () => vtk.Ask("gpu")));
            var alpha = stage.Render(rays.Next()).Read().Color.Count(color => color.a > 8 / 255f) / (double)(scene.Width * scene.Height);
            return new Outcome([timings[0].Median / timings[1].Median, timings[0].Median / timings[2].Median], Scene, new JsonObject
            {
                ["times"] = Turns.ToJson(timings), ["vtk"] = vtk.Version, ["threads"] = Threads, ["size"] = scene.Width, ["stepVoxels"] = 0.5, ["quality"] = "balanced",
                ["litShares"] = new JsonObject
                {
                    ["rays"] = Json.Number(Math.Round(alpha, 4)), ["fixed-point"] = vtk.Ask("lit fixed")["lit"].DeepClone(), ["gpu"] = vtk.Ask("lit gpu")["lit"].DeepClone(),
                },
            });
        }

        // The field as the rays see it, and the camera in VTK's space: voxel (0, 0, 0) is the origin, axes as the volume's.
        static string WriteInputs(BenchStage stage, BenchScene scene, string folder)
        {
            var field = Path.Combine(folder, "opacity.raw");
            var geometry = scene.Volume.Geometry;
            File.WriteAllBytes(field, stage.ReadAntiAliased());
            var (orbit, spacing) = (scene.Camera(), geometry.SpacingMm);
            var rays = scene.Rays();
            JsonArray Place(PointMm lps)
            {
                var offset = lps - geometry.IjkToLps.Origin;
                return new JsonArray(offset.X, offset.Y, offset.Z);
            }

            var settings = new JsonObject
            {
                ["field"] = field, ["dims"] = new JsonArray(geometry.SizeI, geometry.SizeJ, geometry.SizeK), ["spacing"] = new JsonArray(spacing.X, spacing.Y, spacing.Z),
                ["unit"] = geometry.ReferenceLengthMm, ["step"] = 0.5 * geometry.ReferenceLengthMm, ["threads"] = Threads, ["eye"] = Place(rays.Origin),
                ["target"] = Place(geometry.CentreLps), ["up"] = new JsonArray(orbit.UpLps.X, orbit.UpLps.Y, orbit.UpLps.Z), ["fov"] = orbit.VerticalFovDegrees,
                ["size"] = scene.Width,
            };
            var path = Path.Combine(folder, "settings.json");
            File.WriteAllText(path, Json.Text(settings));
            return path;
        }
    }
}
