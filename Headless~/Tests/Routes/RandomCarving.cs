using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Tests.Routes
{
    /// <summary>A volume and what is done to it, drawn from a seed: any size to 40 voxels, spacing, rotation and shear; soft balls of intensity, random
    /// segments, transfer function, qualities, spheres, masks and rays. The same seed gives the same, whatever runs it.</summary>
    sealed class RandomCarving
    {
        const int Pixels = 64;
        const int Balls = 12;

        readonly Random random;
        readonly VolumeGeometry geometry;

        public RandomCarving(int seed)
        {
            random = new Random(seed);
            geometry = RandomGeometry();
            int segments = random.Next(4) == 0 ? 300 : 2 + random.Next(30);
            Volume = new SegmentedVolume(new IntensityVolume(geometry, Codes(), 0, 1, 1000), new LabelMap(geometry, Indices(segments), Table(segments)));
            TransferFunction = new OpacityTransferFunction(
            [
                new TransferPoint(0, 0), new TransferPoint(100 + 200 * random.NextDouble(), 0.3 * random.NextDouble()),
                new TransferPoint(400 + 200 * random.NextDouble(), random.NextDouble()), new TransferPoint(1000, random.NextDouble()),
            ]);
        }

        public SegmentedVolume Volume { get; }

        public OpacityTransferFunction TransferFunction { get; }

        /// <summary>Anything but the cut mode.</summary>
        public RenderQuality NextQuality(CutMode cut) => new()
        {
            CutMode = cut,
            Step = 0.3f + (float)random.NextDouble(),
            AntiAliasing = 0.25f * (1 + random.Next(4)),
            Filter = (OpacityFilter)random.Next(2),
        };

        /// <summary>Places the active sphere anew with a random mask; now and then fixes it first, or takes a step back.</summary>
        public void Edit(CarvingStack carving)
        {
            double Along(int size) => (size + 4) * random.NextDouble() - 2.5;
            PointMm centre = geometry.IjkToLps.TransformPoint(new PointMm(Along(geometry.SizeI), Along(geometry.SizeJ), Along(geometry.SizeK)));
            if (random.Next(2) == 0 && carving.Active is not null)
                carving.FixActive();
            carving.SetActive(centre, HalfDiagonal * (0.2 + 0.6 * random.NextDouble()));
            double share = random.NextDouble();
            carving.SetActiveMask(SegmentMask.FromIndices(carving.SegmentCount, Enumerable.Range(0, carving.SegmentCount).Where(_ => random.NextDouble() < share)));
            if (random.Next(6) == 0)
                carving.Undo();
        }

        public PictureRays NextRays()
        {
            PointMm eye = geometry.CentreLps + RandomDirection() * (2.5 * HalfDiagonal);
            return random.Next(2) == 0
                ? PictureRays.Perspective(eye, geometry.CentreLps, RandomDirection(), 40, Pixels, Pixels)
                : PictureRays.Orthographic(eye, geometry.CentreLps, RandomDirection(), 1.6 * HalfDiagonal, Pixels, Pixels);
        }

        double HalfDiagonal => (geometry.IjkToLps.TransformPoint(new PointMm(-0.5, -0.5, -0.5)) - geometry.CentreLps).Length;

        VolumeGeometry RandomGeometry()
        {
            VectorMm i = RandomDirection(), j = VectorMm.Cross(i, RandomDirection()).Normalized(), k = VectorMm.Cross(i, j);
            double Spacing() => 0.3 * Math.Pow(10, random.NextDouble());
            var shear = i * (0.3 * random.NextDouble());
            var origin = new PointMm(300 * random.NextDouble() - 150, 300 * random.NextDouble() - 150, 300 * random.NextDouble() - 150);
            return new VolumeGeometry(6 + random.Next(35), 6 + random.Next(35), 6 + random.Next(35),
                Affine.FromColumns(i * Spacing(), (j + shear) * Spacing(), k * Spacing(), origin));
        }

        /// <summary>Up to 1000 in the middle of balls, noise of up to 100 elsewhere.</summary>
        ushort[] Codes()
        {
            var balls = Enumerable.Range(0, Balls).Select(_ => (I: geometry.SizeI * random.NextDouble(), J: geometry.SizeJ * random.NextDouble(),
                K: geometry.SizeK * random.NextDouble(), Radius: 2 + 8 * random.NextDouble())).ToArray();
            return EachVoxel().Select(v =>
            {
                double inside = balls.Max(b => b.Radius - Math.Sqrt((v.I - b.I) * (v.I - b.I) + (v.J - b.J) * (v.J - b.J) + (v.K - b.K) * (v.K - b.K)));
                return (ushort)Math.Clamp(1000 * (inside + 1) / 2 - random.Next(100), random.Next(100), 1000);
            }).ToArray();
        }

        /// <summary>Blocks of random segments.</summary>
        ushort[] Indices(int segments)
        {
            int block = 1 + random.Next(6), salt = random.Next();
            return EachVoxel().Select(v => (ushort)new Random(salt + v.I / block + 100 * (v.J / block) + 10000 * (v.K / block)).Next(segments)).ToArray();
        }

        SegmentTable Table(int segments)
        {
            byte Part() => (byte)random.Next(256);
            var table = new SegmentTable(Enumerable.Range(0, segments).Select(s => new Segment(s, s, "segment " + s, new SegmentColor(Part(), Part(), Part()))));
            for (int s = 0; s < segments; s++)
                table = random.Next(3) == 0 ? table.WithOpacity(s, (float)random.NextDouble()) : table;
            return table;
        }

        IEnumerable<(int I, int J, int K)> EachVoxel()
        {
            for (int k = 0; k < geometry.SizeK; k++)
                for (int j = 0; j < geometry.SizeJ; j++)
                    for (int i = 0; i < geometry.SizeI; i++)
                        yield return (i, j, k);
        }

        VectorMm RandomDirection()
        {
            while (true)
            {
                var v = new VectorMm(2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1);
                if (v.Length is > 0.1 and < 1)
                    return v.Normalized();
            }
        }
    }
}
