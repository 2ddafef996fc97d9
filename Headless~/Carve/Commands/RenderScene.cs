using System;
using System.IO;
using System.Threading;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Commands;

/// <summary>The scene that is rendered: one GameObject with the package's components, on the host.</summary>
internal sealed class RenderScene : IDisposable
{
    private readonly TextWriter warnings;
    private readonly UnityHost host;
    private volatile string firstError;

    /// <param name="warnings">where the engine's and the package's warnings go, a line each</param>
    public RenderScene(TextWriter warnings)
    {
        this.warnings = warnings;
        host = UnityHost.Start(new HostOptions { Log = OnLog });
        var volume = new GameObject("volume");
        Loader = volume.AddComponent<VolumeLoader>();
        Stack = volume.AddComponent<ClipSphereStack>();
        Renderer = volume.AddComponent<CarvedVolumeRenderer>();
    }

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
        foreach (var warning in Loader.Volume.Labels.Warnings) Warn(warning);
    }

    /// <summary>Fails if anything was logged as an error: a picture made in spite of it is not to be trusted.</summary>
    /// <exception cref="CommandException">Something was.</exception>
    public void ThrowIfFailed()
    {
        if (firstError != null) throw new CommandException(firstError);
    }

    public void Dispose() => host.Dispose();

    private void OnLog(LogType type, string message, string stackTrace)
    {
        if (type == LogType.Warning) Warn(message);
        if (type is LogType.Error or LogType.Exception or LogType.Assert) firstError ??= message;
    }

    private void Warn(string warning) => warnings.WriteLine($"carve: warning: {Failure.OneLine(warning)}");
}
