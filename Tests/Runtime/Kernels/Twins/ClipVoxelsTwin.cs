using System;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>What ClipVoxels is held to: Eq. 1 voxel by voxel and sphere by sphere, without bricks, culling or tables of bits.</summary>
    static class ClipVoxelsTwin
    {
        /// <summary>Eq. 1, in the arithmetic that the definition prescribes: float, x then y then z, one rounding per operation.</summary>
        public static bool IsClipped(CarveScene scene, int i, int j, int k)
        {
            float[] p = scene.Grid.Position(i, j, k);
            int segment = scene.Labels[scene.Grid.Index(i, j, k)];
            foreach (CarveScene.Sphere sphere in scene.Spheres)
            {
                float dx = (float)(p[0] - sphere.X), dy = (float)(p[1] - sphere.Y), dz = (float)(p[2] - sphere.Z);
                float xx = (float)(dx * dx), yy = (float)(dy * dy), zz = (float)(dz * dz);
                float squared = (float)((float)(xx + yy) + zz);
                if (sphere.Clips[segment] && sphere.Radius > 0 && squared <= (float)(sphere.Radius * sphere.Radius))
                    return true;
            }
            return false;
        }

        /// <summary>Opacity of a voxel, 0..1, before it is stored.</summary>
        public static double Opacity(CarveScene scene, int i, int j, int k)
        {
            int voxel = scene.Grid.Index(i, j, k);
            double place = Math.Min(1, Math.Max(0, scene.Intensities[voxel] * (double)scene.LookupScale + scene.LookupOffset)) * (CarveScene.LookupSize - 1);
            int entry = Math.Min((int)place, CarveScene.LookupSize - 2);
            double transfer = scene.Lookup[entry] + ((double)scene.Lookup[entry + 1] - scene.Lookup[entry]) * (place - entry);
            double coverage = scene.SmoothCut ? SmoothCoverage(scene, i, j, k) : IsClipped(scene, i, j, k) ? 1 : 0;
            return transfer * scene.SegmentOpacities[scene.Labels[voxel]] * (1 - coverage);
        }

        static double SmoothCoverage(CarveScene scene, int i, int j, int k)
        {
            float[,] m = scene.Grid.IndexToMm;
            double[] p = scene.Grid.PositionOf(i, j, k);
            int segment = scene.Labels[scene.Grid.Index(i, j, k)];
            double most = 0;
            foreach (CarveScene.Sphere sphere in scene.Spheres)
            {
                if (!sphere.Clips[segment] || !(sphere.Radius > 0))
                    continue;
                double dx = p[0] - sphere.X, dy = p[1] - sphere.Y, dz = p[2] - sphere.Z;
                double distance = Math.Sqrt(dx * dx + dy * dy + dz * dz);
                double width = scene.Grid.ReferenceMm;
                if (distance > 1e-6 * width)
                {
                    width = 0;
                    for (int column = 0; column < 3; column++)
                        width += Math.Abs(dx * m[0, column] + dy * m[1, column] + dz * m[2, column]) / distance;
                }
                most = Math.Max(most, Math.Min(1, 0.5 + (sphere.Radius - distance) / width));
            }
            return most;
        }
    }
}
