using System.Collections.Generic;
using System.Threading;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Error.Reference;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// The error of any quality against the converged reference of the same cut mode, anti-aliased. A scene's reference picture is made once and kept as
    /// long as this object.
    /// </summary>
    sealed class SettingError(int pictureSize)
    {
        public const int DefaultPictureSize = 192;

        readonly Dictionary<(string Scene, CutMode Cut, OpacityPrecision Precision), ReferencePicture> references = [];

        public SettingError() : this(DefaultPictureSize)
        {
        }

        public int PictureSize => pictureSize;

        /// <summary>Shows a scene at a quality and compares it. The stage is left with that scene.</summary>
        public PictureErrors Of(BenchStage stage, RenderQuality quality, ErrorScene scene, CancellationToken cancellation = default)
        {
            scene.Show(stage);
            stage.Renderer.Quality = quality;
            return OfShown(stage, scene, OpacityPrecision.Exact, cancellation);
        }

        /// <summary>Compares what is shown now with a reference of opacities in the given precision, to tell what the storage costs from the rest.</summary>
        public PictureErrors OfShown(BenchStage stage, ErrorScene scene, OpacityPrecision precision, CancellationToken cancellation = default)
        {
            var found = stage.Renderer.Render(scene.Rays(pictureSize, pictureSize)).Read();
            var reference = Reference(stage, scene, precision, cancellation);
            return PictureErrors.Between(found, reference, scene.Volume.Geometry.ReferenceLengthMm);
        }

        ReferencePicture Reference(BenchStage stage, ErrorScene scene, OpacityPrecision precision, CancellationToken cancellation)
        {
            var cut = stage.Renderer.Quality.CutMode;
            if (!references.TryGetValue((scene.Name, cut, precision), out var picture))
            {
                var field = new ReferenceField(scene.Volume, scene.TransferFunction, scene.Segments, scene.Spheres, cut, precision);
                picture = new ReferenceRenderer(field, stage.Renderer.Light).Render(scene.Rays(pictureSize, pictureSize), cancellation);
                references.Add((scene.Name, cut, precision), picture);
            }

            return picture;
        }
    }
}
