using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>The work that one edit caused.</summary>
    /// <param name="ClipVoxels">Eq. 1 and transfer function</param>
    /// <param name="AntiAlias">anti-aliasing</param>
    /// <param name="SobelNormals">normals</param>
    /// <param name="SkipCells">the skip structure</param>
    /// <param name="ClearBricks">bricks that were emptied</param>
    /// <param name="SpheresInBricks">spheres that bricks were given, one by one</param>
    /// <param name="SphereBrickTests">tests of spheres against bricks on the CPU</param>
    readonly record struct EditWork(
        StageStatistics ClipVoxels, StageStatistics AntiAlias, StageStatistics SobelNormals, StageStatistics SkipCells, StageStatistics ClearBricks,
        long SpheresInBricks, long SphereBrickTests)
    {
        /// <summary>Voxels of the stage that processed most.</summary>
        public long MostVoxels => new[] { ClipVoxels.Elements, AntiAlias.Elements, SobelNormals.Elements, ClearBricks.Elements }.Max();

        /// <summary>All tests of spheres: against bricks on the CPU, and of those given to bricks against each of their voxels.</summary>
        public long SphereTests => BrickGrid.VoxelsPerBrick * SpheresInBricks + SphereBrickTests;

        /// <summary>All voxels and cells that kernels worked on.</summary>
        public long Invocations =>
            ClipVoxels.Elements + AntiAlias.Elements + SobelNormals.Elements + ClearBricks.Elements + SkipCells.Elements;

        public JsonObject ToJson() => new()
        {
            ["clipVoxels"] = Stage(ClipVoxels), ["antiAlias"] = Stage(AntiAlias), ["sobelNormals"] = Stage(SobelNormals), ["skipCells"] = Stage(SkipCells),
            ["clearBricks"] = Stage(ClearBricks), ["spheresInBricks"] = SpheresInBricks, ["sphereBrickTests"] = SphereBrickTests,
        };

        static JsonObject Stage(StageStatistics stage) => new() { ["dispatches"] = stage.Dispatches, ["bricks"] = stage.Bricks, ["elements"] = stage.Elements };
    }

    /// <summary>What measures of work do with a scene.</summary>
    static class SceneRun
    {
        /// <summary>Shows a scene, brings it up to date, makes an edit and counts what bringing it up to date again takes.</summary>
        public static EditWork Edit(BenchStage stage, BenchScene scene, Action<CarvingStack> edit)
        {
            stage.Show(scene);
            stage.Update();
            stage.Renderer.Statistics.Reset();
            edit(stage.Carving);
            stage.Update();
            return Work(stage);
        }

        /// <summary>The same for the scene's own move.</summary>
        public static EditWork Move(BenchStage stage, BenchScene scene) => Edit(stage, scene, carving => MoveActive(carving, scene, 1));

        /// <summary>Counts what computing everything anew takes, of the scene that is shown.</summary>
        public static EditWork Full(BenchStage stage)
        {
            stage.Renderer.Statistics.Reset();
            FullUpdate.Force(stage);
            stage.Update();
            return Work(stage);
        }

        /// <summary>Puts the active sphere so many moves from where it stands in the scene.</summary>
        public static void MoveActive(CarvingStack carving, BenchScene scene, double moves)
        {
            var active = scene.Spheres[^1];
            carving.SetActive(active.CentreLps + moves * scene.Move, active.RadiusMm);
        }

        public static EditWork Work(BenchStage stage)
        {
            var statistics = stage.Renderer.Statistics;
            return new EditWork(
                statistics.ClipVoxels, statistics.AntiAlias, statistics.SobelNormals, statistics.SkipCells, statistics.ClearBricks,
                statistics.SpheresInBricks, statistics.SphereBrickTests);
        }

        /// <summary>What a scene's move processes, in percent of the volume, in the stage that processes most.</summary>
        public static double MovedPercent(MeasureContext context, string name, JsonObject settings)
        {
            var scene = context.Scenes.Get(name);
            var work = Move(context.Stage, scene);
            settings[name] = work.ToJson();
            return 100.0 * work.MostVoxels / scene.Volume.Geometry.VoxelCount;
        }

        /// <summary>Those of some scenes whose volumes are on this machine.</summary>
        public static string[] Present(MeasureContext context, params string[] names) => names.Where(context.Scenes.IsPresent).ToArray();
    }
}
