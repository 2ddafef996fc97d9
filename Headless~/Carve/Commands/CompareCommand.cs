using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Text.Json.Nodes;
using System.Threading.Tasks;
using AnatomyCarve.Headless.Cli.Files;
using AnatomyCarve.Metrics;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve compare: how far two renderings are apart, by the package's metrics.</summary>
    static class CompareCommand
    {
        public static Command Create()
        {
            const string what = "rendering: its .png, .pfm or .pgm, with the others beside it under the same name, or its report, which names them.";
            var a = new Argument<string>("A") { Description = $"The first {what}" };
            var b = new Argument<string>("B") { Description = $"The second {what}" };
            var json = new Option<bool>("--json") { Description = "JSON: depth, segments and image; null for what only one rendering has." };
            var command = new Command("compare", "Depth RMSE, first-segment MAE, image RMSE and PSNR of two renderings of the same size.") { a, b, json };
            command.SetAction((parsed, _) =>
            {
                var (filesA, filesB) = (RenderingFiles.Find(parsed.GetValue(a)), RenderingFiles.Find(parsed.GetValue(b)));
                var depth = CompareDepths(filesA.Depth, filesB.Depth);
                var segments = CompareSegments(filesA.Segments, filesB.Segments);
                var image = CompareImages(filesA.Picture, filesB.Picture);
                if (depth == null && segments == null && image == null)
                {
                    throw new CommandException($"{parsed.GetValue(a)} and {parsed.GetValue(b)} have no picture, depth or segments in common.");
                }

                Print(parsed.InvocationConfiguration.Output, depth, segments, image, parsed.GetValue(json));
                return Task.FromResult(0);
            });
            return command;
        }

        static DepthDifference? CompareDepths(string a, string b) =>
            a == null || b == null ? null : Pair(a, PfmFile.Read(a), b, PfmFile.Read(b), PictureMetrics.DepthRmse);

        static SegmentDifference? CompareSegments(string a, string b) =>
            a == null || b == null ? null : Pair(a, PgmFile.Read(a), b, PgmFile.Read(b), PictureMetrics.FirstSegmentMae);

        static ImageDifference? CompareImages(string a, string b) =>
            a == null || b == null ? null : Pair(a, PngFile.ReadRgb(a), b, PngFile.ReadRgb(b), PictureMetrics.Image);

        static TResult Pair<T, TResult>(string pathA, Plane<T> a, string pathB, Plane<T> b, System.Func<T[], T[], TResult> metric) =>
            a.Width == b.Width && a.Height == b.Height
                ? metric(a.Values, b.Values)
                : throw new CommandException($"{pathA} and {pathB} differ in size.");

        static void Print(TextWriter output, DepthDifference? depth, SegmentDifference? segments, ImageDifference? image, bool asJson)
        {
            if (asJson)
            {
                output.WriteLine(Json.Text(ToJson(depth, segments, image)));
                return;
            }

            var rows = new List<string[]>();
            if (depth is { } d)
            {
                rows.Add(["depth RMSE", $"{Number(d.RmseMm)} mm", $"{d.Both} pixels have a depth in both, {d.OnlyOne} in only one"]);
            }

            if (segments is { } s)
            {
                rows.Add(["first-segment MAE", Number(s.Mae), $"{s.Differing} of {s.Considered} pixels with a segment differ"]);
            }

            if (image is { } i)
            {
                rows.Add(["image RMSE", Number(i.Rmse), $"of 255, the largest difference is {i.Largest}"]);
                rows.Add(["image PSNR", double.IsInfinity(i.PsnrDecibels) ? "infinite" : $"{Number(i.PsnrDecibels)} dB", ""]);
            }

            Terminal.WriteTable(output, ["metric", "value", ""], rows.ToArray());
        }

        static JsonObject ToJson(DepthDifference? depth, SegmentDifference? segments, ImageDifference? image) => new()
        {
            ["depth"] = depth is not { } d ? null : new JsonObject { ["rmseMm"] = Json.Number(d.RmseMm), ["both"] = d.Both, ["onlyOne"] = d.OnlyOne },
            ["segments"] = segments is not { } s ? null : new JsonObject { ["mae"] = s.Mae, ["considered"] = s.Considered, ["differing"] = s.Differing },
            // The PSNR of equal pictures is infinite, which JSON can't say: null.
            ["image"] = image is not { } i ? null
                : new JsonObject { ["rmse"] = i.Rmse, ["psnrDecibels"] = Json.Number(i.PsnrDecibels), ["largest"] = i.Largest },
        };

        static string Number(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);
    }
}
