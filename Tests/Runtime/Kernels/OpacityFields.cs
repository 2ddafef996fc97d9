using System;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>Opacity volumes that tests draw: 8-bit codes, i fastest.</summary>
    static class OpacityFields
    {
        /// <summary>Codes of every kind: noise, few values, smooth blobs with hard cuts, or thin lines; which one, the generator says.</summary>
        public static byte[] Random(KernelGrid grid, Random random)
        {
            switch (random.Next(4))
            {
                case 0:
                    return Fill(grid, (i, j, k) => random.Next(256));
                case 1:
                    int[] values = { 0, random.Next(256), 255 };
                    return Fill(grid, (i, j, k) => values[random.Next(3)]);
                case 2:
                    return Balls(grid, random);
                default:
                    byte[] codes = new byte[grid.VoxelCount];
                    int line = random.Next(grid.SizeJ), level = random.Next(grid.SizeK);
                    for (int i = 0; i < grid.SizeI; i++)
                        codes[grid.Index(i, line, level)] = 255;
                    return codes;
            }
        }

        /// <summary>Soft and hard balls of different opacity, some of them cut off.</summary>
        public static byte[] Balls(KernelGrid grid, Random random)
        {
            var codes = new byte[grid.VoxelCount];
            for (int ball = 0; ball < 4; ball++)
            {
                double x = random.NextDouble() * grid.SizeI, y = random.NextDouble() * grid.SizeJ, z = random.NextDouble() * grid.SizeK;
                double radius = 1 + random.NextDouble() * 0.4 * Math.Max(grid.SizeI, Math.Max(grid.SizeJ, grid.SizeK)), softness = random.Next(2) * 3 * random.NextDouble() + 0.01;
                int code = random.Next(40, 256), cut = random.Next(grid.SizeI + 1);
                grid.ForEach((i, j, k) =>
                {
                    double distance = Math.Sqrt((i - x) * (i - x) + (j - y) * (j - y) + (k - z) * (k - z));
                    double share = i < cut ? Math.Min(1, Math.Max(0, (radius - distance) / softness)) : 0;
                    codes[grid.Index(i, j, k)] = (byte)Math.Max(codes[grid.Index(i, j, k)], code * share);
                });
            }
            return codes;
        }

        public static byte[] Fill(KernelGrid grid, Func<int, int, int, int> code)
        {
            var codes = new byte[grid.VoxelCount];
            grid.ForEach((i, j, k) => codes[grid.Index(i, j, k)] = (byte)code(i, j, k));
            return codes;
        }
    }
}
