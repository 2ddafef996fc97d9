using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P15: the tests that a dirty brick costs with 4,096 spheres, beyond those that meet it.</summary>
    sealed class TestsPerBrick : IMeasure
    {
        const string Scene = "demo-crowd";

        public Quantity Quantity { get; } = new("P15", "with 4,096 spheres, tests of spheres per dirty brick beyond the spheres that meet it", "tests", [0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var work = SceneRun.Move(context.Stage, scene);
            if (work.SphereTests is not { } tests) return Outcome.NotMeasured(NewCounters.NoSphereTests);
            double met = BricksMet(scene);
            var bricks = work.ClipVoxels.Bricks;
            return new Outcome([Math.Max(0, tests / (double)bricks - met)], Scene, new JsonObject
            {
                ["spheres"] = scene.Spheres.Count, ["testsPerBrick"] = Json.Number(tests / (double)bricks), ["spheresPerBrick"] = Json.Number(met), ["work"] = work.ToJson(),
            });
        }

        // Spheres per brick near the moved one: what any brick of that part has to look at.
        static double BricksMet(BenchScene scene)
        {
            var geometry = scene.Volume.Geometry;
            var bricks = new BrickGrid(geometry);
            var grid = new CentredGrid(geometry);
            var active = scene.Spheres[^1];
            CarvingReach.TryVoxelBox(grid, grid.ToCentred(active), CutMode.Binary, 0, out var box);
            long entries = 0, count = 0;
            var mm = geometry.SpacingMm;
            var centres = scene.Spheres.Select(sphere => (Place: geometry.LpsToIjk.TransformPoint(sphere.CentreLps), sphere.RadiusMm)).ToArray();
            for (var z = box.MinK / 8; z <= box.MaxK / 8; z++)
            {
                for (var y = box.MinJ / 8; y <= box.MaxJ / 8; y++)
                {
                    for (var x = box.MinI / 8; x <= box.MaxI / 8; x++)
                    {
                        count++;
                        foreach (var (place, radius) in centres)
                        {
                            var (di, dj, dk) = (mm.X * Outside(place.X, x), mm.Y * Outside(place.Y, y), mm.Z * Outside(place.Z, z));
                            if (di * di + dj * dj + dk * dk <= radius * radius) entries++;
                        }
                    }
                }
            }

            return entries / (double)count;
        }

        static double Outside(double place, int brick) =>
            Math.Max(0, Math.Max(BrickGrid.BrickSize * brick - place, place - (BrickGrid.BrickSize * brick + BrickGrid.BrickSize - 1)));
    }

    /// <summary>P35: a move with 4,096 spheres in the stack against one with a single sphere.</summary>
    sealed class MoveInACrowd : IMeasure
    {
        const string Alone = "demo-move-40", Crowd = "demo-crowd";

        public Quantity Quantity { get; } = new("P35", "a move with 4,096 spheres in the stack against one with 1: tests of spheres, voxels", "times", [1.2, 1.2]);

        public Outcome Run(MeasureContext context)
        {
            var (alone, crowd) = (SceneRun.Move(context.Stage, context.Scenes.Get(Alone)), SceneRun.Move(context.Stage, context.Scenes.Get(Crowd)));
            if (alone.SphereTests is not > 0) return Outcome.NotMeasured(NewCounters.NoSphereTests);
            return new Outcome(
                [(double)crowd.SphereTests / (double)alone.SphereTests, (double)crowd.MostVoxels / alone.MostVoxels], string.Join(Outcome.Separator, Alone, Crowd),
                new JsonObject { ["alone"] = alone.ToJson(), ["crowd"] = crowd.ToJson() });
        }
    }
}
