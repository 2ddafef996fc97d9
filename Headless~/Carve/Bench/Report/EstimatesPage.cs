using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Report
{
    /// <summary>
    /// What a frame moves and samples, from counts that do not depend on the machine, against what devices are said to do per second. The generated part of a
    /// page that says where the numbers come from.
    /// </summary>
    static class EstimatesPage
    {
        const double Giga = 1e9;

        /// <summary>Bytes that a stage reads and writes per voxel; the later two read tiles instead, as if each brick's were whole.</summary>
        const double ClipBytes = 2 + 1 + 1, AntiAliasBytes = 1, NormalsBytes = 2;

        /// <summary>Bytes of a brick's tile: 10 and 14 voxels along each axis.</summary>
        const double AntiAliasTile = 1000, NormalsTile = 2744;

        /// <summary>Bytes that a sample reads: eight opacities. Most come from caches; as if none did.</summary>
        const double SampleBytes = 8;

        /// <summary>What the shading of a place reads: raw opacities, labels and normals of eight voxels, and a colour. An opaque surface is shaded twice.</summary>
        const double ShadingBytes = 8 + 8 + 16 + 16, ShadingTexels = 25, ShadingsPerRay = 2;

        /// <summary>What the first visible segment reads: raw opacities of eight voxels and one's label.</summary>
        const double SegmentTexels = 9;

        const double SurfaceBytes = ShadingBytes * ShadingsPerRay + SegmentTexels, SurfaceTexels = ShadingTexels * ShadingsPerRay + SegmentTexels;

        /// <param name="Name">the device</param>
        /// <param name="GigabytesPerSecond">to memory</param>
        /// <param name="GigatexelsPerSecond">filtered texels; an assumption where it is not published</param>
        /// <param name="Pixels">of both eyes, or of the screen</param>
        /// <param name="FramesPerSecond">wanted</param>
        sealed record Device(string Name, double GigabytesPerSecond, double GigatexelsPerSecond, double Pixels, double FramesPerSecond);

        // The page says where these come from.
        static readonly Device[] Devices =
        [
            new("Quest 3 (Snapdragon XR2 Gen 2)", 64, 17.6, 2 * 1680.0 * 1760, 72),
            new("desktop (GeForce RTX 3060)", 360, 199, 2560.0 * 1440, 90),
        ];

        /// <param name="Name">a preset's</param>
        /// <param name="Samples">per ray, in the scene with most</param>
        /// <param name="TexelsPerSample">8 where the shader filters, 1 where the texture unit does</param>
        sealed record Quality(string Name, double Samples, double TexelsPerSample);

        public static string Text(IReadOnlyList<Figure> figures)
        {
            var text = new StringBuilder();
            var moved = figures.FirstOrDefault(figure => figure.Quantity.Id == "P2")?.Outcome.Settings?["demo-move-40"];
            var rays = figures.FirstOrDefault(figure => figure.Quantity.Id == "P6")?.Outcome;
            if (moved == null || rays?.Values == null) return "The run did not measure P2 and P6, from which this is derived.";
            Quality[] qualities = [new("balanced", rays.Values.Max(), 8), new("fast", rays.Settings["fast"].AsArray().Max(samples => (double)samples), 1)];
            var volumeBytes = Elements(moved, "clipVoxels") * ClipBytes + Elements(moved, "antiAlias") * AntiAliasBytes + Elements(moved, "sobelNormals") * NormalsBytes
                + Bricks(moved, "antiAlias") * AntiAliasTile + Bricks(moved, "sobelNormals") * NormalsTile;
            text.AppendLine(string.Create(CultureInfo.InvariantCulture,
                $"A sphere of 40 mm moves 5 mm in the scene `demo-move-40`: {volumeBytes / 1e6:0.0} MB in the volume's kernels. Rays take {qualities[0].Samples:0.0} samples each in the scene "
                + $"with most (P6), {qualities[1].Samples:0.0} with the quality `fast`; every pixel is taken to have a ray that meets the volume.\n"));
            text.AppendLine(
                "| device | quality | frame | bytes a frame | at the bandwidth | texels a frame | at the fill rate | share of a frame |\n| --- | --- | --- | --- | --- | --- | --- | --- |");
            foreach (var device in Devices)
            {
                foreach (var quality in qualities) text.AppendLine(Row(device, quality, volumeBytes));
            }

            return text.ToString().Replace("\r\n", "\n");
        }

        static double Bricks(JsonNode work, string stage) => (double)work[stage]["bricks"];

        static double Elements(JsonNode work, string stage) => (double)work[stage]["elements"];

        static string Row(Device device, Quality quality, double volumeBytes)
        {
            var texels = device.Pixels * (quality.TexelsPerSample * quality.Samples + SurfaceTexels);
            var bytes = volumeBytes + device.Pixels * (SampleBytes * quality.Samples + SurfaceBytes);
            double frame = 1000 / device.FramesPerSecond, memory = 1000 * bytes / (device.GigabytesPerSecond * Giga), fill = 1000 * texels / (device.GigatexelsPerSecond * Giga);
            return string.Create(CultureInfo.InvariantCulture,
                $"| {device.Name} | `{quality.Name}` | {frame:0.0} ms ({device.FramesPerSecond:0} Hz, {device.Pixels / 1e6:0.0} Mpixel) | {bytes / Giga:0.00} GB | {memory:0.0} ms | {texels / Giga:0.00} G | {fill:0.0} ms "
                + $"| {100 * Math.Max(memory, fill) / frame:0} % |");
        }
    }
}
