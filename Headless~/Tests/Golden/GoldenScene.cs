using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using AnatomyCarve.Formats;
using AnatomyCarve.Headless.Tests.CommandLine;
using AnatomyCarve.Picking;
using AnatomyCarve.Tests;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Golden
{
    /// <summary>A scene of which a picture is kept: a volume, what is done with it, and where it is seen from.</summary>
    sealed record GoldenScene(string Name, Func<SegmentedVolume> Volume, Action<CarvedVolumeRenderer> Prepare, Func<SegmentedVolume, PictureRays> Rays)
    {
        /// <summary>Width and height of every picture.</summary>
        public const int Pixels = 512;

                public static IReadOnlyList<GoldenScene> All { get; } =
        [
            new("markers", () => Phantoms.Markers(), _ => { }, Front),
            new("markers-carved", () => Phantoms.Markers(), Carve, Aside),
            new("markers-best", () => Phantoms.Markers(), r => Carve(r, RenderQuality.Best()), Aside),
            new("markers-fast", () => Phantoms.Markers(), r => Carve(r, RenderQuality.Fast()), Aside),
            new("markers-oblique", Oblique, Carve, Aside),
            new("markers-inside", () => Phantoms.Markers(), _ => { }, Inside),
            new("cube-translucent", () => Phantoms.Cube(24, "cube"), r => r.TransferFunction = OpacityTransferFunction.Constant(0.05), Aside),
            new("cube-carved", () => Phantoms.Cube(24, "cube"), r => r.Stack.SetActive(new Vector3(0.008f, 0.008f, -0.008f), 0.009f), Aside),
            new("cube-no-anti-aliasing", () => Phantoms.Cube(24, "cube"), r =>
            {
                r.Stack.SetActive(new Vector3(0.008f, 0.008f, -0.008f), 0.009f);
                r.Quality.AntiAliasing = 0;
                r.Light.Direction = new Vector3(1, 1, 0.5f);
            }, Aside),
            new("head", Head, Show, v => new OrbitCamera(30, 15).RaysAround(v.Geometry, Pixels, Pixels)),
            new("head-carved", Head, OpenHead, DemoView),
            new("head-carved-smooth", Head, r =>
            {
                OpenHead(r);
                r.Quality.CutMode = CutMode.Smooth;
            }, DemoView),
        ];

        public override string ToString() => Name;

        static PictureRays Look(SegmentedVolume volume, VectorMm fromCentre, VectorMm up, double fov) => PictureRays.Perspective(
            volume.Geometry.CentreLps + fromCentre, volume.Geometry.CentreLps, up, fov, Pixels, Pixels);

        static PictureRays Front(SegmentedVolume volume) => Look(volume, new VectorMm(0, -80, 0), new VectorMm(0, 0, 1), 32);

        static PictureRays Aside(SegmentedVolume volume) => Look(volume, new VectorMm(45, -55, 40), new VectorMm(0, 0, 1), 32);

        static PictureRays Inside(SegmentedVolume volume) => Look(volume, new VectorMm(3, -8.5, 4), new VectorMm(0, 0, 1), 110);

        static PictureRays DemoView(SegmentedVolume volume) =>
            PictureRays.Perspective(new PointMm(608, 5, 155), new PointMm(0, 17, -7), new VectorMm(0, 0, 1), 23, Pixels, Pixels); // demo.camera.json

        /// <summary>Slices thicker than wide, turned and sheared.</summary>
        static SegmentedVolume Oblique()
        {
            VectorMm i = new(0.8, 0.3, 0.1), j = new(-0.3, 0.9, 0.2), k = new(0.1, -0.4, 1.9);
            return Phantoms.Markers(Phantoms.Centred(i, j, k, 46, 44, 22), 46, 44, 22);
        }

        /// <summary>One sphere that spares the body, one that cuts into it.</summary>
        static void Carve(CarvedVolumeRenderer renderer)
        {
            renderer.Stack.SetActive(new Vector3(0.006f, 0.006f, -0.006f), 0.014f);
            renderer.Stack.ToggleSegment(Phantoms.Body);
            renderer.Stack.FixActive();
            renderer.Stack.ResetMask();
            renderer.Stack.SetActive(new Vector3(0.004f, 0.004f, -0.004f), 0.005f);
        }

        static void Carve(CarvedVolumeRenderer renderer, RenderQuality quality)
        {
            Carve(renderer);
            renderer.Quality = quality;
        }

        static SegmentedVolume Head() =>
            SegmentedVolumeReader.Read(RepositoryFiles.Demo("Colin27.nrrd"), RepositoryFiles.Demo("Colin27.seg.nrrd"), default, null);

        static void Show(CarvedVolumeRenderer renderer) => renderer.TransferFunction = TransferFunctionFile.Read(RepositoryFiles.Demo("Colin27.vp"));

        static void OpenHead(CarvedVolumeRenderer renderer)
        {
            Show(renderer);
            renderer.Stack.Load(RepositoryFiles.Demo("demo.carving.json"));
        }
    }
}
