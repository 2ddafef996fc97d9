using System;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>What SobelNormals is held to, in double precision.</summary>
    static class SobelNormalsTwin
    {
        /// <summary>The 3x3x3 Sobel gradient in opacity per voxel; opacity outside the volume is 0.</summary>
        public static double[] Gradient(KernelGrid grid, Func<int, double> opacity, int i, int j, int k)
        {
            var gradient = new double[3];
            for (int dk = -1; dk <= 1; dk++)
                for (int dj = -1; dj <= 1; dj++)
                    for (int di = -1; di <= 1; di++)
                    {
                        int x = i + di, y = j + dj, z = k + dk;
                        bool inside = x >= 0 && y >= 0 && z >= 0 && x < grid.SizeI && y < grid.SizeJ && z < grid.SizeK;
                        double o = inside ? opacity(grid.Index(x, y, z)) : 0;
                        int wi = 2 - Math.Abs(di), wj = 2 - Math.Abs(dj), wk = 2 - Math.Abs(dk);
                        gradient[0] += di * wj * wk * o / 32;
                        gradient[1] += dj * wi * wk * o / 32;
                        gradient[2] += dk * wi * wj * o / 32;
                    }
            return gradient;
        }

        /// <summary>The unit normal of an index-space gradient: against the gradient in millimetres.</summary>
        public static double[] Normal(KernelGrid grid, double[] gradient)
        {
            var physical = new double[3];
            for (int axis = 0; axis < 3; axis++)
                for (int row = 0; row < 3; row++)
                    physical[axis] -= grid.MmToIndex[row, axis] * gradient[row];
            return OctahedralTwin.Normalized(physical);
        }

        public static double Length(double[] v) => Math.Sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
