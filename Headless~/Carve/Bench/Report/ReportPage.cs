using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Report
{
    /// <summary>The generated part of the manual's page of figures, as Markdown.</summary>
    static class ReportPage
    {
        public static string Text(IReadOnlyList<Figure> figures, JsonArray points, bool haveParetoPlot, bool haveScalingPlot, IReadOnlyList<FigureChange> changes)
        {
            var text = new StringBuilder();
            text.AppendLine(string.Create(CultureInfo.InvariantCulture,
                $"Measured on {Environment.ProcessorCount} cores ({RuntimeInformation.ProcessArchitecture}), {RuntimeInformation.FrameworkDescription}.\n"));
            var measured = figures.Where(figure => figure.Outcome.Values != null).ToArray();
            text.AppendLine($"{measured.Count(figure => figure.Holds == true)} of {measured.Length} measured goals hold; {figures.Count - measured.Length} are not measured.\n");
            text.AppendLine("## Figures\n\n| id | quantity | value | goal | unit | holds | scene |\n| --- | --- | --- | --- | --- | --- | --- |");
            foreach (var figure in figures) text.AppendLine(Row(figure));
            Times(text, figures);
            if (points != null) Settings(text, points, haveParetoPlot);
            if (haveScalingPlot)
            {
                text.AppendLine("\n## Scaling\n\n![Times against the volume's side, the number of spheres, and the picture's side](images/benchmarks-scaling.svg)\n");
                text.AppendLine("The bands are least and most; the numbers: [benchmarks-scaling.csv](images/benchmarks-scaling.csv).");
            }

            if (changes != null)
            {
                text.AppendLine("\n## Against the figures stored before\n");
                var lines = FigureComparison.Lines(changes).ToArray();
                text.AppendLine(lines.Length == 0 ? "Nothing changed." : "```\n" + string.Join('\n', lines) + "\n```");
            }

            return text.ToString().Replace("\r\n", "\n");
        }

        static string Row(Figure figure)
        {
            var (quantity, outcome) = figure;
            var value = outcome.Values == null ? "-" : FigureText.Values(outcome.Values);
            var holds = figure.Holds == null ? "-" : figure.Holds == true ? "yes" : "**no**";
            return $"| {quantity.Id} | {quantity.What}{(outcome.Reason == null ? "" : $". Not measured: {outcome.Reason}")} | {value} | {FigureText.Goal(quantity)} | {quantity.Unit} "
                + $"| {holds} | {outcome.Scene} |";
        }

        static void Times(StringBuilder text, IReadOnlyList<Figure> figures)
        {
            text.AppendLine("\n## Times behind the ratios\n\nMilliseconds on this machine; they mean nothing but in their ratios.\n");
            text.AppendLine("| id | way | median | least | most | runs |\n| --- | --- | --- | --- | --- | --- |");
            foreach (var figure in figures)
            {
                if (figure.Outcome.Settings?["times"] is not JsonObject times) continue;
                foreach (var (way, time) in times)
                {
                    text.AppendLine(string.Create(CultureInfo.InvariantCulture,
                        $"| {figure.Quantity.Id} | {way} | {(double)time["medianMs"]:0.0} | {(double)time["leastMs"]:0.0} | {(double)time["mostMs"]:0.0} | {(int)time["runs"]} |"));
                }
            }
        }

        static void Settings(StringBuilder text, JsonArray points, bool havePlot)
        {
            text.AppendLine("\n## Run time against error\n");
            if (havePlot) text.AppendLine("![Each setting as a point, the front as a line](images/benchmarks-pareto.svg)\n");
            text.AppendLine($"{points.Count} settings; all of them: [benchmarks-pareto.csv](images/benchmarks-pareto.csv). The presets:\n");
            text.AppendLine("| preset | step | ends at | filter | cut | ms | RMSE, codes | samples per ray |\n| --- | --- | --- | --- | --- | --- | --- | --- |");
            foreach (var point in points.Where(point => point["preset"] != null))
            {
                text.AppendLine(string.Create(CultureInfo.InvariantCulture,
                    $"| {(string)point["preset"]} | {(double)point["step"]:0.##} | {(double)point["opaqueAlpha"]:0.####} | {(string)point["filter"]} | {(string)point["cut"]} "
                    + $"| {(double)point["ms"]:0.0} | {(double)point["errorCodes"]:0.###} | {(double)point["samplesPerRay"]:0.0} |"));
            }
        }
    }
}
