using System;
using System.Linq;
using AnatomyCarve.Picking;
using AnatomyCarve.Tests.Kernels;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests
{
    /// <summary>Random small volumes, of any spacing, rotation and shear, and rays through them.</summary>
    static class RandomMatter
    {
        /// <summary>Soft blobs of intensities up to 1000 in a noise of up to 100, and blocky random segments.</summary>
        public static SegmentedVolume Volume(Random random, int segments, int smallest = 6, int largest = 36)
        {
            KernelGrid grid = KernelGrid.Random(random, smallest, largest);
            VectorMm Column(int c) => new VectorMm(grid.IndexToMm[0, c], grid.IndexToMm[1, c], grid.IndexToMm[2, c]);
            var origin = new PointMm(300 * random.NextDouble() - 150, 300 * random.NextDouble() - 150, 300 * random.NextDouble() - 150);
            var geometry = new VolumeGeometry(grid.SizeI, grid.SizeJ, grid.SizeK, Affine.FromColumns(Column(0), Column(1), Column(2), origin));
            byte[] balls = OpacityFields.Balls(grid, random);
            int block = 1 + random.Next(6), salt = random.Next();
            var codes = new ushort[grid.VoxelCount];
            var indices = new ushort[grid.VoxelCount];
            grid.ForEach((i, j, k) =>
            {
                int v = grid.Index(i, j, k);
                codes[v] = (ushort)(Math.Max(random.Next(100), balls[v] * 1000 / 255 - random.Next(100)));
                indices[v] = (ushort)(new Random(salt + i / block + 100 * (j / block) + 10000 * (k / block)).Next(segments));
            });
            var table = new SegmentTable(Enumerable.Range(0, segments).Select(s => new Segment(s, s, "segment " + s, new SegmentColor(10, 20, 30))));
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, 1000), new LabelMap(geometry, indices, table));
        }

        /// <summary>Rays from anywhere around a volume, perspective or parallel.</summary>
        public static PictureRays Rays(VolumeGeometry geometry, Random random, int pixels)
        {
            VectorMm Direction()
            {
                double[] d = RayScene.RandomDirection(random);
                return new VectorMm(d[0], d[1], d[2]);
            }
            double radius = (geometry.IjkToLps.TransformPoint(new PointMm(-0.5, -0.5, -0.5)) - geometry.CentreLps).Length;
            PointMm eye = geometry.CentreLps + Direction() * (2.5 * radius);
            return random.Next(2) == 0
                ? PictureRays.Perspective(eye, geometry.CentreLps, Direction(), 40, pixels, pixels)
                : PictureRays.Orthographic(eye, geometry.CentreLps, Direction(), 1.6 * radius, pixels, pixels);
        }
    }
}
