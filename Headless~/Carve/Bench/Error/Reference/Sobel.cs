using System;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>The three-dimensional Sobel operator: [1 2 1] x [1 2 1] x [-1 0 1] / 32.</summary>
    static class Sobel
    {
        /// <summary>The gradient per voxel of 27 values, i fastest.</summary>
        public static (double X, double Y, double Z) Gradient(ReadOnlySpan<double> o) => (Along(o, 1, 3, 9), Along(o, 3, 9, 1), Along(o, 9, 1, 3));

        static double Along(ReadOnlySpan<double> o, int along, int u, int v)
        {
            double sum = 0;
            for (var n = 0; n < 9; n++)
            {
                int a = n % 3, b = n / 3, low = a * u + b * v;
                sum += (a == 1 ? 2 : 1) * (b == 1 ? 2 : 1) * (o[low + 2 * along] - o[low]);
            }

            return sum / 32;
        }
    }
}
