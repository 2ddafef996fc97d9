using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P13: what a voxel costs on the GPU.</summary>
    sealed class BytesPerVoxel : IMeasure
    {
        const string Scene = "demo-move-40";

        public Quantity Quantity { get; } = new("P13", "bytes resident per voxel, all but pictures: compact, portable", "bytes", [7, 9]);

        public Outcome Run(MeasureContext context)
        {
            var settings = new JsonObject { ["segments"] = context.Scenes.Get(Scene).Volume.Segments.Count };
            double[] values = [Measure(context, TextureLayout.Compact, settings), Measure(context, TextureLayout.Portable, settings)];
            context.Stage.Renderer.Layout = TextureLayout.Automatic;
            return new Outcome(values, Scene, settings);
        }

        static double Measure(MeasureContext context, TextureLayout layout, JsonObject settings)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Renderer.Layout = layout;
            stage.Show(scene);
            stage.Update();
            double voxels = scene.Volume.Geometry.VoxelCount;
            var resources = stage.Renderer.Statistics.Resources.Where(resource => !resource.Name.Contains("picture", StringComparison.Ordinal)).ToArray();
            var list = new JsonObject();
            foreach (var resource in resources) list[resource.Name] = resource.Bytes;
            settings[layout.ToString().ToLowerInvariant()] = list;
            return resources.Sum(resource => resource.Bytes) / voxels;
        }
    }

    /// <summary>P14: what a clip sphere costs on the GPU.</summary>
    sealed class BytesPerSphere : IMeasure
    {
        const string Scene = "demo-crowd";

        public Quantity Quantity { get; } = new("P14", "bytes per clip sphere, with its mask over 76 segments; the goal is 64 bytes and a bit per segment", "bytes", [64 + 76 / 8.0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            long Resident(int spheres)
            {
                stage.Carving.Replace(scene.Spheres.Take(spheres));
                stage.Update();
                return stage.Renderer.Statistics.BytesResident;
            }

            var (few, many) = (scene.Spheres.Count / 2, scene.Spheres.Count);
            var bytes = -Resident(few) + Resident(many);
            return new Outcome([(double)bytes / (many - few)], Scene, new JsonObject { ["spheres"] = new JsonArray(few, many), ["segments"] = scene.Volume.Segments.Count });
        }
    }
}
