using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli.Bench;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Files;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve bench compare: what got worse between two runs.</summary>
    static class BenchCompareCommand
    {
        public static Command Create()
        {
            var now = new Argument<string>("FIGURES") { Description = "What bench all --json wrote." };
            var old = new Argument<string>("OLD") { Description = "The older figures; the stored ones otherwise.", Arity = ArgumentArity.ZeroOrOne };
            var command = new Command("compare", "Says what got worse between two runs of bench all; ends with 1 if something did.") { now, old };
            command.SetAction((parsed, _) =>
            {
                var (nowPath, oldPath) = (parsed.GetValue(now), parsed.GetValue(old) ?? StoredPath);
                foreach (var path in new[] { nowPath, oldPath }) InputFile.Check(path);
                var worse = Write(parsed.InvocationConfiguration.Output, oldPath, FigureFile.Read(oldPath), FigureFile.Read(nowPath));
                return Task.FromResult(worse ? Failure.BadInput : 0);
            });
            return command;
        }

        /// <summary>The figures that are committed.</summary>
        public static string StoredPath => BenchFiles.Find("last-figures.json");

        /// <returns>Whether something got worse.</returns>
        public static bool Write(TextWriter output, string oldPath, IReadOnlyList<Figure> old, IReadOnlyList<Figure> now)
        {
            var changes = FigureComparison.Compare(old, now);
            foreach (var line in FigureComparison.Lines(changes)) output.WriteLine(line);
            var worse = changes.Count(change => change.Trend is FigureTrend.Worse or FigureTrend.Lost);
            output.WriteLine($"{worse} of {changes.Count} figures got worse against {oldPath}");
            return worse > 0;
        }
    }
}
