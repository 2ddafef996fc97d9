using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Scenes
{
    /// <summary>A scene of the file with its volume.</summary>
    sealed class BenchScene
    {
        readonly SceneText text;

        public BenchScene(string name, SceneText text, SegmentedVolume volume)
        {
            Name = name;
            this.text = text;
            Volume = volume;
            TransferFunction = text.TransferFunction == null ? null : OpacityTransferFunction.Parse(text.TransferFunction);
            if (text.Shown is { } shown) Segments = Showing(shown);
            Spheres = [.. Crowd(), .. text.Spheres.Select(Sphere)];
            Width = text.Size[0];
            Height = text.Size[1];
        }

        public string Name { get; }

        public SegmentedVolume Volume { get; }

        public int Width { get; }

        public int Height { get; }

        /// <summary>Null = the volume's own.</summary>
        public OpacityTransferFunction TransferFunction { get; }

        /// <summary>The segments with those hidden that the scene does not show; null = all are shown.</summary>
        public SegmentTable Segments { get; }

        /// <summary>The spheres in order; the last one is the active one.</summary>
        public IReadOnlyList<ClipSphere> Spheres { get; }

        /// <summary>How far the active sphere moves.</summary>
        public VectorMm Move => text.MoveMm is { } move
            ? new VectorMm(move[0], move[1], move[2])
            : throw new CommandException($"scene \"{Name}\": nothing moves in it.");

        /// <summary>The segment that is toggled.</summary>
        public int Toggled => text.Toggled ?? throw new CommandException($"scene \"{Name}\": no segment is toggled in it.");

        /// <summary>The rays of its picture.</summary>
        public PictureRays Rays() => Rays(Width, Height);

        /// <summary>The rays of its picture in another size.</summary>
        public PictureRays Rays(int width, int height) => Camera().RaysAround(Volume.Geometry, width, height);

        public OrbitCamera Camera() => new(text.Camera[0], text.Camera[1], text.Camera[2]);

        /// <summary>The camera, turned.</summary>
        public OrbitCamera Camera(double azimuth, double elevation) =>
            new(text.Camera[0] + azimuth, Math.Clamp(text.Camera[1] + elevation, -90, 90), text.Camera[2]);

        SegmentTable Showing(int[] shown)
        {
            var changes = Volume.Segments.Where(segment => !shown.Contains(segment.Index)).Select(segment => (segment.Label, segment.Color, 0f));
            return Volume.Segments.With(changes);
        }

        ClipSphere Sphere(SphereText sphere)
        {
            var mask = SegmentMask.All(Volume.Segments.Count);
            foreach (var segment in sphere.Spared.Where(segment => segment < Volume.Segments.Count)) mask = mask.With(segment, false);
            return new ClipSphere(Volume.Geometry.CentreLps + new VectorMm(sphere.CentreMm[0], sphere.CentreMm[1], sphere.CentreMm[2]), sphere.RadiusMm, mask);
        }

        // The places are a low-discrepancy sequence (the plastic number's powers), so any part of it is spread evenly.
        IEnumerable<ClipSphere> Crowd()
        {
            const double Plastic = 1.22074408460575947536;
            var geometry = Volume.Geometry;
            var mask = SegmentMask.All(Volume.Segments.Count);
            var made = 0;
            for (var n = 1; made < text.Crowd; n++)
            {
                double Part(int power) => n / Math.Pow(Plastic, power) % 1;
                var place = geometry.IjkToLps.TransformPoint(new PointMm(
                    (geometry.SizeI - 1) * Part(1), (geometry.SizeJ - 1) * Part(2), (geometry.SizeK - 1) * Part(3)));
                if (text.CrowdAwayMm is { } away && IsNear(place, away)) continue;
                made++;
                yield return new ClipSphere(place, text.CrowdRadiusMm, mask);
            }
        }

        bool IsNear(PointMm place, double away)
        {
            var last = Sphere(text.Spheres[^1]);
            return (place - last.CentreLps).Length < last.RadiusMm + text.CrowdRadiusMm + away;
        }
    }
}
