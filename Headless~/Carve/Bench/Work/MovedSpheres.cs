using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P1: what a frame in which nothing changed costs the volume.</summary>
    sealed class UnchangedFrame : IMeasure
    {
        const int Frames = 10;
        const string Scene = "demo-move-40";

        public Quantity Quantity { get; } = new("P1", "invocations of volume kernels in a frame in which nothing changed", "invocations", [0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            stage.Render(scene.Rays(64, 64));
            stage.Renderer.Statistics.Reset();
            for (var frame = 0; frame < Frames; frame++)
            {
                stage.Host.Step();
                stage.Render(scene.Rays(64, 64));
            }

            return new Outcome([(double)SceneRun.Work(stage).Invocations / Frames], Scene, new JsonObject { ["frames"] = Frames, ["volumeDispatches"] = stage.Renderer.Statistics.VolumeDispatches });
        }
    }

    /// <summary>P2: a sphere of 40 mm moves 5 mm.</summary>
    sealed class MovedSphere : IMeasure
    {
        const string Scene = "demo-move-40";

        public Quantity Quantity { get; } =
            new("P2", "voxels processed anew when a sphere of 40 mm moves 5 mm, in the stage that processes most", "% of the volume", [1.5]);

        public Outcome Run(MeasureContext context)
        {
            var settings = new JsonObject();
            var value = SceneRun.MovedPercent(context, Scene, settings);
            var others = new JsonObject();
            foreach (var name in SceneRun.Present(context, "head-move-40", "ct-move-40")) others[name] = SceneRun.MovedPercent(context, name, settings);
            settings["othersPercent"] = others;
            return new Outcome([value], Scene, settings);
        }
    }

    /// <summary>P3: the same for a larger and a smaller sphere.</summary>
    sealed class MovedSpheresOfOtherSizes : IMeasure
    {
        static readonly string[] Scenes = ["demo-move-80", "demo-move-15"];

        public Quantity Quantity { get; } = new("P3", "the same for spheres of 80 mm and of 15 mm", "% of the volume", [6, 0.2]);

        public Outcome Run(MeasureContext context)
        {
            var settings = new JsonObject();
            return new Outcome(Scenes.Select(name => SceneRun.MovedPercent(context, name, settings)).ToArray(), string.Join(Outcome.Separator, Scenes), settings);
        }
    }
}
