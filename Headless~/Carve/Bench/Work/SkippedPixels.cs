using System.Collections.Generic;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P8: pixels that differ between a picture with skipping and one without.</summary>
    sealed class SkippedPixels : IMeasure
    {
        const int Side = 192;
        static readonly string[] Scenes = ["demo-shell", "demo-sparse"];

        public Quantity Quantity { get; } = new("P8", "pixels that differ with skipping on and off (colour, depth or segment)", "pixels", [0]);

        public Outcome Run(MeasureContext context)
        {
            long differing = 0;
            var pictures = 0;
            foreach (var name in Scenes)
            {
                var scene = context.Scenes.Get(name);
                context.Stage.Show(scene);
                foreach (var rays in Views(scene))
                {
                    differing += Differing(Read(context.Stage, rays, true), Read(context.Stage, rays, false));
                    pictures++;
                }
            }

            return new Outcome([differing], string.Join(Outcome.Separator, Scenes), new JsonObject { ["pictures"] = pictures, ["size"] = Side });
        }

        static PictureData Read(BenchStage stage, PictureRays rays, bool skipping)
        {
            stage.Renderer.Quality.SkipEmptySpace = skipping;
            return stage.Render(rays).Read();
        }

        // Around the volume, along its axes, and from inside.
        static IEnumerable<PictureRays> Views(BenchScene scene)
        {
            var geometry = scene.Volume.Geometry;
            for (var turn = 0; turn < 8; turn++) yield return scene.Camera(45 * turn, 20 * (turn % 3 - 1)).RaysAround(geometry, Side, Side);
            for (var turn = 0; turn < 4; turn++) yield return new OrbitCamera(90 * turn, 0).RaysAround(geometry, Side, Side);
            yield return new OrbitCamera(0, 90).RaysAround(geometry, Side, Side);
            for (var turn = 0; turn < 4; turn++)
            {
                var camera = scene.Camera(90 * turn, 0);
                var eye = geometry.CentreLps + 30 * camera.TowardsEyeLps;
                yield return PictureRays.Perspective(eye, eye - camera.TowardsEyeLps, camera.UpLps, 80, Side, Side);
            }

            var parallel = scene.Camera(0, 0);
            yield return PictureRays.Orthographic(geometry.CentreLps + 500 * parallel.TowardsEyeLps, geometry.CentreLps, new VectorMm(0, 0, 1), 250, Side, Side);
        }

        static long Differing(PictureData a, PictureData b)
        {
            long count = 0;
            for (var pixel = 0; pixel < a.Color.Length; pixel++)
            {
                if (a.Color[pixel] != b.Color[pixel] || !a.DepthMm[pixel].Equals(b.DepthMm[pixel]) || a.Segments[pixel] != b.Segments[pixel]) count++;
            }

            return count;
        }
    }
}
