using System;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// P30: whether the pointer finds what the picture shows, on 100,000 rays and more: how often they name another segment though no edge of one lies within a
    /// thousandth of a voxel (alpha: a ten-thousandth), and, with the GPU's texture filter, whose weights have 8 bits, within 1/64.
    /// </summary>
    sealed class PointerAgreement(int pictureSize) : IMeasure
    {
        const int DefaultPictureSize = 224; // two scenes: 100,352 rays
        const double ExactHairVoxels = 1e-3, ExactHairAlpha = 1e-4, HardwareHair = 1.0 / 64;

        public PointerAgreement() : this(DefaultPictureSize)
        {
        }

        public Quantity Quantity { get; } = new(
            "P30", "pointer against the picture's first visible segment, with the filter that the presets balanced and best have", "rays that disagree", [0]);

        public Outcome Run(MeasureContext context)
        {
            var exact = 0;
            var settings = new JsonObject { ["rays"] = pictureSize * pictureSize * ErrorScenes.Names.Length };
            foreach (var scene in ErrorScenes.All(context))
            {
                scene.Show(context.Stage);
                settings[scene.Name] = scene.ToJson();
                var found = Tally(context, scene, OpacityFilter.Exact, ExactHairVoxels, ExactHairAlpha);
                exact += found.Disagreements;
                settings[$"{scene.Name}: exact filter"] = found.ToJson();
                found = Tally(context, scene, OpacityFilter.Hardware, HardwareHair, HardwareHair);
                settings[$"{scene.Name}: the GPU's filter"] = found.ToJson();
            }

            context.Stage.ThrowIfFailed();
            return new Outcome([exact], string.Join("; ", ErrorScenes.Names), settings);
        }

        PointerTally Tally(MeasureContext context, ErrorScene scene, OpacityFilter filter, double hairVoxels, double hairAlpha)
        {
            var renderer = context.Stage.Renderer;
            renderer.Quality.Filter = filter;
            var rays = scene.Rays(pictureSize, pictureSize);
            var tally = new PointerTally(renderer.Field, renderer.RaySettings, hairVoxels, hairAlpha);
            tally.Compare(renderer.Render(rays).Read(), rays);
            context.Cancellation.ThrowIfCancellationRequested();
            return tally;
        }
    }
}
