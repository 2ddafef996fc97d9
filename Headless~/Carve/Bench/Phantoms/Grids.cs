using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Phantoms
{
    /// <summary>Grids whose centre is the origin of LPS, and directions in them.</summary>
    static class Grids
    {
        /// <summary>A grid whose axes run along L, P and S.</summary>
        public static VolumeGeometry Centred(int sizeI, int sizeJ, int sizeK, double spacingI = 1, double spacingJ = 1, double spacingK = 1) =>
            new(sizeI, sizeJ, sizeK, Affine.FromColumns(
                new VectorMm(spacingI, 0, 0), new VectorMm(0, spacingJ, 0), new VectorMm(0, 0, spacingK),
                new PointMm(-0.5 * (sizeI - 1) * spacingI, -0.5 * (sizeJ - 1) * spacingJ, -0.5 * (sizeK - 1) * spacingK)));

        /// <summary>A unit vector, each as likely as any other.</summary>
        public static VectorMm RandomDirection(Random random)
        {
            var (z, angle) = (random.NextDouble() * 2 - 1, random.NextDouble() * 2 * Math.PI);
            var r = Math.Sqrt(1 - z * z);
            return new VectorMm(r * Math.Cos(angle), r * Math.Sin(angle), z);
        }

        /// <summary>Calls an action for every voxel, i fastest, with the voxel's number.</summary>
        public static void ForEach(VolumeGeometry grid, Action<int, int, int, int> action)
        {
            var voxel = 0;
            for (var k = 0; k < grid.SizeK; k++)
            {
                for (var j = 0; j < grid.SizeJ; j++)
                {
                    for (var i = 0; i < grid.SizeI; i++) action(i, j, k, voxel++);
                }
            }
        }
    }
}
