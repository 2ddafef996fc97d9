using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P15: the spheres that a dirty brick is given with 4,096 in the stack, beyond those that meet it.</summary>
    sealed class TestsPerBrick : IMeasure
    {
        const string Scene = "demo-crowd";

        public Quantity Quantity { get; } = new("P15", "with 4,096 spheres, those that a dirty brick's voxels are tested against beyond those that meet it", "tests", [0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var work = SceneRun.Move(context.Stage, scene);
            var given = work.SpheresInBricks;
            // ClipVoxels needs those of its bricks; the normals of cuts those of theirs and around.
            var met = Met(scene, 0) + Met(scene, CarvingReach.NormalsVoxels);
            double bricks = work.ClipVoxels.Bricks + work.SobelNormals.Bricks;
            return new Outcome([Math.Max(0, given - met) / bricks], Scene, new JsonObject
            {
                ["spheres"] = scene.Spheres.Count, ["givenPerBrick"] = Json.Number(given / bricks), ["given"] = given, ["mostThatCouldMeet"] = met, ["work"] = work.ToJson(),
            });
        }

        // Spheres that meet the bricks in which the move can change anything: those that the sphere meets before or after, but for bricks inside it both times.
        static long Met(BenchScene scene, int haloVoxels)
        {
            var geometry = scene.Volume.Geometry;
            var grid = new CentredGrid(geometry);
            var before = scene.Spheres[^1];
            var after = before.WithCenter(before.CentreLps + scene.Move);
            CarvingReach.TryVoxelBox(grid, grid.ToCentred(before.WithRadius(before.RadiusMm + scene.Move.Length)), CutMode.Binary, haloVoxels, out var box);
            var crowd = scene.Spheres.Take(scene.Spheres.Count - 1).ToArray();
            long met = 0;
            for (var z = box.MinK / BrickGrid.BrickSize; z <= box.MaxK / BrickGrid.BrickSize; z++)
            {
                for (var y = box.MinJ / BrickGrid.BrickSize; y <= box.MaxJ / BrickGrid.BrickSize; y++)
                {
                    for (var x = box.MinI / BrickGrid.BrickSize; x <= box.MaxI / BrickGrid.BrickSize; x++)
                    {
                        (double Near, double Far) To(ClipSphere sphere) => Distances(geometry, sphere, x, y, z, haloVoxels);
                        var ((nearBefore, farBefore), (nearAfter, farAfter)) = (To(before), To(after));
                        var isTouched = nearBefore <= before.RadiusMm || nearAfter <= after.RadiusMm;
                        if (!isTouched || (farBefore < before.RadiusMm && farAfter < after.RadiusMm)) continue;
                        met += 1 + crowd.Count(sphere => To(sphere).Near <= sphere.RadiusMm);
                    }
                }
            }

            return met;
        }

        // From a sphere's centre to the nearest and the farthest voxel of a brick and its halo, in grids whose axes are at right angles.
        static (double Near, double Far) Distances(VolumeGeometry geometry, ClipSphere sphere, int x, int y, int z, int halo)
        {
            var place = geometry.LpsToIjk.TransformPoint(sphere.CentreLps);
            double near = 0, far = 0;
            foreach (var (along, brick, mm) in new[] { (place.X, x, geometry.SpacingMm.X), (place.Y, y, geometry.SpacingMm.Y), (place.Z, z, geometry.SpacingMm.Z) })
            {
                double low = BrickGrid.BrickSize * brick - halo, high = BrickGrid.BrickSize * brick + BrickGrid.BrickSize - 1 + halo;
                near += Square(mm * Math.Max(0, Math.Max(low - along, along - high)));
                far += Square(mm * Math.Max(Math.Abs(along - low), Math.Abs(along - high)));
            }

            return (Math.Sqrt(near), Math.Sqrt(far));
        }

        static double Square(double value) => value * value;
    }

    /// <summary>P35: a move with 4,096 spheres in the stack, none of which meets the moved one, against one with a single sphere.</summary>
    sealed class MoveInACrowd : IMeasure
    {
        const string Alone = "demo-move-40", Crowd = "demo-crowd-away";

        public Quantity Quantity { get; } = new("P35", "a move with 4,096 spheres in the stack against one with 1: tests of spheres, voxels", "times", [1.2, 1.2]);

        public Outcome Run(MeasureContext context)
        {
            var (alone, crowd) = (SceneRun.Move(context.Stage, context.Scenes.Get(Alone)), SceneRun.Move(context.Stage, context.Scenes.Get(Crowd)));
            return new Outcome(
                [(double)crowd.SphereTests / alone.SphereTests, (double)crowd.MostVoxels / alone.MostVoxels], string.Join(Outcome.Separator, Alone, Crowd),
                new JsonObject { ["alone"] = alone.ToJson(), ["crowd"] = crowd.ToJson() });
        }
    }
}
