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
            double psnr = double.NaN, ssim = double.NaN, segments = double.NaN, depth = double.NaN;
            var settings = new JsonObject
            {
                ["quality"] = "balanced", ["pixels"] = pictureSize * pictureSize, ["referenceStepVoxels"] = ReferenceRenderer.Step,
            };
            foreach (var scene in ErrorScenes.All(context))
            {
                var found = error.Of(context.Stage, RenderQuality.Balanced(), scene, context.Cancellation);
                if (scene.Name == ErrorScenes.DemoHead)
                {
                    // The other is in the settings: there the eight bits of opacities decide, 0.015 of opacity being four of their steps.
                    (psnr, ssim) = (found.PsnrDecibels, found.Ssim);
                    (segments, depth) = (found.SegmentErrorPercent, found.DepthRmseVoxels);
                }

                settings[scene.Name] = scene.ToJson();
                settings[$"{scene.Name}: errors"] = found.ToJson();
                settings[$"{scene.Name}: errors but for the eight bits of opacities"] =
                    error.OfShown(context.Stage, scene, OpacityPrecision.EightBits, context.Cancellation).ToJson();
            }

            context.Stage.ThrowIfFailed();
            return new Outcome([psnr, ssim, segments, depth], ErrorScenes.DemoHead, settings);
        }
    }
}
