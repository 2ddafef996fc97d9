using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text.Json.Nodes;

namespace AnatomyCarve.Headless.Cli.Bench
{
    /// <summary>A comparison of loads as a table and as JSON.</summary>
    static class LoadReport
    {
        const double Mega = 1e6;

        public static void Write(TextWriter output, LoadComparison comparison)
        {
            var info = comparison.Info;
            output.WriteLine(Text($"{info.SizeI} x {info.SizeJ} x {info.SizeK} voxels, {info.SegmentCount} segments; median of {comparison.Files.Milliseconds.Length} runs"));
            Terminal.WriteTable(output, ["load", "ms", "least", "most", "files : this", "MB allocated"],
                comparison.Packed.Prepend(comparison.Files).Select(load => new[]
                {
                    load.Way, Text($"{load.Median:0.0}"), Text($"{load.Milliseconds.Min():0.0}"), Text($"{load.Milliseconds.Max():0.0}"),
                    Text($"{comparison.Files.Median / load.Median:0.0}"), Text($"{load.AllocatedBytes / Mega:0.0}"),
                }).ToArray());
            Terminal.WriteTable(output, ["bytes of", "MB", "share of gzip"],
                Row("the files", comparison.FileBytes, comparison),
                Row("codes and label indices, gzip level 6", comparison.GzipBytes, comparison),
                Row("the packed volume", info.PackedBytes, comparison),
                Row("  its intensities", info.IntensityBytes, comparison),
                Row("  its labels", info.LabelBytes, comparison),
                Row("  its header", info.HeaderBytes, comparison),
                Row("voxels in memory", info.UnpackedBytes, comparison));
        }

        public static JsonObject ToJson(LoadComparison comparison, NamedContent scan, NamedContent labels)
        {
            var info = comparison.Info;
            return new JsonObject
            {
                ["volume"] = scan.Name,
                ["labels"] = labels?.Name,
                ["dims"] = new JsonArray(info.SizeI, info.SizeJ, info.SizeK),
                ["segments"] = info.SegmentCount,
                ["fileBytes"] = comparison.FileBytes,
                ["gzipBytes"] = comparison.GzipBytes,
                ["packedBytes"] = info.PackedBytes,
                ["packedIntensityBytes"] = info.IntensityBytes,
                ["packedLabelBytes"] = info.LabelBytes,
                ["packedHeaderBytes"] = info.HeaderBytes,
                ["voxelBytes"] = info.UnpackedBytes,
                ["packMs"] = Math.Round(comparison.PackMilliseconds, 3),
                ["loads"] = new JsonArray(comparison.Packed.Prepend(comparison.Files).Select(load => (JsonNode)new JsonObject
                {
                    ["way"] = load.Way,
                    ["medianMs"] = Math.Round(load.Median, 3),
                    ["ms"] = new JsonArray(load.Milliseconds.Select(time => (JsonNode)Math.Round(time, 3)).ToArray()),
                    ["filesToThis"] = Math.Round(comparison.Files.Median / load.Median, 3),
                    ["allocatedBytes"] = load.AllocatedBytes,
                }).ToArray()),
                ["machine"] = new JsonObject
                {
                    ["processors"] = Environment.ProcessorCount,
                    ["architecture"] = RuntimeInformation.ProcessArchitecture.ToString(),
                    ["runtime"] = RuntimeInformation.FrameworkDescription,
                },
            };
        }

        static string[] Row(string what, long bytes, LoadComparison comparison) =>
            [what, Text($"{bytes / Mega:0.000}"), Text($"{(double)bytes / comparison.GzipBytes:0.00}")];

        static string Text(FormattableString text) => FormattableString.Invariant(text);
    }
}
