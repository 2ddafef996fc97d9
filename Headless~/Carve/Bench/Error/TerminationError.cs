using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P12: what ending rays early costs: the largest difference of a linear colour channel between the default's pictures and those of rays that go on.
    /// </summary>
    sealed class TerminationError(int pictureSize) : IMeasure
    {
        const int DefaultPictureSize = 192;

        public TerminationError() : this(DefaultPictureSize)
        {
        }

        public Quantity Quantity { get; } = new("P12", "colour error from early termination", "1", [1.0 / 255]);

        public Outcome Run(MeasureContext context)
        {
            double largest = 0;
            var settings = new JsonObject { ["pixels"] = pictureSize * pictureSize, ["opaqueAlpha"] = RenderQuality.Balanced().OpaqueAlpha };
            foreach (var scene in ErrorScenes.All(context))
            {
                scene.Show(context.Stage);
                var rays = scene.Rays(pictureSize, pictureSize);
                var ended = context.Stage.Renderer.Render(rays).Read().Color;
                context.Stage.Renderer.Quality.OpaqueAlpha = 1;
                var whole = context.Stage.Renderer.Render(rays).Read().Color;
                var difference = ended.Zip(whole, (a, b) => Math.Max(Math.Abs(a.r - b.r), Math.Max(Math.Abs(a.g - b.g), Math.Abs(a.b - b.b)))).Max();
                settings[scene.Name] = scene.ToJson();
                settings[$"{scene.Name}: largest"] = difference;
                context.Cancellation.ThrowIfCancellationRequested();
                largest = Math.Max(largest, difference);
            }

            context.Stage.ThrowIfFailed();
            return new Outcome([largest], string.Join("; ", ErrorScenes.Names), settings);
        }
    }
}
