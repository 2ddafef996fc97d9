using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Headless.Cli.Bench;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Files;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve bench render and carve bench edit: any volume, or a phantom of any size.</summary>
    static class BenchVolumeCommand
    {
        const int MostRuns = 1000;

        public static Command CreateRender() => Create(
            "render", "Renders pictures by each preset: times, rays, samples, look-ups.", VolumeBench.RenderTitles,
            (context, volume, function, size) => VolumeBench.Render(context, volume, function, size.Width, size.Height));

        public static Command CreateEdit() => Create(
            "edit", "Moves clip spheres and updates everything: times, bricks, voxels, tests.", VolumeBench.EditTitles,
            (context, volume, function, _) => VolumeBench.Edit(context, volume, function));

        static Command Create(string name, string description, string[] titles,
            Func<MeasureContext, SegmentedVolume, OpacityTransferFunction, PictureSize, IReadOnlyList<string[]>> measure)
        {
            var source = new BenchSource(name);
            var function = new Option<string>("--tf") { HelpName = "POINTS", Description = "The transfer function: value:opacity,value:opacity,..." };
            var side = new Option<int>("--size") { HelpName = "N", DefaultValueFactory = _ => 512, Description = "The picture's width and height in pixels." };
            side.Validators.Add(result =>
            {
                if (result.GetValue(side) is < 1 or > 4096) result.AddError("--size: expected a number from 1 to 4096.");
            });
            var runs = new Option<int>("--runs") { HelpName = "N", DefaultValueFactory = _ => 5, Description = "How often each is run; medians are shown." };
            runs.Validators.Add(result =>
            {
                if (result.GetValue(runs) is < 1 or > MostRuns) result.AddError($"--runs: expected a number from 1 to {MostRuns}.");
            });
            var csv = new Option<string>("--csv") { HelpName = "FILE", Description = "Also write the table as CSV." };
            var noProgress = new Option<bool>("--no-progress") { Description = "No progress bars." };
            var command = new Command(name, description) { function, runs, csv, noProgress };
            source.AddTo(command);
            if (name == "render") command.Options.Add(side);
            command.SetAction((parsed, cancellation) =>
            {
                var configuration = parsed.InvocationConfiguration;
                var csvPath = parsed.GetValue(csv);
                if (csvPath != null) OutputSet.Check(csvPath);
                var points = parsed.GetValue(function) is { } text ? OpacityTransferFunction.Parse(text) : null;
                var (scan, labels) = source.Read(parsed);
                var pixels = name == "render" ? parsed.GetValue(side) : 1;
                var warnings = new Warnings();
                SegmentedVolume volume = null;
                var rows = ProgressBars.Show(configuration.Error, !parsed.GetValue(noProgress), bars =>
                {
                    using var stage = bars.Step("starting", _ => new BenchStage(new RenderProject(), warnings));
                    volume = bars.Step("reading", progress => SegmentedVolumeReader.Read(
                        VolumeSource.OfContent(scan.Bytes, scan.Name), labels == null ? null : VolumeSource.OfContent(labels.Bytes, labels.Name), cancellation, progress));
                    return bars.Step(name, progress =>
                        measure(new MeasureContext(stage, progress, cancellation) { Runs = parsed.GetValue(runs) }, volume, points, new PictureSize(pixels, pixels)));
                });
                warnings.WriteTo(configuration.Error);
                var geometry = volume.Geometry;
                configuration.Output.WriteLine(
                    FormattableString.Invariant($"{geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK} voxels, {volume.Segments.Count} segments; median of {parsed.GetValue(runs)} runs"));
                Terminal.WriteTable(configuration.Output, titles, rows.ToArray());
                if (csvPath != null) WriteCsv(csvPath, titles, rows, cancellation);
                return Task.FromResult(0);
            });
            return command;
        }

        static void WriteCsv(string path, string[] titles, IReadOnlyList<string[]> rows, CancellationToken cancellation)
        {
            using var outputs = new OutputSet();
            outputs.Add(path, stream => stream.Write(Encoding.UTF8.GetBytes(string.Join('\n', rows.Prepend(titles).Select(row => string.Join(',', row))) + "\n")));
            cancellation.ThrowIfCancellationRequested();
            outputs.Commit();
        }
    }
}
