using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P4: which bricks a toggled segment recomputes, against those that hold the segment and meet the sphere.</summary>
    sealed class ToggledSegment : IMeasure
    {
        const string Scene = "demo-toggle";

        public Quantity Quantity { get; } = new(
            "P4", "bricks that a toggled segment recomputes beyond those that hold the segment and meet the sphere, and the stages' halos", "bricks", [0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var work = SceneRun.Edit(context.Stage, scene, carving => carving.ToggleSegment(scene.Toggled));
            var needed = Needed(scene);
            if (needed.Count == 0) throw new CommandException($"scene \"{Scene}\": the sphere does not meet the segment.");
            var bricks = new BrickGrid(scene.Volume.Geometry);
            var around = Around(bricks, needed);
            var excess = Math.Max(0, work.ClipVoxels.Bricks - needed.Count) + Math.Max(0, work.AntiAlias.Bricks - around.Count)
                + Math.Max(0, work.SobelNormals.Bricks - around.Count);
            return new Outcome([excess], Scene, new JsonObject
            {
                ["segment"] = scene.Toggled, ["needed"] = needed.Count, ["withHalo"] = around.Count, ["bricksOfVolume"] = bricks.Count, ["work"] = work.ToJson(),
            });
        }

        // Bricks that hold a voxel of the segment and lie within the sphere's reach, box against sphere.
        static HashSet<int> Needed(BenchScene scene)
        {
            var geometry = scene.Volume.Geometry;
            var bricks = new BrickGrid(geometry);
            var sphere = scene.Spheres[^1];
            var centre = geometry.LpsToIjk.TransformPoint(sphere.CentreLps);
            var indices = scene.Volume.Labels.Indices;
            var needed = new HashSet<int>();
            for (int k = 0, voxel = 0; k < geometry.SizeK; k++)
            {
                for (var j = 0; j < geometry.SizeJ; j++)
                {
                    for (var i = 0; i < geometry.SizeI; i++, voxel++)
                    {
                        if (indices[voxel] == scene.Toggled) needed.Add(bricks.IndexOfVoxel(i, j, k));
                    }
                }
            }

            needed.RemoveWhere(brick =>
            {
                bricks.BrickAt(brick, out var x, out var y, out var z);
                var mm = geometry.SpacingMm;
                var (di, dj, dk) = (mm.X * Outside(centre.X, x), mm.Y * Outside(centre.Y, y), mm.Z * Outside(centre.Z, z));
                return di * di + dj * dj + dk * dk > sphere.RadiusMm * sphere.RadiusMm * (1 + 1e-5);
            });
            return needed;
        }

        // How far a place lies outside of a brick's voxel centres along an axis, in voxels.
        static double Outside(double place, int brick) =>
            Math.Max(0, Math.Max(BrickGrid.BrickSize * brick - place, place - (BrickGrid.BrickSize * brick + BrickGrid.BrickSize - 1)));

        static HashSet<int> Around(BrickGrid bricks, HashSet<int> needed) => needed.SelectMany(brick =>
        {
            bricks.BrickAt(brick, out var x, out var y, out var z);
            return from dz in Enumerable.Range(-1, 3)
                   from dy in Enumerable.Range(-1, 3)
                   from dx in Enumerable.Range(-1, 3)
                   where x + dx >= 0 && x + dx < bricks.BricksX && y + dy >= 0 && y + dy < bricks.BricksY && z + dz >= 0 && z + dz < bricks.BricksZ
                   select bricks.IndexOf(x + dx, y + dy, z + dz);
        }).ToHashSet();
    }
}
