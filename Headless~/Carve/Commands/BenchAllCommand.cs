using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Pareto;
using AnatomyCarve.Headless.Cli.Bench.Report;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Headless.Cli.Files;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve bench all and carve bench error: the quantities of the benchmark.</summary>
    static class BenchAllCommand
    {
        const int MostRuns = 100;

        /// <summary>What an invocation asks for.</summary>
        sealed record Request(IReadOnlyList<IMeasure> Measures, SceneFile Scenes, int Runs, string JsonPath, string CsvPath, string Report, string Against, bool ShowProgress);

        /// <summary>Every quantity.</summary>
        public static Command Create() => Create("all", "Measures every quantity: work, errors, and times as ratios of two taken by turns.", _ => true);

        /// <summary>The quantities that are errors.</summary>
        public static Command CreateError() =>
            Create("error", "Measures the quantities that are errors.", measure => measure.GetType().Namespace!.Split('.').Contains("Error"));

        static Command Create(string name, string description, Func<IMeasure, bool> isMeant)
        {
            var only = new Option<string>("--only") { HelpName = "IDS", Description = "Only these measures: P2,P20, for example." };
            var runs = new Option<int>("--runs") { HelpName = "N", DefaultValueFactory = _ => 5, Description = "How often each way of a comparison of times is run; medians count." };
            runs.Validators.Add(result =>
            {
                if (result.GetValue(runs) is < 1 or > MostRuns) result.AddError($"--runs: expected a number from 1 to {MostRuns}.");
            });
            var scenes = new Option<string>("--scenes") { HelpName = "FILE", Description = "Other scenes than the committed ones." };
            var json = new Option<string>("--json") { HelpName = "FILE", Description = "Also write all figures as JSON, keyed by their ids." };
            var csv = new Option<string>("--csv") { HelpName = "FILE", Description = "Also write all figures as CSV." };
            var report = new Option<string>("--report") { HelpName = "FOLDER", Description = "Also write the manual's pages of figures and their plots into this folder, and time the scaling curves." };
            var against = new Option<string>("--against") { HelpName = "FILE", Description = "The figures to compare with: what an earlier --json wrote. The stored ones otherwise." };
            var noProgress = new Option<bool>("--no-progress") { Description = "No progress bars." };
            var command = new Command(name, description) { only, runs, scenes, json, csv, report, against, noProgress };
            command.SetAction((parsed, cancellation) =>
            {
                foreach (var path in new[] { parsed.GetValue(json), parsed.GetValue(csv) }.Where(path => path != null)) OutputSet.Check(path);
                foreach (var path in new[] { parsed.GetValue(scenes), parsed.GetValue(against) }.Where(path => path != null)) InputFile.Check(path);
                var measures = parsed.GetValue(only) is { } ids ? MeasureList.Only(ids.Split(',')) : MeasureList.All.Where(isMeant).ToArray();
                if (measures.Count == 0) throw new CommandException($"this program has no measures for bench {name}.");
                var stored = File.Exists(BenchCompareCommand.StoredPath) ? BenchCompareCommand.StoredPath : null;
                var request = new Request(measures, SceneFile.Read(parsed.GetValue(scenes) ?? SceneFile.DefaultPath), parsed.GetValue(runs), parsed.GetValue(json),
                    parsed.GetValue(csv), parsed.GetValue(report), parsed.GetValue(against) ?? (parsed.GetValue(scenes) == null ? stored : null), !parsed.GetValue(noProgress));
                Run(request, parsed.InvocationConfiguration.Output, parsed.InvocationConfiguration.Error, cancellation);
                return Task.FromResult(0);
            });
            return command;
        }

        static void Run(Request request, TextWriter output, TextWriter error, CancellationToken cancellation)
        {
            var warnings = new Warnings();
            try
            {
                // Read first: the figures may be written over the file that they are compared with.
                var old = request.Against == null ? null : FigureFile.Read(request.Against);
                var (figures, scaling) = ProgressBars.Show(error, request.ShowProgress, bars =>
                {
                    using var stage = bars.Step("starting", _ => new BenchStage(new RenderProject(), warnings));
                    var context = new MeasureContext(stage, null, cancellation) { Scenes = new BenchScenes(request.Scenes), Runs = request.Runs };
                    var found = MeasureRun.Run(request.Measures, context, bars, (figure, time) => output.WriteLine(FigureText.Line(figure, time)));
                    return (found, request.Report == null ? null : bars.Step("scaling", progress => ScalingCurves.Measure(context with { Progress = progress })));
                });
                Write(figures, request.JsonPath, request.CsvPath, cancellation);
                if (old != null) BenchCompareCommand.Write(output, request.Against, Asked(old, figures), figures);
                if (request.Report != null)
                {
                    ReportFolder.Write(request.Report, figures, scaling, old == null ? null : FigureComparison.Compare(Asked(old, figures), figures), warnings);
                }
            }
            finally
            {
                warnings.WriteTo(error);
            }
        }

        // What was not asked for is not lost.
        static IReadOnlyList<Figure> Asked(IReadOnlyList<Figure> old, IReadOnlyList<Figure> now) =>
            old.Where(figure => now.Any(present => present.Quantity.Id == figure.Quantity.Id)).ToArray();

        static void Write(IReadOnlyList<Figure> figures, string jsonPath, string csvPath, CancellationToken cancellation)
        {
            using var outputs = new OutputSet();
            if (jsonPath != null) outputs.Add(jsonPath, stream => stream.Write(Encoding.UTF8.GetBytes(Json.Text(FigureFile.ToJson(figures)) + "\n")));
            if (csvPath != null) outputs.Add(csvPath, stream => stream.Write(Encoding.UTF8.GetBytes(FigureFile.ToCsv(figures))));
            cancellation.ThrowIfCancellationRequested();
            outputs.Commit();
        }
    }
}
