using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P5: what random edits leave in the volume's textures against what a full update puts there. A test does so for 10,000 edits.</summary>
    sealed class EditedAgainstFull : IMeasure
    {
        const string Scene = "small-edits";
        const int Edits = 100;
        const int Seed = 7;

        public Quantity Quantity { get; } = new("P5", "bytes in which the textures after edits differ from those of a full update", "bytes", [0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            stage.Carving.HistoryLimit = CarvingStack.DefaultHistoryLimit;
            stage.Update();
            var random = new Random(Seed);
            long differing = 0;
            for (var edit = 0; edit < Edits; edit++)
            {
                context.Cancellation.ThrowIfCancellationRequested();
                Edit(stage.Carving, scene, random);
                stage.Update();
                var edited = stage.ReadTextures();
                FullUpdate.Force(stage);
                stage.Update();
                differing += Differing(edited, stage.ReadTextures());
                context.Progress.Report((edit + 1f) / Edits);
            }

            return new Outcome([differing], Scene, new JsonObject { ["edits"] = Edits, ["seed"] = Seed });
        }

        static void Edit(CarvingStack carving, BenchScene scene, Random random)
        {
            var geometry = scene.Volume.Geometry;
            switch (random.Next(8))
            {
                case 0 when carving.Active != null && carving.Fixed.Count < 12:
                    carving.FixActive();
                    break;
                case 1:
                    carving.RemoveLast();
                    break;
                case 2:
                    carving.ToggleSegment(random.Next(scene.Volume.Segments.Count));
                    break;
                case 3 when carving.CanUndo:
                    carving.Undo();
                    break;
                case 4 when carving.CanRedo:
                    carving.Redo();
                    break;
                case 5:
                    carving.ResetMask();
                    break;
                default:
                    var place = new PointMm(geometry.SizeI * random.NextDouble(), geometry.SizeJ * random.NextDouble(), geometry.SizeK * random.NextDouble());
                    carving.SetActive(geometry.IjkToLps.TransformPoint(place), 5 + 45 * random.NextDouble());
                    break;
            }
        }

        static long Differing(IReadOnlyList<byte[]> a, IReadOnlyList<byte[]> b) => a.Zip(b, Differing).Sum();

        static long Differing(byte[] a, byte[] b)
        {
            if (a.AsSpan().SequenceEqual(b)) return 0;
            return a.Where((value, n) => value != b[n]).LongCount();
        }
    }

    /// <summary>A full update without uploading the volume again.</summary>
    static class FullUpdate
    {
        /// <summary>Has the next update recompute everything: the same transfer function, as another object.</summary>
        public static void Force(BenchStage stage) =>
            stage.Renderer.TransferFunction = new OpacityTransferFunction(stage.Renderer.TransferFunction.Points);
    }
}
