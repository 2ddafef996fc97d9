using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Headless.Cli.Files;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>One rendering, from files to files, through the package's components.</summary>
    static class RenderJob
    {
        public static void Run(RenderRequest request, TextWriter output, TextWriter error, bool showProgress, CancellationToken cancellation)
        {
            foreach (var path in request.OutputPaths) OutputSet.Check(path);
            foreach (var path in request.InputPaths) InputFile.Check(path);

            // What can be refused at once is read first: starting the engine and reading volumes takes seconds.
            var orbit = File.Exists(request.CameraText) ? null : OrbitText.Read(request.CameraText).Camera;
            var exactCamera = orbit == null ? CameraFile.Read(request.CameraText) : null;
            var transferFunction = ReadTransferFunction(request.TransferFunctionText);

            var times = new StepTimes();
            var warnings = new Warnings();
            try
            {
                ProgressBars.Show(error, showProgress, bars =>
                {
                    using var scene = bars.Step("starting", _ => times.Measure("start", () => new RenderScene(request.Project, warnings)));
                    bars.Step("reading", progress => times.Measure("read", () => scene.Load(request, progress, cancellation)));
                    var camera = exactCamera ?? PerspectiveCamera.Around(scene.Loader.Volume.Geometry, orbit, request.Size);
                    Render(request, scene, camera, transferFunction, warnings, bars, times, cancellation);
                    return true;
                });
            }
            finally
            {
                warnings.WriteTo(error);
            }

            output.WriteLine(Path.GetFullPath(request.OutputPath));
        }

        static void Render(RenderRequest request, RenderScene scene, PerspectiveCamera camera, OpacityTransferFunction transferFunction,
            Warnings warnings, ProgressBars bars, StepTimes times, CancellationToken cancellation)
        {
            scene.Renderer.Quality = RenderQuality.Named(request.QualityName);
            if (request.Cut is { } cut) scene.Renderer.Quality.CutMode = cut;
            if (request.AntiAliasing is { } antiAliasing) scene.Renderer.Quality.AntiAliasing = antiAliasing;
            scene.Renderer.TransferFunction = transferFunction;
            scene.Renderer.CountSamples = request.ReportPath != null;
            if (request.CarvingPath != null) scene.Stack.Load(Path.GetFullPath(request.CarvingPath));

            var (picture, samples) = bars.Step("rendering", _ => times.Measure("render", () =>
            {
                var rendered = scene.Renderer.Render(camera.Rays(request.Size));
                scene.ThrowIfFailed();
                if (rendered == null) throw new CommandException("there was nothing to render.");
                return (rendered.Read(), rendered.ReadSampleCount());
            }));
            DrawnView.Picture? drawn = request.IsDrawn
                ? bars.Step("drawing", _ => times.Measure("draw", () => DrawnView.Draw(scene, request, camera)))
                : null;
            scene.ThrowIfFailed();
            cancellation.ThrowIfCancellationRequested();

            using var outputs = new OutputSet();
            bars.Step("writing", _ => times.Measure("write", () => AddPictures(outputs, request, picture)));
            if (drawn is { } view) AddDrawn(outputs, request, view);
            if (request.ReportPath != null)
            {
                var report = Json.Text(RenderReport.Make(request, scene, camera, picture, samples, warnings.Lines, times.Milliseconds)) + "\n";
                outputs.Add(request.ReportPath, stream => stream.Write(Encoding.UTF8.GetBytes(report)));
            }

            cancellation.ThrowIfCancellationRequested();
            outputs.Commit();
        }

        static OpacityTransferFunction ReadTransferFunction(string text)
        {
            if (text == null) return null;
            if (File.Exists(text)) return TransferFunctionFile.Read(text);
            if (Directory.Exists(text)) throw new CommandException($"--tf \"{text}\": this is a folder, not a file to read.");
            if (TransferFunctionPresets.Names.FirstOrDefault(name => name.Equals(text, StringComparison.OrdinalIgnoreCase)) is { } preset)
            {
                return TransferFunctionPresets.Named(preset);
            }

            if (!text.Contains(':'))
            {
                throw new CommandException($"--tf \"{text}\": neither a file, nor value:opacity,value:opacity,..., nor one of the presets "
                    + $"{string.Join(", ", TransferFunctionPresets.Names)}.");
            }

            try
            {
                return OpacityTransferFunction.Parse(text);
            }
            catch (AnatomyCarveException exception)
            {
                throw new CommandException($"--tf: {exception.Message}");
            }
        }

        static void AddPictures(OutputSet outputs, RenderRequest request, PictureData picture)
        {
            var behind = new Color32(request.Background.R, request.Background.G, request.Background.B, 255);
            outputs.Add(request.OutputPath, stream => stream.Write(picture.EncodeToPng(behind)));
            if (request.DepthPath != null)
            {
                outputs.Add(request.DepthPath,
                    stream => PfmFile.Write(stream, picture.Width, picture.Height, FromTop(picture.DepthMm, picture.Width, picture.Height)));
            }

            if (request.SegmentsPath != null)
            {
                outputs.Add(request.SegmentsPath,
                    stream => PgmFile.Write(stream, picture.Width, picture.Height, FromTop(picture.Segments, picture.Width, picture.Height)));
            }
        }

        static void AddDrawn(OutputSet outputs, RenderRequest request, DrawnView.Picture drawn)
        {
            var (width, height) = (drawn.Width, drawn.Height);
            if (request.DrawnPath != null)
            {
                outputs.Add(request.DrawnPath, stream =>
                    stream.Write(ImageConversion.EncodeArrayToPNG(drawn.Rgba, GraphicsFormat.R8G8B8A8_SRGB, (uint)width, (uint)height)));
            }

            if (request.DrawnDepthPath != null)
            {
                outputs.Add(request.DrawnDepthPath, stream => PfmFile.Write(stream, width, height, FromTop(drawn.DepthMm, width, height)));
            }
        }

        // The package's pictures begin with the bottom row, as Unity's textures do.
        static T[] FromTop<T>(T[] fromBottom, int width, int height)
        {
            var fromTop = new T[fromBottom.Length];
            for (var row = 0; row < height; row++)
            {
                Array.Copy(fromBottom, row * width, fromTop, (height - 1 - row) * width, width);
            }

            return fromTop;
        }
    }
}
