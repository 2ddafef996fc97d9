using System;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>What AntiAlias is held to: three-dimensional FXAA over 3x3x3 as its header gives it, in double precision.</summary>
    sealed class AntiAliasTwin
    {
        readonly KernelGrid grid;
        readonly byte[] codes;

        public AntiAliasTwin(KernelGrid grid, byte[] codes)
        {
            this.grid = grid;
            this.codes = codes;
        }

        public double ThresholdAbsolute { get; set; } = 0.0625;

        public double ThresholdRelative { get; set; } = 0.125;

        public double GradientMinimum { get; set; } = 0.06;

        public double Strength { get; set; } = 1;

        /// <summary>Opacity of a voxel, 0..1, before it is stored.</summary>
        public double Opacity(int i, int j, int k)
        {
            double centre = At(i, j, k), low = 1, high = 0, mean = 0, gx = 0, gy = 0, gz = 0;
            ForNeighbours((di, dj, dk) =>
            {
                double o = At(i + di, j + dj, k + dk);
                low = Math.Min(low, o);
                high = Math.Max(high, o);
                mean += o / 27;
                gx += di * (2 - Math.Abs(dj)) * (2 - Math.Abs(dk)) * o;
                gy += dj * (2 - Math.Abs(di)) * (2 - Math.Abs(dk)) * o;
                gz += dk * (2 - Math.Abs(di)) * (2 - Math.Abs(dj)) * o;
            });
            double size = Math.Sqrt(gx * gx + gy * gy + gz * gz) / 32;
            bool isFlat = high == low || high - low < Math.Max(ThresholdAbsolute, ThresholdRelative * high) * 0.99999;
            if (isFlat || Strength == 0 || size < Math.Max(GradientMinimum, 0.5 / (255 * 32)))
                return centre;
            double sum = centre, weights = 1;
            ForNeighbours((di, dj, dk) =>
            {
                int squared = di * di + dj * dj + dk * dk;
                if (squared == 0)
                    return;
                double across = (gx * di + gy * dj + gz * dk) / (32 * size);
                double closeness = Math.Max(0, 1 - across * across / squared / 0.33);
                double weight = closeness * closeness * Math.Sqrt(squared);
                sum += weight * At(i + di, j + dj, k + dk);
                weights += weight;
            });
            double change = sum / weights - centre, filled = (mean - low) / (high - low);
            double kept = Math.Min(1, Math.Max(0, ((change < 0 ? filled : 1 - filled) - 0.46) / 0.13));
            return centre + Strength * kept * change;
        }

        double At(int i, int j, int k) => codes[grid.Index(Clamp(i, grid.SizeI), Clamp(j, grid.SizeJ), Clamp(k, grid.SizeK))] / 255.0;

        static int Clamp(int index, int size) => Math.Min(Math.Max(index, 0), size - 1);

        static void ForNeighbours(Action<int, int, int> action)
        {
            for (int dk = -1; dk <= 1; dk++)
                for (int dj = -1; dj <= 1; dj++)
                    for (int di = -1; di <= 1; di++)
                        action(di, dj, dk);
        }
    }
}
