using System.Collections.Generic;
using System.Globalization;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Headless.Cli.Bench.Time;
using AnatomyCarve.Headless.Cli.Bench.Work;

namespace AnatomyCarve.Headless.Cli.Bench.Pareto
{
    /// <summary>A point of a scaling curve.</summary>
    /// <param name="Curve">what grows: "voxels per side", "spheres", "pixels per side"</param>
    /// <param name="Size">how large it is</param>
    /// <param name="What">what was timed: "full update", "moved sphere", "rays"</param>
    /// <param name="Timing">milliseconds</param>
    /// <param name="Elements">voxels of the stage that processed most, or rays</param>
    sealed record ScalingPoint(string Curve, int Size, string What, Timing Timing, long Elements);

    /// <summary>How times grow with the volume, the spheres and the picture.</summary>
    static class ScalingCurves
    {
        public const string Voxels = "voxels per side", Spheres = "spheres", Pixels = "pixels per side";

        static readonly (int Side, string Scene)[] Volumes = [(64, "cube-move-64"), (128, "cube-move-128"), (192, "cube-move-192"), (256, "cube-move")];
        static readonly int[] Crowds = [1, 16, 256, 4096];
        static readonly int[] Pictures = [128, 256, 512, 1024];

        public static IReadOnlyList<ScalingPoint> Measure(MeasureContext context)
        {
            var points = new List<ScalingPoint>();
            foreach (var (side, name) in Volumes) AddVolume(points, context, Voxels, side, context.Scenes.Get(name), rays: true);
            foreach (var count in Crowds)
            {
                AddVolume(points, context, Spheres, count, context.Scenes.Get("cube-crowd-" + count.ToString(CultureInfo.InvariantCulture)), rays: false);
            }

            var scene = context.Scenes.Get("cube-move");
            context.Stage.Show(scene);
            context.Stage.Update();
            foreach (var side in Pictures) AddRays(points, context, Pixels, side, scene, side);
            return points;
        }

        /// <summary>One line per point.</summary>
        public static string ToCsv(IEnumerable<ScalingPoint> points)
        {
            var lines = new List<string> { "curve,size,what,ms,least ms,most ms,elements" };
            foreach (var (curve, size, what, timing, elements) in points)
            {
                var times = timing.ToJson();
                lines.Add(string.Create(CultureInfo.InvariantCulture,
                    $"{curve},{size},{what},{(double)times["medianMs"]},{(double)times["leastMs"]},{(double)times["mostMs"]},{elements}"));
            }

            return string.Join('\n', lines) + "\n";
        }

        static void AddVolume(List<ScalingPoint> points, MeasureContext context, string curve, int size, BenchScene scene, bool rays)
        {
            var stage = context.Stage;
            stage.Show(scene);
            stage.Update();
            var timings = Turns.Measure(context,
                new TimedWay("full update", _ => FullUpdate.Force(stage), stage.Update),
                new TimedWay("moved sphere", run => SceneRun.MoveActive(stage.Carving, scene, run % 2 == 0 ? 1 : 0), stage.Update, WarmUps: 2));
            points.Add(new ScalingPoint(curve, size, timings[0].Name, timings[0], scene.Volume.Geometry.VoxelCount));
            points.Add(new ScalingPoint(curve, size, timings[1].Name, timings[1], SceneRun.Move(stage, scene).MostVoxels));
            if (rays) AddRays(points, context, curve, size, scene, scene.Width);
        }

        static void AddRays(List<ScalingPoint> points, MeasureContext context, string curve, int size, BenchScene scene, int side)
        {
            var rays = new FreshRays(scene.Rays(side, side));
            var timing = Turns.Measure(context, new TimedWay("rays", null, () => context.Stage.Render(rays.Next())))[0];
            points.Add(new ScalingPoint(curve, size, timing.Name, timing, (long)side * side));
        }
    }
}
