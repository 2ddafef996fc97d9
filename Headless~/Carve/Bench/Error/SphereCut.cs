using System;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P28: the surface that a clip sphere cuts into opaque matter, at the quality "best" (smooth cuts): normals as seen and depth against the sphere itself, where
    /// a ray meets it within 70 degrees of its normal and three voxels or more below the block's face. The main scene has a radius of 20 voxels of 1 mm; other
    /// radii and spacings, and what is seen where a segment that the sphere does not clip stands in the cut, go to the settings.
    /// </summary>
    sealed class SphereCut : IMeasure
    {
        public Quantity Quantity { get; } = new(
            "P28", "a sphere's cut: seen normals, mean and 99th percentile; depth, RMS", "degrees, degrees, voxels", [1.6, 4, 0.1]);

        public Outcome Run(MeasureContext context)
        {
            var stage = context.Stage;
            var main = new CutBlock(20, [1, 1, 1]).Measure(stage, RenderQuality.Best());
            var settings = new JsonObject
            {
                ["quality"] = "best",
                ["radiusVoxels"] = 20,
                ["spacingMm"] = 1,
                ["main"] = main.ToJson(),
                ["radius 8"] = new CutBlock(8, [1, 1, 1]).Measure(stage, RenderQuality.Best()).ToJson(),
                ["radius 43.5"] = new CutBlock(43.5, [1, 1, 1]).Measure(stage, RenderQuality.Best()).ToJson(),
                ["radius 20 mm, 1x1x2 mm"] = new CutBlock(20, [1, 1, 2]).Measure(stage, RenderQuality.Best()).ToJson(),
                ["radius 20 mm, 2x1x1 mm"] = new CutBlock(20, [2, 1, 1]).Measure(stage, RenderQuality.Best()).ToJson(),
                ["binary cut, radius 20"] = new CutBlock(20, [1, 1, 1]).Measure(stage, Binary()).ToJson(),
                ["beside a protected segment"] = new ProtectedWall(20).Measure(stage, RenderQuality.Best()),
            };
            stage.ThrowIfFailed();
            return new Outcome([main.Normals.Mean, main.Normals.Percentile99, main.DepthRmsVoxels], "a sphere at the face of a block", settings);
        }

        static RenderQuality Binary()
        {
            var quality = RenderQuality.Best();
            quality.CutMode = CutMode.Binary;
            return quality;
        }
    }
}
