using System;
using System.IO;
using System.Threading;
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

        /// <summary>Reads the files while the host's frames go on.</summary>
        public void Load(string volumePath, string labelsPath, IProgress<float> progress, CancellationToken cancellation)
        {
            var load = Loader.LoadAsync(Path.GetFullPath(volumePath), labelsPath == null ? null : Path.GetFullPath(labelsPath), cancellation, progress);
            while (!load.IsCompleted)
            {
                host.Step();
                Thread.Sleep(1);
            }

            load.GetAwaiter().GetResult();
        }

        /// <summary>Fails if anything was logged as an error: a picture made in spite of it is not to be trusted.</summary>
        /// <exception cref="CommandException">Something was.</exception>
        public void ThrowIfFailed() => log.ThrowIfFailed();

        public void Dispose() => host.Dispose();
    }
}
