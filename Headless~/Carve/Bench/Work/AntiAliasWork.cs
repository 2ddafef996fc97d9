using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text.Json.Nodes;
using System.Text.RegularExpressions;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P18: texture fetches per voxel in AntiAlias: the tile that a group of threads shares, over the voxels that it writes.</summary>
    sealed partial class AntiAliasFetches : IMeasure
    {
        const string Scene = "demo-move-40";

        public Quantity Quantity { get; } = new("P18", "texture fetches per voxel in AntiAlias", "fetches", [4]);

        public Outcome Run(MeasureContext context)
        {
            var tile = File.ReadAllText(Path.Combine(BenchFiles.Root, "Shaders", "OpacityTile.hlsl"));
            if (TileMargin().Match(tile) is not { Success: true } margin) return Outcome.NotMeasured("Shaders/OpacityTile.hlsl does not say how large a tile is.");
            var scene = context.Scenes.Get(Scene);
            var work = SceneRun.Move(context.Stage, scene);
            var side = BrickGrid.BrickSize + int.Parse(margin.Groups[1].ValueSpan, CultureInfo.InvariantCulture);
            return new Outcome([(double)work.AntiAlias.Bricks * side * side * side / work.AntiAlias.Elements], Scene, new JsonObject
            {
                ["tileVoxels"] = side * side * side, ["bricks"] = work.AntiAlias.Bricks, ["voxels"] = work.AntiAlias.Elements,
            });
        }

        [GeneratedRegex(@"#define TILE_SIZE \(BRICK_SIZE \+ (\d+)\)")]
        private static partial Regex TileMargin();
    }

    /// <summary>P19: how many of the voxels around an edit have 27 equal opacities, so that AntiAlias has nothing to blend.</summary>
    sealed class EqualNeighbourhoods : IMeasure
    {
        const string Scene = "demo-move-40";

        public Quantity Quantity { get; } = new("P19", "voxels of the dirty bricks whose 27 opacities agree", "%", [70], AtLeast: true);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var (before, after) = (Field(scene, 0), Field(scene, 1));
            var bricks = after.Bricks;
            long voxels = 0, equal = 0;
            var dirty = Dirty(before, after, scene);
            foreach (var brick in dirty)
            {
                bricks.BrickAt(brick, out var x, out var y, out var z);
                for (var k = 8 * z; k < Math.Min(8 * z + 8, bricks.SizeK); k++)
                {
                    for (var j = 8 * y; j < Math.Min(8 * y + 8, bricks.SizeJ); j++)
                    {
                        for (var i = 8 * x; i < Math.Min(8 * x + 8, bricks.SizeI); i++)
                        {
                            voxels++;
                            if (Agree(after, i, j, k)) equal++;
                        }
                    }
                }
            }

            return new Outcome([100.0 * equal / voxels], Scene, new JsonObject { ["bricks"] = dirty.Count, ["voxels"] = voxels });
        }

        static CarvedField Field(BenchScene scene, double moves)
        {
            var active = scene.Spheres[^1];
            var field = new CarvedField(scene.Volume, 256L << 20);
            field.Update([active.WithCenter(active.CentreLps + moves * scene.Move)], scene.TransferFunction ?? scene.Volume.AutomaticTransferFunction,
                scene.Segments ?? scene.Volume.Segments, CutMode.Binary, AntiAliasSettings.Default);
            return field;
        }

        // Bricks with a voxel that has a changed opacity among its 27.
        static HashSet<int> Dirty(CarvedField before, CarvedField after, BenchScene scene)
        {
            var dirty = new HashSet<int>();
            var (bricks, grid) = (after.Bricks, after.Grid);
            var active = scene.Spheres[^1];
            var reach = active.WithRadius(active.RadiusMm + scene.Move.Length);
            CarvingReach.TryVoxelBox(grid, grid.ToCentred(reach), CutMode.Binary, 0, out var box);
            for (var k = box.MinK; k <= box.MaxK; k++)
            {
                for (var j = box.MinJ; j <= box.MaxJ; j++)
                {
                    for (var i = box.MinI; i <= box.MaxI; i++)
                    {
                        if (before.OpacityCode(i, j, k) != after.OpacityCode(i, j, k)) AddAround(dirty, bricks, i, j, k);
                    }
                }
            }

            return dirty;
        }

        static void AddAround(HashSet<int> dirty, BrickGrid bricks, int i, int j, int k)
        {
            for (var z = Math.Max(k - 1, 0) / 8; z <= Math.Min(k + 1, bricks.SizeK - 1) / 8; z++)
            {
                for (var y = Math.Max(j - 1, 0) / 8; y <= Math.Min(j + 1, bricks.SizeJ - 1) / 8; y++)
                {
                    for (var x = Math.Max(i - 1, 0) / 8; x <= Math.Min(i + 1, bricks.SizeI - 1) / 8; x++) dirty.Add(bricks.IndexOf(x, y, z));
                }
            }
        }

        static bool Agree(CarvedField field, int i, int j, int k)
        {
            var bricks = field.Bricks;
            var own = field.OpacityCode(i, j, k);
            for (var z = Math.Max(k - 1, 0); z <= Math.Min(k + 1, bricks.SizeK - 1); z++)
            {
                for (var y = Math.Max(j - 1, 0); y <= Math.Min(j + 1, bricks.SizeJ - 1); y++)
                {
                    for (var x = Math.Max(i - 1, 0); x <= Math.Min(i + 1, bricks.SizeI - 1); x++)
                    {
                        if (field.OpacityCode(x, y, z) != own) return false;
                    }
                }
            }

            return true;
        }
    }
}
