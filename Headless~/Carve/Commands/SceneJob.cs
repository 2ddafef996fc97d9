using System;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Headless.Cli.Files;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>A scene that is played until its volumes are there, and for some frames more.</summary>
    sealed class SceneJob(string scenePath, string outputPath, int frames, RenderProject project)
    {
        readonly Warnings warnings = new();
        EngineLog log;

        public void Run(TextWriter output, TextWriter error, bool showProgress, CancellationToken cancellation)
        {
            log = new EngineLog(warnings);
            OutputSet.Check(outputPath);
            InputFile.Check(scenePath);
            try
            {
                ProgressBars.Show(error, showProgress, bars =>
                {
                    using var host = bars.Step("starting", _ => Start());
                    bars.Step("loading", progress => Load(host, progress, cancellation));
                    bars.Step("playing", progress => Play(host, progress, cancellation));
                    var (rgba, width) = Picture(host);
                    log.ThrowIfFailed();
                    using var outputs = new OutputSet();
                    outputs.Add(outputPath, stream => stream.Write(
                        ImageConversion.EncodeArrayToPNG(rgba, GraphicsFormat.R8G8B8A8_SRGB, (uint)width, (uint)project.Size.Height)));
                    outputs.Commit();
                    return true;
                });
            }
            finally
            {
                warnings.WriteTo(error);
            }

            output.WriteLine(Path.GetFullPath(outputPath));
        }

        UnityHost Start()
        {
            var options = project.HostOptions(log.Note);
            (options.ScreenWidth, options.ScreenHeight) = (project.Size.Width, project.Size.Height);
            return UnityHost.Start(options);
        }

        bool Load(UnityHost host, IProgress<float> progress, CancellationToken cancellation)
        {
            host.LoadScene(Path.GetFullPath(scenePath));
            host.Step();
            var loaders = UnityEngine.Object.FindObjectsByType<VolumeLoader>(FindObjectsSortMode.None);
            while (loaders.Any(loader => loader.IsLoading))
            {
                cancellation.ThrowIfCancellationRequested();
                progress.Report(loaders.Min(loader => loader.Progress));
                host.Step();
                Thread.Sleep(1);
            }

            log.ThrowIfFailed();
            return true;
        }

        bool Play(UnityHost host, IProgress<float> progress, CancellationToken cancellation)
        {
            for (var frame = 0; frame < frames; frame++)
            {
                cancellation.ThrowIfCancellationRequested();
                progress.Report((float)frame / frames);
                host.Step();
            }

            log.ThrowIfFailed();
            return true;
        }

        (byte[] Rgba, int Width) Picture(UnityHost host)
        {
            var width = project.Size.Width;
            if (project.Stereo == HostStereo.Mono) return (host.ReadScreen(), width);
            return (SideBySide.Join([host.ReadEye(0), host.ReadEye(1)], 4 * width), 2 * width);
        }
    }
}
