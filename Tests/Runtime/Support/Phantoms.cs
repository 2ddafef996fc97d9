using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests
{
    /// <summary>
    /// Small volumes made in code. Their anatomy is defined in the patient's space, so that the same patient can be stored in any orientation.
    /// </summary>
    static class Phantoms
    {
        /// <summary>Segments of <see cref="Markers"/>: one ball on each side of the patient, and the body in the middle.</summary>
        public const int Right = 1, Left = 2, Anterior = 3, Posterior = 4, Superior = 5, Inferior = 6, Body = 7;

        /// <summary>Intensity inside; outside it is 0.</summary>
        public const int Matter = 1000;

        const double MarkerDistanceMm = 14;
        const double MarkerRadiusMm = 4;
        const double BodyRadiusMm = 7;

        static readonly string[] Names = { "Right", "Left", "Anterior", "Posterior", "Superior", "Inferior", "Body" };

        /// <summary>Where a marker's centre lies, relative to the volume's centre, in LPS millimetres.</summary>
        public static VectorMm MarkerCentre(int segment)
        {
            switch (segment)
            {
                case Right: return new VectorMm(-MarkerDistanceMm, 0, 0);
                case Left: return new VectorMm(MarkerDistanceMm, 0, 0);
                case Anterior: return new VectorMm(0, -MarkerDistanceMm, 0);
                case Posterior: return new VectorMm(0, MarkerDistanceMm, 0);
                case Superior: return new VectorMm(0, 0, MarkerDistanceMm);
                case Inferior: return new VectorMm(0, 0, -MarkerDistanceMm);
                default: return default;
            }
        }

        /// <summary>A body with six markers around it, 40 mm wide.</summary>
        /// <param name="size">Voxels along each axis.</param>
        public static SegmentedVolume Markers(int size = 40) =>
            Markers(
                Centred(new VectorMm(40.0 / size, 0, 0), new VectorMm(0, 40.0 / size, 0), new VectorMm(0, 0, 40.0 / size), size, size, size), size, size, size);

        /// <summary>A body with six markers around it, on a grid of one's own.</summary>
        public static SegmentedVolume Markers(Affine ijkToLps, int sizeI, int sizeJ, int sizeK)
        {
            var geometry = new VolumeGeometry(sizeI, sizeJ, sizeK, ijkToLps);
            return Fill(geometry, Names, SegmentOf);
        }

        /// <summary>A cube of one segment that fills the volume but for a margin of two voxels.</summary>
        public static SegmentedVolume Cube(int size, string name)
        {
            var x = new VectorMm(1, 0, 0);
            var geometry = new VolumeGeometry(size, size, size, Centred(x, new VectorMm(0, 1, 0), new VectorMm(0, 0, 1), size, size, size));
            double half = size * 0.5 - 2;
            return Fill(geometry, new[] { name }, p => Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))) < half ? 1 : 0);
        }

        /// <summary>A grid with these voxel steps whose centre lies at (10, -20, 30) mm, so that nothing works by accident of being at the origin.</summary>
        public static Affine Centred(VectorMm stepI, VectorMm stepJ, VectorMm stepK, int sizeI, int sizeJ, int sizeK)
        {
            PointMm centre = new PointMm(10, -20, 30);
            return Affine.FromColumns(stepI, stepJ, stepK, centre - (stepI * ((sizeI - 1) * 0.5) + stepJ * ((sizeJ - 1) * 0.5) + stepK * ((sizeK - 1) * 0.5)));
        }

        /// <summary>The 48 ways in which an image's axes can lie along the patient's.</summary>
        public static IEnumerable<VectorMm[]> Orientations()
        {
            int[][] orders = { new[] { 0, 1, 2 }, new[] { 0, 2, 1 }, new[] { 1, 0, 2 }, new[] { 1, 2, 0 }, new[] { 2, 0, 1 }, new[] { 2, 1, 0 } };
            foreach (int[] order in orders)
                for (int signs = 0; signs < 8; signs++)
                {
                    var axes = new VectorMm[3];
                    for (int a = 0; a < 3; a++)
                    {
                        double sign = (signs >> a & 1) == 0 ? 1 : -1;
                        axes[a] = new VectorMm(order[a] == 0 ? sign : 0, order[a] == 1 ? sign : 0, order[a] == 2 ? sign : 0);
                    }
                    yield return axes;
                }
        }

        static int SegmentOf(VectorMm p)
        {
            for (int segment = Right; segment <= Inferior; segment++)
                if ((p - MarkerCentre(segment)).Length <= MarkerRadiusMm)
                    return segment;
            return p.Length <= BodyRadiusMm ? Body : 0;
        }

        static SegmentedVolume Fill(VolumeGeometry geometry, string[] names, Func<VectorMm, int> segmentOf)
        {
            var codes = new ushort[geometry.VoxelCount];
            var indices = new ushort[geometry.VoxelCount];
            int v = 0;
            for (int k = 0; k < geometry.SizeK; k++)
                for (int j = 0; j < geometry.SizeJ; j++)
                    for (int i = 0; i < geometry.SizeI; i++, v++)
                    {
                        indices[v] = (ushort)segmentOf(geometry.IjkToLps.TransformPoint(new PointMm(i, j, k)) - geometry.CentreLps);
                        codes[v] = (ushort)(indices[v] == 0 ? 0 : Matter);
                    }
            var segments = new List<Segment> { new Segment(0, 0, "Unlabelled", new SegmentColor(128, 128, 128)) };
            for (int s = 0; s < names.Length; s++)
            {
                var color = new SegmentColor((byte)(60 + 25 * s), (byte)(220 - 25 * s), (byte)(40 * s % 200 + 30));
                segments.Add(new Segment(s + 1, 10 * (s + 1), names[s], color));
            }
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, Matter), new LabelMap(geometry, indices, new SegmentTable(segments)));
        }
    }
}
