using System;
using System.Collections.Generic;
using System.Globalization;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>What Inspectors say about a volume: lines of a title and a text.</summary>
    static class VolumeSummary
    {
        const double MiB = 1024.0 * 1024.0;

        /// <summary>The lines for a loaded volume.</summary>
        public static IReadOnlyList<(string title, string text)> Of(SegmentedVolume volume)
        {
            VolumeGeometry g = volume.Geometry;
            List<(string title, string text)> lines = Lines(
                new Vector3Int(g.SizeI, g.SizeJ, g.SizeK), g.SpacingMm, g.OrientationCode, AxisDirections.Sentence(g.OrientationCode),
                volume.Intensity.ValueMin, volume.Intensity.ValueMax, volume.Segments.Count - 1);
            MemoryForecast forecast = MemoryForecast.Of(volume);
            lines.Add(("Memory", Bytes(forecast.CpuBytes) + ", on the GPU " + Bytes(forecast.GpuBytes)));
            return lines;
        }

        /// <summary>The lines for a volume that lies in an asset.</summary>
        public static IReadOnlyList<(string title, string text)> Of(VolumeAsset asset)
        {
            List<(string title, string text)> lines = Lines(
                asset.Size, new VectorMm(asset.SpacingMm.x, asset.SpacingMm.y, asset.SpacingMm.z), asset.Orientation, asset.OrientationSentence,
                asset.ValueMin, asset.ValueMax, asset.Segments.Count - 1);
            lines.Add(("Memory", Bytes(asset.UnpackedBytes) + ", packed " + Bytes(asset.PackedBytes)));
            if (asset.Sources.Count > 0)
                lines.Add(("Made of", string.Join(", ", asset.Sources)));
            return lines;
        }

        /// <summary>A size in MiB, such as "27.1 MiB".</summary>
        public static string Bytes(long bytes) => (bytes / MiB).ToString("N1", CultureInfo.InvariantCulture) + " MiB";

        static List<(string title, string text)> Lines(
            Vector3Int size, VectorMm spacing, string orientation, string sentence, double min, double max, int segments)
        {
            return new List<(string title, string text)>
            {
                ("Size", FormattableString.Invariant($"{size.x} x {size.y} x {size.z} voxels")),
                ("Spacing", FormattableString.Invariant($"{spacing.X:0.###} x {spacing.Y:0.###} x {spacing.Z:0.###} mm")),
                ("Extent", FormattableString.Invariant($"{spacing.X * size.x:0.#} x {spacing.Y * size.y:0.#} x {spacing.Z * size.z:0.#} mm")),
                ("Orientation", orientation + ". " + sentence),
                ("Intensities", FormattableString.Invariant($"{min:0.####} to {max:0.####}")),
                ("Segments", segments <= 0 ? "none" : segments.ToString("N0", CultureInfo.InvariantCulture)),
            };
        }
    }
}
