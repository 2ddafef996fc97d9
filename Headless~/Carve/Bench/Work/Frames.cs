using System;
using System.Linq;
using System.Text.Json.Nodes;
using AnatomyCarve.Headless.Cli.Bench.Measures;
using AnatomyCarve.Headless.Cli.Bench.Scenes;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Cli.Bench.Work
{
    /// <summary>P22: what the second eye costs.</summary>
    sealed class SecondEye : IMeasure
    {
        const string Scene = "demo-move-40";
        const double EyeDistanceMm = 64;
        const int Side = 64;

        public Quantity Quantity { get; } = new("P22", "the second eye: dispatches of volume kernels, rays of both eyes against one", "dispatches, times", [0, 2]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            stage.Update();
            SceneRun.MoveActive(stage.Carving, scene, 1);
            stage.Renderer.Statistics.Reset();
            var rays = scene.Rays(Side, Side);
            stage.Render(rays);
            var left = stage.Renderer.Statistics.Raymarch.Elements;
            var dispatches = stage.Renderer.Statistics.VolumeDispatches;
            var right = rays.RayThroughPixel(rays.Width - 1, 0).Direction - rays.RayThroughPixel(0, 0).Direction;
            stage.Render(new PictureRays(
                rays.Origin + EyeDistanceMm / right.Length * right, rays.OriginDx, rays.OriginDy, rays.Direction, rays.DirectionDx, rays.DirectionDy, rays.Width, rays.Height));
            var both = stage.Renderer.Statistics.Raymarch.Elements;
            return new Outcome([stage.Renderer.Statistics.VolumeDispatches - dispatches, (double)both / left], Scene, new JsonObject
            {
                ["firstEyesDispatches"] = dispatches, ["raysPerEye"] = left, ["eyeDistanceMm"] = EyeDistanceMm,
            });
        }
    }

    /// <summary>P25: waiting for the GPU, and garbage.</summary>
    sealed class WaitsAndGarbage : IMeasure
    {
        const string Scene = "small-move";
        const int Frames = 50;

        public Quantity Quantity { get; } = new(
            "P25", "per frame: blocking read-backs while a sphere moves, managed bytes while nothing changes", "waits, bytes", [0, 0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            var rays = scene.Rays(32, 32);
            void Frame(int number, bool moves)
            {
                if (moves) SceneRun.MoveActive(stage.Carving, scene, number % 2);
                stage.Renderer.Render(rays);
            }

            (double Waits, double Bytes) PerFrame(bool moves)
            {
                long bytes = 0;
                for (var frame = 0; frame < Frames; frame++)
                {
                    Frame(frame, moves);
                    stage.Host.Step();
                }

                var waits = stage.Host.GpuWaits;
                for (var frame = 0; frame < Frames; frame++)
                {
                    var before = GC.GetAllocatedBytesForCurrentThread();
                    Frame(frame, moves);
                    bytes += GC.GetAllocatedBytesForCurrentThread() - before;
                    stage.Host.Step();
                }

                return ((stage.Host.GpuWaits - waits) / (double)Frames, bytes / (double)Frames);
            }

            var (moved, still) = (PerFrame(moves: true), PerFrame(moves: false));
            return new Outcome([moved.Waits, still.Bytes], Scene, new JsonObject
            {
                ["frames"] = Frames,
                ["bytesPerMovedFrame"] = Json.Number(moved.Bytes),
                ["note"] = "bytesPerMovedFrame contains what the headless engine itself allocates in dispatches and uploads",
            });
        }
    }

    /// <summary>P36: how many frames later than a sphere's move a camera's picture shows it.</summary>
    sealed class FramesBehind : IMeasure
    {
        const string Scene = "small-move";
        const int Most = 5;
        const int Side = 96;

        public Quantity Quantity { get; } = new("P36", "frames from a moved sphere to the camera's picture of it", "frames", [0]);

        public Outcome Run(MeasureContext context)
        {
            var scene = context.Scenes.Get(Scene);
            var stage = context.Stage;
            stage.Show(scene);
            var (camera, target) = MakeCamera(scene);
            try
            {
                stage.Host.Step();
                var old = stage.Host.ReadTexture(target);
                SceneRun.MoveActive(stage.Carving, scene, 1);
                stage.Host.Step();
                var pictures = new[] { stage.Host.ReadTexture(target) }.ToList();
                for (var frame = 1; frame < Most; frame++)
                {
                    stage.Host.Step();
                    pictures.Add(stage.Host.ReadTexture(target));
                }

                var wanted = pictures[^1];
                if (wanted.AsSpan().SequenceEqual(old)) throw new CommandException($"scene \"{Scene}\": the camera does not see the move.");
                return new Outcome([pictures.FindIndex(picture => picture.AsSpan().SequenceEqual(wanted))], Scene, new JsonObject { ["size"] = Side });
            }
            finally
            {
                UnityEngine.Object.Destroy(camera.gameObject);
                UnityEngine.Object.Destroy(target);
                stage.Host.Step();
            }
        }

        static (Camera Camera, RenderTexture Target) MakeCamera(BenchScene scene)
        {
            var geometry = scene.Volume.Geometry;
            var orbit = scene.Camera();
            var camera = new GameObject("bench camera").AddComponent<Camera>();
            var target = new RenderTexture(Side, Side, 24) { name = "bench picture" };
            target.Create();
            camera.targetTexture = target;
            camera.fieldOfView = (float)orbit.VerticalFovDegrees;
            camera.nearClipPlane = 0.01f;
            var middle = VolumeSpace.LpsToLocal(geometry, geometry.CentreLps);
            camera.transform.position = VolumeSpace.LpsToLocal(geometry, orbit.EyeAround(geometry, 1));
            camera.transform.rotation = Quaternion.LookRotation(
                middle - camera.transform.position, VolumeSpace.LpsToLocal(geometry, geometry.CentreLps + orbit.UpLps) - middle);
            return (camera, target);
        }
    }
}
