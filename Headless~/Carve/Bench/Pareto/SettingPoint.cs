using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Work;

namespace AnatomyCarve.Headless.Cli.Bench.Pareto
{
    /// <summary>A choice of everything that a ray pass can be set to.</summary>
    /// <param name="Step">in reference lengths</param>
    /// <param name="Skipping">whether empty space is skipped</param>
    /// <param name="OpaqueAlpha">where rays end; 1 = nowhere</param>
    /// <param name="Filter">how opacity between voxels is read</param>
    /// <param name="Layout">how the volume lies in textures</param>
    /// <param name="Cut">how spheres cut voxels</param>
    sealed record Setting(float Step, bool Skipping, float OpaqueAlpha, OpacityFilter Filter, TextureLayout Layout, CutMode Cut)
    {
        static readonly float[] Steps = [2, 1, 0.5f, 0.25f];
        static readonly float[] Ends = [1, 1 - 1 / 255f, 0.98f];

        static readonly (OpacityFilter, TextureLayout)[] Formats =
        [
            (OpacityFilter.Exact, TextureLayout.Compact), (OpacityFilter.Hardware, TextureLayout.Compact), (OpacityFilter.Exact, TextureLayout.Portable),
        ];

        /// <summary>The shipped preset that this is; null = none.</summary>
        public string Preset { get; init; }

        /// <summary>Every setting: binary cuts over the whole grid, and the presets. By layout, as another one takes the volume to the GPU anew.</summary>
        public static IReadOnlyList<Setting> All()
        {
            var skipping = new[] { true, false };
            var presets = RenderQuality.Names.Select(name => OfPreset(name, RenderQuality.Named(name))).ToList();
            var grid = from step in Steps
                       from skip in skipping
                       from end in Ends
                       from format in Formats
                       select new Setting(step, skip, end, format.Item1, format.Item2, CutMode.Binary);
            return presets.Concat(grid.Where(setting => presets.All(preset => preset with { Preset = null } != setting))).OrderBy(setting => setting.Layout).ToArray();
        }

        public RenderQuality ToQuality()
        {
            var quality = new RenderQuality { Step = Step, OpaqueAlpha = OpaqueAlpha, Filter = Filter, CutMode = Cut };
            quality.SkipEmptySpace = Skipping;
            return quality;
        }

        static Setting OfPreset(string name, RenderQuality quality) =>
            new(quality.Step, quality.SkipEmptySpace, quality.OpaqueAlpha, quality.Filter, TextureLayout.Compact, quality.CutMode) { Preset = name };
    }

    /// <summary>What a setting costs and how far its picture is off.</summary>
    /// <param name="Milliseconds">median, least and most</param>
    /// <param name="ErrorCodes">RMSE of the colour in codes of 255, against the converged picture with the same cut</param>
    sealed record SettingPoint(Setting Setting, Time.Timing Milliseconds, double ErrorCodes, double SamplesPerRay)
    {
        /// <summary>Whether no point is both clearly faster and no worse, nor clearly better and no slower.</summary>
        public bool IsOnFront(IEnumerable<SettingPoint> points, double timeTolerance, double errorTolerance) => !points.Any(other =>
            other.Setting.Cut == Setting.Cut
            && other.Milliseconds.Median < Milliseconds.Median * (1 - timeTolerance) && other.ErrorCodes <= ErrorCodes * (1 + errorTolerance) + 1e-6);

        public JsonObject ToJson() => new()
        {
            ["preset"] = Setting.Preset, ["step"] = Json.Number(Math.Round(Setting.Step, 5)), ["skipping"] = Setting.Skipping, ["opaqueAlpha"] = Json.Number(Math.Round(Setting.OpaqueAlpha, 5)),
            ["filter"] = Setting.Filter.ToString(), ["layout"] = Setting.Layout.ToString(), ["cut"] = Setting.Cut.ToString(),
            ["ms"] = Math.Round(Milliseconds.Median, 3), ["leastMs"] = Math.Round(Milliseconds.Milliseconds.Min(), 3),
            ["mostMs"] = Math.Round(Milliseconds.Milliseconds.Max(), 3), ["errorCodes"] = Math.Round(ErrorCodes, 5),
            ["samplesPerRay"] = Math.Round(SamplesPerRay, 2),
        };
    }
}
