using System.Collections.Generic;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Commands;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>A carved volume and a camera, for pictures whose errors are measured.</summary>
    sealed record ErrorScene(
        string Name, SegmentedVolume Volume, OpacityTransferFunction TransferFunction, IReadOnlyList<ClipSphere> Spheres, PerspectiveCamera Camera)
    {
        /// <summary>The segments as they are shown; the volume's unless set.</summary>
        public SegmentTable Segments { get; init; } = Volume.Segments;

        /// <summary>Shows it, carved, at the default quality.</summary>
        public void Show(BenchStage stage)
        {
            stage.Show(Volume);
            stage.Renderer.TransferFunction = TransferFunction;
            stage.Renderer.Segments = Segments;
            stage.Stack.Carving.Replace(Spheres);
        }

        public PictureRays Rays(int width, int height) => Camera.Rays(new PictureSize(width, height));

        public JsonObject ToJson() => new()
        {
            ["voxels"] = $"{Volume.Geometry.SizeI}x{Volume.Geometry.SizeJ}x{Volume.Geometry.SizeK}",
            ["transferFunction"] = TransferFunction.ToString(),
            ["spheres"] = Spheres.Count,
            ["camera"] = Camera.ToJson(),
        };
    }
}
