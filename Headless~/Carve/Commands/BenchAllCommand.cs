using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Headless.Cli.Files;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve bench all: every quantity of the benchmark.</summary>
    static class BenchAllCommand
    {
        public static Command Create()
        {
            var only = new Option<string>("--only") { HelpName = "IDS", Description = "Only these measures: P2,P20, for example." };
            var runs = new Option<int>("--runs") { HelpName = "N", DefaultValueFactory = _ => 5, Description = "How often each way of a comparison of times is run; medians count." };
            runs.Validators.Add(result =>
            {
                if (result.GetValue(runs) is < 1 or > 100) result.AddError("--runs: expected a number from 1 to 100.");
            });
            var scenes = new Option<string>("--scenes") { HelpName = "FILE", Description = "Other scenes than the committed ones." };
            var json = new Option<string>("--json") { HelpName = "FILE", Description = "Also write all figures as JSON, keyed by their ids." };
            var csv = new Option<string>("--csv") { HelpName = "FILE", Description = "Also write all figures as CSV." };
            var report = new Option<string>("--report") { HelpName = "FOLDER", Description = "Also write the manual's page and its plots into this folder." };
            var against = new Option<string>("--against") { HelpName = "FILE", Description = "The figures to compare with; the stored ones otherwise." };
            var noProgress = new Option<bool>("--no-progress") { Description = "No progress bars." };
            var command = new Command("all", "Measures every quantity: counts, errors, and times as ratios of two taken by turns.")
            {
                only, runs, scenes, json, csv, report, against, noProgress,
            };
            command.SetAction((parsed, cancellation) =>
            {
                var (jsonPath, csvPath) = (parsed.GetValue(json), parsed.GetValue(csv));
                foreach (var path in new[] { jsonPath, csvPath }.Where(path => path != null)) OutputSet.Check(path);
                var measures = parsed.GetValue(only) is { } ids ? MeasureList.Only(ids.Split(',')) : MeasureList.All;
                var configuration = parsed.InvocationConfiguration;
                var file = SceneFile.Read(parsed.GetValue(scenes) is { } scenesPath ? Checked(scenesPath) : SceneFile.DefaultPath);
                var figures = Run(
                    measures, file, parsed.GetValue(runs), parsed.GetValue(report), configuration.Output, configuration.Error, !parsed.GetValue(noProgress), cancellation);
                Write(figures, jsonPath, csvPath, cancellation);
                return Task.FromResult(0);
            });
            return command;
        }

        static IReadOnlyList<Figure> Run(IReadOnlyList<IMeasure> measures, SceneFile file, int runs, string report, TextWriter output, TextWriter error, bool showProgress,
            CancellationToken cancellation)
        {
            var warnings = new Warnings();
            try
            {
                return ProgressBars.Show(error, showProgress, bars =>
                {
                    using var stage = bars.Step("starting", _ => new BenchStage(new RenderProject(), warnings));
                    var context = new MeasureContext(stage, null, cancellation) { Scenes = new BenchScenes(file), Runs = runs, ReportFolder = report };
                    return MeasureRun.Run(measures, context, bars, (figure, time) => output.WriteLine(FigureText.Line(figure, time)));
                });
            }
            finally
            {
                warnings.WriteTo(error);
            }
        }

        static void Write(IReadOnlyList<Figure> figures, string jsonPath, string csvPath, CancellationToken cancellation)
        {
            using var outputs = new OutputSet();
            if (jsonPath != null) outputs.Add(jsonPath, stream => stream.Write(Encoding.UTF8.GetBytes(Json.Text(FigureFile.ToJson(figures)) + "\n")));
            if (csvPath != null) outputs.Add(csvPath, stream => stream.Write(Encoding.UTF8.GetBytes(FigureFile.ToCsv(figures))));
            cancellation.ThrowIfCancellationRequested();
            outputs.Commit();
        }

        static string Checked(string path)
        {
            InputFile.Check(path);
            return path;
        }
    }
}
