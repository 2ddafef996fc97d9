using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Headless.Cli.Files;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>carve info: what the package's readers see in a file.</summary>
    static class InfoCommand
    {
        public static Command Create()
        {
            var file = new Argument<string>("FILE") { Description = "A volume or a segmentation: .nii, .nii.gz, .nrrd, .seg.nrrd." };
            var json = new Option<bool>("--json")
            {
                Description = "JSON: dims, spacing, originLps, directionLps, ijkToRas, voxelType, components, min, max, mean and sha256 "
                    + "(of the values after the file's slope and intercept, as 64-bit little-endian floats in file order), segments.",
            };
            var noProgress = new Option<bool>("--no-progress") { Description = "No progress bars." };
            var command =
                new Command("info", "Prints what the readers see in a file: geometry in patient millimetres, values, segments.") { file, json, noProgress };
            command.SetAction((parsed, cancellation) =>
            {
                InputFile.Check(parsed.GetValue(file));
                var output = parsed.InvocationConfiguration.Output;
                var volume = ProgressBars.Show(parsed.InvocationConfiguration.Error, !parsed.GetValue(noProgress), bars =>
                    bars.Step($"reading {Path.GetFileName(parsed.GetValue(file))}",
                        progress => VolumeReader.Read(parsed.GetValue(file), cancellation, progress)));
                var warnings = new Warnings();
                foreach (var warning in volume.Warnings) warnings.Add(warning);
                warnings.WriteTo(parsed.InvocationConfiguration.Error);
                Print(output, volume, volume.Statistics(cancellation), parsed.GetValue(json));
                return Task.FromResult(0);
            });
            return command;
        }

        static void Print(TextWriter output, VolumeData volume, VolumeStatistics statistics, bool asJson)
        {
            if (asJson)
            {
                output.WriteLine(Json.Text(ToJson(volume, statistics)));
                return;
            }

            var geometry = volume.Geometry;
            var direction = geometry.Direction();
            var origin = geometry.IjkToLps.Origin;
            output.WriteLine($"file         {volume.Source} ({volume.Format})");
            output.WriteLine($"size         {geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK} voxels, {volume.Components} component(s), "
                + $"{TypeName(volume.VoxelType)}");
            output.WriteLine($"spacing      {Numbers(geometry.SpacingMm.X, geometry.SpacingMm.Y, geometry.SpacingMm.Z)} mm");
            output.WriteLine($"orientation  {geometry.OrientationCode}{(geometry.IsSheared() ? ", sheared" : "")}");
            output.WriteLine($"origin       {Numbers(origin.X, origin.Y, origin.Z)} mm (LPS)");
            for (var row = 0; row < 3; row++)
            {
                output.WriteLine($"{(row == 0 ? "direction" : ""),-12} {Numbers(direction[row, 0], direction[row, 1], direction[row, 2])}");
            }

            output.WriteLine($"values       {Numbers(statistics.Minimum)} to {Numbers(statistics.Maximum)}, mean {Numbers(statistics.Mean)}"
                + (statistics.NonFiniteCount == 0 ? "" : $", {statistics.NonFiniteCount} of them not finite"));
            output.WriteLine($"sha256       {statistics.Sha256}");
            if (volume.Segments.Count == 0) return;
            Terminal.WriteTable(output, ["label", "layer", "name", "colour", "id"], volume.Segments.Select(segment => new[]
            {
                segment.LabelValue.ToString(CultureInfo.InvariantCulture), segment.Layer.ToString(CultureInfo.InvariantCulture),
                segment.Name ?? "", segment.Color?.ToString() ?? "", segment.Id ?? "",
            }).ToArray());
        }

        static JsonObject ToJson(VolumeData volume, VolumeStatistics statistics)
        {
            var geometry = volume.Geometry;
            var direction = geometry.Direction();
            var lps = geometry.IjkToLps;
            var ras = new JsonArray();
            for (var row = 0; row < 3; row++)
            {
                var sign = row < 2 ? -1 : 1;
                ras.Add(Row(sign * lps[row, 0], sign * lps[row, 1], sign * lps[row, 2], sign * lps[row, 3]));
            }

            ras.Add(Row(0, 0, 0, 1));
            return new JsonObject
            {
                ["dims"] = new JsonArray(geometry.SizeI, geometry.SizeJ, geometry.SizeK),
                ["spacing"] = Row(geometry.SpacingMm.X, geometry.SpacingMm.Y, geometry.SpacingMm.Z),
                ["originLps"] = Row(lps.Origin.X, lps.Origin.Y, lps.Origin.Z),
                ["directionLps"] = new JsonArray(Enumerable.Range(0, 3)
                    .Select(row => (JsonNode)Row(direction[row, 0], direction[row, 1], direction[row, 2])).ToArray()),
                ["ijkToRas"] = ras,
                ["voxelType"] = TypeName(volume.VoxelType),
                ["components"] = volume.Components,
                ["min"] = Json.Number(statistics.Minimum),
                ["max"] = Json.Number(statistics.Maximum),
                ["mean"] = Json.Number(statistics.Mean),
                ["sha256"] = statistics.Sha256,
                ["segments"] = new JsonArray(volume.Segments.Select(segment => (JsonNode)new JsonObject
                {
                    ["id"] = segment.Id,
                    ["name"] = segment.Name,
                    ["label"] = segment.LabelValue,
                    ["layer"] = segment.Layer,
                    ["color"] = segment.Color is { } color ? new JsonArray(color.R, color.G, color.B) : null,
                }).ToArray()),
            };
        }

        static JsonArray Row(params double[] numbers) => new(numbers.Select(number => Json.Number(number)).ToArray());

        static string TypeName(VoxelType type) => type.ToString().ToLowerInvariant();

        static string Numbers(params double[] numbers) =>
            string.Join("  ", numbers.Select(number => number.ToString("0.######", CultureInfo.InvariantCulture)));
    }
}
