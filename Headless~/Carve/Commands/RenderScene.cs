using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli.Bench;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>The scene that is rendered: one GameObject with the package's components, on the host.</summary>
    sealed class RenderScene : IDisposable
    {
        readonly EngineLog log;
        readonly UnityHost host;

        /// <param name="project">the project that it is in</param>
        /// <param name="warnings">where the engine's and the package's warnings go</param>
        public RenderScene(RenderProject project, Warnings warnings)
        {
            log = new EngineLog(warnings);
            host = UnityHost.Start(project.HostOptions(log.Note));
            var volume = new GameObject("volume");
            Loader = volume.AddComponent<VolumeLoader>();
            Stack = volume.AddComponent<ClipSphereStack>();
            Renderer = volume.AddComponent<CarvedVolumeRenderer>();
            Renderer.Layout = project.Layout;
        }

        public UnityHost Host => host;

        public VolumeLoader Loader { get; }

        public ClipSphereStack Stack { get; }

        public CarvedVolumeRenderer Renderer { get; }

        /// <summary>What the volume was said to take, before it was loaded.</summary>
        public MemoryForecast Forecast { get; private set; }

        /// <summary>Reads the volume while the host's frames go on.</summary>
        public void Load(RenderRequest request, IProgress<float> progress, CancellationToken cancellation)
        {
            Loader.Memory.BudgetMiB = request.BudgetMiB;
            Loader.Forecast += forecast => Forecast = forecast;
            var load = request.Phantom is { } phantom ? LoadAsync(phantom, progress, cancellation) : Loader.LoadAsync(
                Path.GetFullPath(request.VolumePath), request.LabelsPath == null ? null : Path.GetFullPath(request.LabelsPath), cancellation, progress);
            while (!load.IsCompleted)
            {
                host.Step();
                Thread.Sleep(1);
            }

            load.GetAwaiter().GetResult();
        }

        Task<SegmentedVolume> LoadAsync(PhantomSize phantom, IProgress<float> progress, CancellationToken cancellation)
        {
            var (scan, labels) = phantom.Make();
            return Loader.LoadAsync(scan.Bytes, labels.Bytes, "phantom", cancellation, progress);
        }

        /// <summary>Fails if anything was logged as an error: a picture made in spite of it is not to be trusted.</summary>
        /// <exception cref="CommandException">Something was.</exception>
        public void ThrowIfFailed() => log.ThrowIfFailed();

        public void Dispose() => host.Dispose();
    }
}
