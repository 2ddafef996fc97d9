using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Carving;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Headless.Cli.Bench.Time;
using AnatomyCarve.Headless.Cli.Bench.Work;

namespace AnatomyCarve.Headless.Cli.Bench.Pareto
{
    /// <summary>P27: run time against error over all settings; the presets are to lie on the front.</summary>
    sealed class TimeAgainstError : IMeasure
    {
        const string Scene = "cube-move";
        const int Side = 256;
        const int MostRuns = 3;

        /// <summary>Times swing: a preset is off the front only if another setting is faster by more than this.</summary>
        const double TimeTolerance = 0.2;

        /// <summary>Errors that differ by less are one.</summary>
        const double ErrorTolerance = 0.02;

        public Quantity Quantity { get; } = new("P27", "shipped presets that do not lie on the front of run time against error", "presets", [0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var references = new Dictionary<CutMode, PictureData>();
            foreach (var cut in new[] { CutMode.Binary, CutMode.Smooth }) references[cut] = ConvergedPicture.Of(context.Stage, scene, cut, Side);
            var settings = Setting.All();
            var met = VolumeBox.CountRays(scene.Rays(Side, Side), scene.Volume.Geometry);
            var points = settings.Select((setting, number) =>
            {
                context.Progress.Report((float)number / settings.Count);
                return Measure(context, scene, setting, references[setting.Cut], met);
            }).ToArray();
            context.Stage.Renderer.Layout = TextureLayout.Automatic;
            var off = points.Where(point => point.Setting.Preset != null && !point.IsOnFront(points, TimeTolerance, ErrorTolerance)).ToArray();
            return new Outcome([off.Length], Scene, new JsonObject
            {
                ["size"] = Side, ["timeTolerance"] = TimeTolerance, ["errorTolerance"] = ErrorTolerance, ["reference"] = ConvergedPicture.Description,
                ["off"] = new JsonArray(off.Select(point => (JsonNode)point.Setting.Preset).ToArray()),
                ["points"] = new JsonArray(points.Select(point => (JsonNode)point.ToJson()).ToArray()),
            });
        }

        static SettingPoint Measure(MeasureContext context, BenchScene scene, Setting setting, PictureData reference, long raysMet)
        {
            var stage = context.Stage;
            if (stage.Renderer.Layout != setting.Layout) stage.Renderer.Layout = setting.Layout;
            stage.Show(scene);
            stage.Renderer.Quality = setting.ToQuality();
            stage.Update();
            var rays = new FreshRays(scene.Rays(Side, Side));
            var quiet = context with { Progress = new Silent() };
            var timing = Turns.Measure(quiet, Math.Min(context.Runs, MostRuns), new TimedWay("rays", null, () => stage.Render(rays.Next())))[0];
            var error = ConvergedPicture.RmseCodes(stage.Render(rays.Next()).Read(), reference);
            stage.Renderer.CountSamples = true;
            var samples = (double)stage.Render(rays.Next()).ReadSampleCount() / raysMet;
            stage.Renderer.CountSamples = false;
            return new SettingPoint(setting, timing, error, samples);
        }

        sealed class Silent : IProgress<float>
        {
            public void Report(float value)
            {
            }
        }
    }
}
