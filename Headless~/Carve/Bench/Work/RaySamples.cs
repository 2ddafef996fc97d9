using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>What the rays of a scene's picture do, per ray that meets the volume's box.</summary>
    /// <param name="Samples">opacity samples</param>
    /// <param name="Lookups">look-ups in the skip structure</param>
    /// <param name="Rays">the rays that meet the box</param>
    readonly record struct RayWork(double Samples, double Lookups, long Rays)
    {
        public static readonly string[] Scenes = ["demo-full", "demo-shell", "demo-sparse"];

        /// <summary>Scenes of real scans, where they are on this machine.</summary>
        public static readonly string[] Others = ["head-full", "ct-full"];

        /// <param name="quality">null: balanced</param>
        /// <param name="plain">nothing is skipped, and rays go on to their end</param>
        public static RayWork Of(MeasureContext context, string name, RenderQuality quality = null, bool plain = false)
        {
            var scene = context.Scenes.Get(name);
            var stage = context.Stage;
            stage.Show(scene);
            stage.Renderer.CountSamples = true;
            if (quality != null) stage.Renderer.Quality = quality;
            if (plain)
            {
                stage.Renderer.Quality.SkipEmptySpace = false;
                stage.Renderer.Quality.OpaqueAlpha = 1;
            }

            var rays = scene.Rays();
            var picture = stage.Render(rays);
            var met = VolumeBox.CountRays(rays, scene.Volume.Geometry);
            return new RayWork((double)picture.ReadSampleCount() / met, (double)picture.ReadLookupCount() / met, met);
        }

        public static JsonObject Settings(MeasureContext context) => new()
        {
            ["stepReferenceLengths"] = RenderQuality.Balanced().Step, ["quality"] = "balanced", ["skipping"] = true,
        };
    }

    /// <summary>P6: samples per ray.</summary>
    sealed class SamplesPerRay : IMeasure
    {
        public Quantity Quantity { get; } = new("P6", "opacity samples per ray that meets the volume: full, carved to a shell, sparse", "samples", [26, 28, 25]);

        public Outcome Run(MeasureContext context)
        {
            var settings = RayWork.Settings(context);
            var works = RayWork.Scenes.Select(name => RayWork.Of(context, name)).ToArray();
            settings["rays"] = new JsonArray(works.Select(work => (JsonNode)work.Rays).ToArray());
            settings["plain"] = new JsonArray(RayWork.Scenes.Select(name => Json.Number(RayWork.Of(context, name, plain: true).Samples)).ToArray());
            settings["fast"] = new JsonArray(RayWork.Scenes.Select(name => Json.Number(RayWork.Of(context, name, RenderQuality.Fast()).Samples)).ToArray());
            var others = new JsonObject();
            foreach (var name in SceneRun.Present(context, RayWork.Others)) others[name] = Json.Number(RayWork.Of(context, name).Samples);
            settings["others"] = others;
            return new Outcome(works.Select(work => work.Samples).ToArray(), string.Join(Outcome.Separator, RayWork.Scenes), settings);
        }
    }

    /// <summary>P7: look-ups in the skip structure per ray, the most of the scenes.</summary>
    sealed class LookupsPerRay : IMeasure
    {
        public Quantity Quantity { get; } = new("P7", "look-ups in the skip structure per ray that meets the volume, in the scene with most", "look-ups", [36]);

        public Outcome Run(MeasureContext context)
        {
            var works = RayWork.Scenes.Select(name => RayWork.Of(context, name)).ToArray();
            var settings = RayWork.Settings(context);
            settings["scenes"] = new JsonArray(works.Select(work => Json.Number(work.Lookups)).ToArray());
            return new Outcome([works.Max(work => work.Lookups)], string.Join(Outcome.Separator, RayWork.Scenes), settings);
        }
    }
}
