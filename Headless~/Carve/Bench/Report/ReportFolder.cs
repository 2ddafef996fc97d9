using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Pareto;

namespace AnatomyCarve.Headless.Cli.Bench.Report
{
    /// <summary>Writes the manual's pages of figures: benchmarks.md and device-estimates.md, tables and plots in images/.</summary>
    static class ReportFolder
    {
        const string Begin = "<!-- generated: carve bench all --report; what is written by hand stands outside -->";
        const string End = "<!-- end of what is generated -->";
        const string Pareto = "benchmarks-pareto", Scaling = "benchmarks-scaling";

        /// <param name="folder">where to; made if need be</param>
        /// <param name="figures">the run's figures</param>
        /// <param name="scaling">the run's curves; null = none were measured</param>
        /// <param name="changes">against older figures; null = there are none</param>
        /// <param name="warnings">told what could not be drawn</param>
        public static void Write(
            string folder, IReadOnlyList<Figure> figures, IReadOnlyList<ScalingPoint> scaling, IReadOnlyList<FigureChange> changes, Warnings warnings)
        {
            // As files have them: then every number is one of JSON's, whatever it was computed as.
            figures = figures.Select(figure => Figure.FromJson(figure.Quantity.Id, JsonNode.Parse(figure.ToJson().ToJsonString()))).ToArray();
            var images = Directory.CreateDirectory(Path.Combine(folder, "images")).FullName;
            var points = figures.FirstOrDefault(figure => figure.Quantity.Id == "P27")?.Outcome.Settings?["points"] as JsonArray;
            if (points != null) File.WriteAllText(Path.Combine(images, Pareto + ".csv"), ParetoCsv(points));
            if (scaling != null) File.WriteAllText(Path.Combine(images, Scaling + ".csv"), ScalingCurves.ToCsv(scaling));
            if (points != null && scaling != null) Plot(images, warnings);
            bool Has(string name) => File.Exists(Path.Combine(images, name + ".svg"));
            Replace(Path.Combine(folder, "benchmarks.md"), "# Benchmarks", ReportPage.Text(figures, points, Has(Pareto), Has(Scaling), changes));
            Replace(Path.Combine(folder, "device-estimates.md"), "# What devices would need", EstimatesPage.Text(figures));
        }

        static string ParetoCsv(JsonArray points)
        {
            var lines = points.Select(point => string.Join(',', new[] { "preset", "step", "skipping", "opaqueAlpha", "filter", "layout", "cut", "ms", "leastMs", "mostMs", "errorCodes", "samplesPerRay" }
                .Select(name => point[name]?.ToString() ?? "").Select(text => text is "true" ? "True" : text is "false" ? "False" : text)));
            return "preset,step,skipping,opaque alpha,filter,layout,cut,ms,least ms,most ms,error codes,samples per ray\n" + string.Join('\n', lines) + "\n";
        }

        static void Plot(string images, Warnings warnings)
        {
            var python = File.Exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3"; // matplotlib is Debian's
            try
            {
                using var process = Process.Start(new ProcessStartInfo(python, [BenchFiles.Find("Report", "plot.py"), images]) { RedirectStandardError = true });
                var problem = process.StandardError.ReadToEnd();
                process.WaitForExit();
                if (process.ExitCode != 0) warnings.Add($"the plots were not drawn (they need python3-matplotlib): {problem.Split('\n').LastOrDefault(line => line.Length > 0)}");
            }
            catch (Win32Exception)
            {
                warnings.Add("the plots were not drawn: there is no python3");
            }
        }

        /// <summary>Puts text between a page's marks; a page without them gets them at its end, a page that does not exist is made.</summary>
        public static void Replace(string path, string title, string text)
        {
            var page = File.Exists(path) ? File.ReadAllText(path) : title + "\n\n";
            int begin = page.IndexOf(Begin, StringComparison.Ordinal), end = page.IndexOf(End, StringComparison.Ordinal);
            if (begin < 0 || end < begin) (page, begin, end) = (page.TrimEnd() + "\n\n", page.TrimEnd().Length + 2, -1);
            var after = end < 0 ? "\n" : page[(end + End.Length)..];
            File.WriteAllText(path, $"{page[..begin]}{Begin}\n\n{text.TrimEnd()}\n\n{End}{after}");
        }
    }
}
