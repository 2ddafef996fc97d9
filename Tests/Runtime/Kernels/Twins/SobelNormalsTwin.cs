using System;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>What SobelNormals makes of opacities, in double precision and without passes.</summary>
    static class SobelNormalsTwin
    {
        const int Reach = 3;

        /// <summary>The taps as the kernel's header gives them: x * exp(-x^2 / (2 * 2^2)) and exp(-x^2 / (2 * 1.6^2)), in whole numbers.</summary>
        static readonly double[] Derivative = { 0, 29, 40, 32 }, Smoothing = { 63, 52, 29, 11 };

        /// <summary>The 7x7x7 Sobel gradient in opacity per voxel; opacity outside the volume is 0.</summary>
        public static double[] Gradient(KernelGrid grid, Func<int, double> opacity, int i, int j, int k)
        {
            var gradient = new double[3];
            double slope = 0, sum = 0;
            for (int x = -Reach; x <= Reach; x++)
            {
                slope += x * D(x);
                sum += S(x);
            }
            for (int dk = -Reach; dk <= Reach; dk++)
                for (int dj = -Reach; dj <= Reach; dj++)
                    for (int di = -Reach; di <= Reach; di++)
                    {
                        int x = i + di, y = j + dj, z = k + dk;
                        if (x < 0 || y < 0 || z < 0 || x >= grid.SizeI || y >= grid.SizeJ || z >= grid.SizeK)
                            continue;
                        double o = opacity(grid.Index(x, y, z)) / (slope * sum * sum);
                        gradient[0] += D(di) * S(dj) * S(dk) * o;
                        gradient[1] += D(dj) * S(di) * S(dk) * o;
                        gradient[2] += D(dk) * S(di) * S(dj) * o;
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

        static double D(int x) => Math.Sign(x) * Derivative[Math.Abs(x)];

        static double S(int x) => Smoothing[Math.Abs(x)];
    }
}
