using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P28: the surface that a clip sphere cuts into opaque matter, at the quality "best" (smooth cuts): normals as seen against the
    /// sphere's own at that place, and depth against the sphere itself, where a ray meets it within 70 degrees of its normal and three voxels or more below the block's face. The main scene has a radius of
    /// 20 voxels of 1 mm; other radii and spacings, and what is seen where a segment that the sphere does not clip stands in the cut, go to the settings.
    /// </summary>
    sealed class SphereCut(int pictureSize) : IMeasure
    {
        const int DefaultPictureSize = 128;

        public SphereCut() : this(DefaultPictureSize)
        {
        }

        public Quantity Quantity { get; } = new(
            "P28", "a sphere's cut: seen normals, mean and 99th percentile; depth, RMS", "degrees, degrees, voxels", [1.6, 4, 0.1]);

        public Outcome Run(MeasureContext context)
        {
            CutErrors Cut(double radiusMm, double[] spacingMm, CutMode cut = CutMode.Smooth)
            {
                context.Cancellation.ThrowIfCancellationRequested();
                var quality = RenderQuality.Best();
                quality.CutMode = cut;
                return new CutBlock(radiusMm, spacingMm).Measure(context.Stage, quality, pictureSize);
            }

            var main = Cut(20, [1, 1, 1]);
            var settings = new JsonObject
            {
                ["quality"] = "best",
                ["pixels"] = pictureSize * pictureSize,
                ["radiusVoxels"] = 20,
                ["spacingMm"] = 1,
                ["main"] = main.ToJson(),
                ["radius 8"] = Cut(8, [1, 1, 1]).ToJson(),
                ["radius 43.5"] = Cut(43.5, [1, 1, 1]).ToJson(),
                ["radius 20 mm, 1x1x2 mm"] = Cut(20, [1, 1, 2]).ToJson(),
                ["radius 20 mm, 2x1x1 mm"] = Cut(20, [2, 1, 1]).ToJson(),
                ["binary cut, radius 20"] = Cut(20, [1, 1, 1], CutMode.Binary).ToJson(),
                ["beside a protected segment"] = new ProtectedWall(20).Measure(context.Stage, RenderQuality.Best(), pictureSize),
            };
            context.Stage.ThrowIfFailed();
            return new Outcome([main.Normals.Mean, main.Normals.Percentile99, main.DepthRmsVoxels], "a sphere at the face of a block", settings);
        }
    }
}
