using System;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Headless.Cli.Bench.Work;

namespace AnatomyCarve.Headless.Cli.Bench.Pareto
{
    /// <summary>What a setting's picture is compared with: the rays' sum on the same opacities with the shortest step, nothing skipped, no ray ended early.</summary>
    static class ConvergedPicture
    {
        public static readonly string Description = FormattableString.Invariant(
            $"the same kernels at a step of {RenderQuality.MinStep} reference lengths, exact filter, nothing skipped, no ray ended early");

        public static PictureData Of(BenchStage stage, BenchScene scene, CutMode cut, int side)
        {
            stage.Renderer.Layout = TextureLayout.Compact;
            stage.Show(scene);
            var quality = new RenderQuality { Step = RenderQuality.MinStep, OpaqueAlpha = 1, Filter = OpacityFilter.Exact, CutMode = cut };
            quality.SkipEmptySpace = false;
            stage.Renderer.Quality = quality;
            return stage.Render(scene.Rays(side, side)).Read();
        }

        /// <summary>Root mean square of the colours' difference in sRGB, over black, in codes of 255 that are not rounded.</summary>
        public static double RmseCodes(PictureData a, PictureData b)
        {
            double sum = 0;
            for (var pixel = 0; pixel < a.Color.Length; pixel++)
            {
                sum += Square(Srgb(a.Color[pixel].r) - Srgb(b.Color[pixel].r)) + Square(Srgb(a.Color[pixel].g) - Srgb(b.Color[pixel].g))
                    + Square(Srgb(a.Color[pixel].b) - Srgb(b.Color[pixel].b));
            }

            return 255 * Math.Sqrt(sum / (3.0 * a.Color.Length));
        }

        static double Srgb(double linear)
        {
            linear = Math.Clamp(linear, 0, 1);
            return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.Pow(linear, 1 / 2.4) - 0.055;
        }

        static double Square(double value) => value * value;
    }
}
