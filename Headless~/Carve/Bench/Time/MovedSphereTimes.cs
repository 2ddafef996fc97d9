using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Reference;
using AnatomyCarve.Headless.Cli.Bench.Work;

namespace AnatomyCarve.Headless.Cli.Bench.Time
{
    /// <summary>P20: the volume's kernels for a moved sphere, against a full update by the same kernels and against the reference path.</summary>
    sealed class MovedSphereTime : IMeasure
    {
        const string Scene = "cube-move";

        public Quantity Quantity { get; } = new(
            "P20", "volume kernels for a moved sphere, with the CPU's part: against a full update by the same kernels, against the reference path", Quantity.TimeUnit,
            [1 / 40.0, 1 / 250.0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            stage.Update();
            using var reference = new ReferencePath(stage, scene);
            var timings = Turns.Measure(context,
                new TimedWay("moved", run => SceneRun.MoveActive(stage.Carving, scene, run % 2 == 0 ? 1 : 0), stage.Update, WarmUps: 2),
                new TimedWay("full", _ => FullUpdate.Force(stage), stage.Update),
                new TimedWay("reference", run => reference.MoveActive(run % 2 == 0 ? 1 : 0), reference.UpdateVolume));
            var moved = SceneRun.Move(stage, scene);
            var full = SceneRun.Full(stage);
            var settings = new JsonObject
            {
                ["times"] = Turns.ToJson(timings), ["referenceBytesPerVoxel"] = reference.BytesPerVoxel,
                ["work"] = new JsonObject { ["moved"] = moved.ToJson(), ["full"] = full.ToJson() },
            };
            return new Outcome([timings[0].Median / timings[1].Median, timings[0].Median / timings[2].Median], Scene, settings);
        }
    }

    /// <summary>P33: a whole frame with a moved sphere against the reference path's.</summary>
    sealed class MovedFrameTime : IMeasure
    {
        const string Scene = "cube-move";

        public Quantity Quantity { get; } = new(
            "P33", "a frame with a moved sphere (volume kernels, skip structure, rays at 512 x 512) against the reference path's", Quantity.TimeUnit, [1 / 75.0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            var rays = scene.Rays();
            stage.Render(rays);
            using var reference = new ReferencePath(stage, scene);
            var timings = Turns.Measure(context,
                new TimedWay("frame", run => SceneRun.MoveActive(stage.Carving, scene, run % 2 == 0 ? 1 : 0), () => stage.Render(rays), WarmUps: 2),
                new TimedWay("reference", run => reference.MoveActive(run % 2 == 0 ? 1 : 0), () =>
                {
                    reference.UpdateVolume();
                    reference.Render();
                }));
            return new Outcome([timings[0].Median / timings[1].Median], Scene, new JsonObject
            {
                ["times"] = Turns.ToJson(timings), ["size"] = new JsonArray(scene.Width, scene.Height), ["quality"] = "balanced",
                ["referenceOpaquePixels"] = Json.Number(reference.OpaqueShare(stage)),
            });
        }
    }

    /// <summary>P21: rays with skipping and termination against the same loop without both.</summary>
    sealed class RayPassTime : IMeasure
    {
        const string Scene = "cube-move";

        public Quantity Quantity { get; } = new("P21", "ray pass with skipping and termination against the same loop without both", Quantity.TimeUnit, [1 / 9.0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            var (lean, plain) = (RenderQuality.Balanced(), RenderQuality.Balanced());
            plain.OpaqueAlpha = 1;
            plain.SkipEmptySpace = false;
            stage.Update();
            var rays = new FreshRays(scene.Rays());
            TimedWay Way(string name, RenderQuality quality) => new(name, _ => stage.Renderer.Quality = quality, () => stage.Render(rays.Next()));
            var timings = Turns.Measure(context, Way("skipping and termination", lean), Way("neither", plain));
            return new Outcome([timings[0].Median / timings[1].Median], Scene, new JsonObject
            {
                ["times"] = Turns.ToJson(timings), ["size"] = new JsonArray(scene.Width, scene.Height), ["quality"] = "balanced",
            });
        }
    }
}
