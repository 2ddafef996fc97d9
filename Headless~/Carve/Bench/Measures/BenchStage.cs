using System;
using AnatomyCarve.Headless.Cli.Commands;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Measures
{
    /// <summary>The engine with one volume's GameObject: what measures of the GPU run on.</summary>
    sealed class BenchStage : IDisposable
    {
        readonly RenderScene scene;

        public BenchStage(RenderProject project, Warnings warnings) => scene = new RenderScene(project, warnings);

        public UnityHost Host => scene.Host;

        public CarvedVolumeRenderer Renderer => scene.Renderer;

        public ClipSphereStack Stack => scene.Stack;

        /// <summary>Shows a volume, uncarved, as a new renderer does.</summary>
        public void Show(SegmentedVolume volume)
        {
            scene.Loader.SetVolume(volume);
            scene.Host.Step();
            scene.Stack.Clear();
            Renderer.Quality = RenderQuality.Balanced();
            Renderer.TransferFunction = null;
            Renderer.Segments = null;
            Renderer.CountSamples = false;
        }

        /// <summary>Fails if anything was logged as an error.</summary>
        public void ThrowIfFailed() => scene.ThrowIfFailed();

        public void Dispose() => scene.Dispose();
    }
}
