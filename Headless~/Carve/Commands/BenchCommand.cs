using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli.Bench;
using AnatomyCarve.Headless.Cli.Files;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve bench: work, errors, and how long things take.</summary>
    static class BenchCommand
    {
        const int MostRuns = 1000;
        const int MostThreads = 64;

        public static Command Create() => new("bench", "Measures work, errors, and time.")
        {
            BenchVolumeCommand.CreateRender(),
            BenchVolumeCommand.CreateEdit(),
            CreateLoad(),
            BenchAllCommand.CreateError(),
            BenchAllCommand.Create(),
            BenchCompareCommand.Create(),
        };

        static Command CreateLoad()
        {
            var source = new BenchSource("load");
            var runs = new Option<int>("--runs") { HelpName = "N", DefaultValueFactory = _ => 7, Description = "How often each way is run; medians are shown." };
            runs.Validators.Add(result => CheckRange(result, runs, 1, MostRuns));
            var threads = new Option<int>("--threads")
            {
                HelpName = "N",
                DefaultValueFactory = _ => 2,
                Description = "The packed volume is loaded on one thread, and on so many.",
            };
            threads.Validators.Add(result => CheckRange(result, threads, 1, MostThreads));
            var report = new Option<string>("--report") { HelpName = "FILE", Description = "Also write all of it as JSON." };
            var noProgress = new Option<bool>("--no-progress") { Description = "No progress bars." };
            var command = new Command("load", "Loads a volume from its files and from a packed volume, by turns: time, memory, bytes.");
            command.Aliases.Add("read");
            source.AddTo(command);
            foreach (var option in new Option[] { runs, threads, report, noProgress }) command.Options.Add(option);
            command.SetAction((parsed, cancellation) =>
            {
                var configuration = parsed.InvocationConfiguration;
                var reportPath = parsed.GetValue(report);
                if (reportPath != null) OutputSet.Check(reportPath);
                var (scan, segmentation) = source.Read(parsed);
                int[] counts = [.. new[] { 1, parsed.GetValue(threads) }.Distinct()];
                var comparison = ProgressBars.Show(configuration.Error, !parsed.GetValue(noProgress), bars => bars.Step("loading",
                    progress => LoadBench.Run(scan, segmentation, parsed.GetValue(runs), counts, progress, cancellation)));
                LoadReport.Write(configuration.Output, comparison);
                if (reportPath != null) WriteReport(reportPath, comparison, scan, segmentation, cancellation);
                return Task.FromResult(0);
            });
            return command;
        }

        static void WriteReport(string path, LoadComparison comparison, NamedContent scan, NamedContent labels, CancellationToken cancellation)
        {
            using var outputs = new OutputSet();
            outputs.Add(path, stream => stream.Write(Encoding.UTF8.GetBytes(Json.Text(LoadReport.ToJson(comparison, scan, labels)) + "\n")));
            cancellation.ThrowIfCancellationRequested();
            outputs.Commit();
        }

        static void CheckRange(OptionResult result, Option<int> option, int least, int most)
        {
            var value = result.GetValue(option);
            if (value < least || value > most)
            {
                result.AddError(string.Create(CultureInfo.InvariantCulture, $"{option.Name} \"{value}\": expected a number from {least} to {most}."));
            }
        }
    }
}
