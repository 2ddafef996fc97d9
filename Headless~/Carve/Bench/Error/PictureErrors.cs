using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Error.Reference;
using AnatomyCarve.Metrics;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>How far a picture is from a reference.</summary>
    /// <param name="RmseCodes">of sRGB colours over black, in codes of 0 to 255, not rounded to them</param>
    /// <param name="PsnrDecibels">the same as a peak signal-to-noise ratio</param>
    /// <param name="Ssim">structural similarity of the grey pictures</param>
    /// <param name="SegmentErrorPercent">pixels of another first visible segment, of those where either picture has one</param>
    /// <param name="DepthRmseVoxels">over the pixels where both have a depth, in reference lengths</param>
    /// <param name="Depths">the differences of depth behind it, the largest first</param>
    sealed record PictureErrors(double RmseCodes, double PsnrDecibels, double Ssim, double SegmentErrorPercent, double DepthRmseVoxels, double[] Depths)
    {
        const double Peak = 255;
        const int Outliers = 3; // shown one by one: rays at outlines that meet another surface are few and far off

        public static PictureErrors Between(PictureData found, ReferencePicture reference, double referenceLengthMm)
        {
            var a = Encoded([.. found.Color.Select(color => new Rgba(color.r, color.g, color.b, color.a))]);
            var b = Encoded(reference.Colors);
            var rmse = Math.Sqrt(a.Zip(b, (x, y) => (x - y) * (x - y)).Average());
            var depth = PictureMetrics.DepthRmse(found.DepthMm, [.. reference.DepthsMm.Select(mm => (float)mm)]);
            return new PictureErrors(
                rmse, 20 * Math.Log10(Peak / rmse), StructuralSimilarity.Of(Grey(a), Grey(b), reference.Width, Peak),
                100 * PictureMetrics.FirstSegmentMae(found.Segments, reference.Segments).Mae, depth.RmseMm / referenceLengthMm,
                [.. found.DepthMm.Zip(reference.DepthsMm, (x, y) => Math.Abs(x - y) / referenceLengthMm).Where(double.IsFinite).OrderDescending()]);
        }

        public JsonObject ToJson() => new()
        {
            ["rmseCodes"] = RmseCodes,
            ["psnrDecibels"] = PsnrDecibels,
            ["ssim"] = Ssim,
            ["segmentErrorPercent"] = SegmentErrorPercent,
            ["depthRmseVoxels"] = DepthRmseVoxels,
            ["depths"] = Depths.Length,
            ["largestDepthsVoxels"] = new JsonArray([.. Depths.Take(Outliers).Select(depth => (JsonNode)Json.Number(depth))]),
            ["depthRmseVoxelsWithoutThem"] = Json.Number(Math.Sqrt(Depths.Skip(Outliers).Select(depth => depth * depth).DefaultIfEmpty().Average())),
        };

        static double[] Encoded(Rgba[] colors) =>
            [.. colors.SelectMany(color => new[] { color.R, color.G, color.B }).Select(c => Peak * SrgbCurve.ToEncoded(c))];

        /// <summary>Luma, Rec. 601.</summary>
        static double[] Grey(double[] rgb) =>
            [.. Enumerable.Range(0, rgb.Length / 3).Select(n => 0.299 * rgb[3 * n] + 0.587 * rgb[3 * n + 1] + 0.114 * rgb[3 * n + 2])];
    }
}
