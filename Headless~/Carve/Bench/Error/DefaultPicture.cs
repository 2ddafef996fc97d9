using System;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Error.Reference;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>P29: the default picture against the converged one. Of several scenes the worst counts, for each value by itself.</summary>
    sealed class DefaultPicture(int pictureSize) : IMeasure
    {
        public DefaultPicture() : this(SettingError.DefaultPictureSize)
        {
        }

        public Quantity Quantity { get; } = new(
            "P29", "default picture against a converged reference: PSNR, SSIM, first-segment error, depth RMSE", "dB, 1, %, voxels", [40, 0.99, 0.1, 0.05])
        {
            AtLeastEach = [true, true, false, false],
        };

        public Outcome Run(MeasureContext context)
        {
            var error = new SettingError(pictureSize);
            double psnr = double.PositiveInfinity, ssim = 1, segments = 0, depth = 0;
            var settings = new JsonObject
            {
                ["quality"] = "balanced", ["pixels"] = pictureSize * pictureSize, ["referenceStepVoxels"] = ReferenceRenderer.Step,
            };
            foreach (var scene in ErrorScenes.All(context))
            {
                var found = error.Of(context.Stage, RenderQuality.Balanced(), scene, context.Cancellation);
                (psnr, ssim) = (Math.Min(psnr, found.PsnrDecibels), Math.Min(ssim, found.Ssim));
                (segments, depth) = (Math.Max(segments, found.SegmentErrorPercent), Math.Max(depth, found.DepthRmseVoxels));
                settings[scene.Name] = scene.ToJson();
                settings[$"{scene.Name}: errors"] = found.ToJson();
                settings[$"{scene.Name}: errors but for the eight bits of opacities"] =
                    error.OfShown(context.Stage, scene, OpacityPrecision.EightBits, context.Cancellation).ToJson();
            }

            context.Stage.ThrowIfFailed();
            return new Outcome([psnr, ssim, segments, depth], string.Join("; ", ErrorScenes.Names), settings);
        }
    }
}
