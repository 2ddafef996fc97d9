using System;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>A volume's grid as the kernels see it: its size, and the matrix M from voxel steps to centred millimetres.</summary>
    sealed class KernelGrid
    {
        /// <param name="indexToMm">M, 3x3 [row, column], mm per voxel; rounded to float.</param>
        public KernelGrid(int sizeI, int sizeJ, int sizeK, double[,] indexToMm)
        {
            SizeI = sizeI;
            SizeJ = sizeJ;
            SizeK = sizeK;
            double smallest = double.PositiveInfinity;
            for (int column = 0; column < 3; column++)
            {
                double squared = 0;
                for (int row = 0; row < 3; row++)
                {
                    IndexToMm[row, column] = (float)indexToMm[row, column];
                    squared += indexToMm[row, column] * indexToMm[row, column];
                }
                smallest = Math.Min(smallest, Math.Sqrt(squared));
            }
            ReferenceMm = (float)smallest;
            Invert();
        }

        public int SizeI { get; }

        public int SizeJ { get; }

        public int SizeK { get; }

        public int VoxelCount => SizeI * SizeJ * SizeK;

        public float[,] IndexToMm { get; } = new float[3, 3];

        public double[,] MmToIndex { get; } = new double[3, 3];

        /// <summary>The smallest spacing, mm.</summary>
        public float ReferenceMm { get; }

        public int BricksI => (SizeI + 7) / 8;

        public int BricksJ => (SizeJ + 7) / 8;

        public int BricksK => (SizeK + 7) / 8;

        public static KernelGrid Aligned(int sizeI, int sizeJ, int sizeK, double spacingI = 1, double spacingJ = 1, double spacingK = 1) =>
            new KernelGrid(sizeI, sizeJ, sizeK, new[,] { { spacingI, 0, 0 }, { 0, spacingJ, 0 }, { 0, 0, spacingK } });

        /// <summary>Random size up to a limit, spacings 0.3 to 3 mm, any rotation, some shear.</summary>
        public static KernelGrid Random(Random random, int smallest, int largest)
        {
            double[,] m = RandomRotation(random);
            for (int column = 0; column < 3; column++)
            {
                double spacing = 0.3 * Math.Pow(10, random.NextDouble());
                for (int row = 0; row < 3; row++)
                    m[row, column] *= spacing;
            }
            double shear = random.Next(2) * 0.2 * random.NextDouble();
            for (int row = 0; row < 3; row++)
                m[row, 2] += shear * m[row, 0];
            return new KernelGrid(
                random.Next(smallest, largest + 1), random.Next(smallest, largest + 1), random.Next(smallest, largest + 1), m);
        }

        public int Index(int i, int j, int k) => i + SizeI * (j + SizeJ * k);

        /// <summary>A voxel's centre in centred mm, in the kernels' own arithmetic: float, one rounding per operation.</summary>
        public float[] Position(int i, int j, int k)
        {
            float fi = (float)(i - (float)((SizeI - 1) * 0.5)), fj = (float)(j - (float)((SizeJ - 1) * 0.5)), fk = (float)(k - (float)((SizeK - 1) * 0.5));
            var position = new float[3];
            for (int row = 0; row < 3; row++)
            {
                float x = (float)(IndexToMm[row, 0] * fi), y = (float)(IndexToMm[row, 1] * fj), z = (float)(IndexToMm[row, 2] * fk);
                position[row] = (float)((float)(x + y) + z);
            }
            return position;
        }

        /// <summary>Centred mm of continuous voxel coordinates.</summary>
        public double[] PositionOf(double i, double j, double k)
        {
            double fi = i - (SizeI - 1) * 0.5, fj = j - (SizeJ - 1) * 0.5, fk = k - (SizeK - 1) * 0.5;
            return new[]
            {
                IndexToMm[0, 0] * fi + IndexToMm[0, 1] * fj + IndexToMm[0, 2] * fk,
                IndexToMm[1, 0] * fi + IndexToMm[1, 1] * fj + IndexToMm[1, 2] * fk,
                IndexToMm[2, 0] * fi + IndexToMm[2, 1] * fj + IndexToMm[2, 2] * fk,
            };
        }

        /// <summary>Brick coordinates in the packing of <c>_Bricks</c>, i fastest.</summary>
        public uint[] AllBricks()
        {
            var bricks = new uint[BricksI * BricksJ * BricksK];
            int next = 0;
            for (int z = 0; z < BricksK; z++)
                for (int y = 0; y < BricksJ; y++)
                    for (int x = 0; x < BricksI; x++)
                        bricks[next++] = (uint)x | (uint)y << 10 | (uint)z << 20;
            return bricks;
        }

        /// <summary>Calls an action for every voxel, i fastest.</summary>
        public void ForEach(Action<int, int, int> action)
        {
            for (int k = 0; k < SizeK; k++)
                for (int j = 0; j < SizeJ; j++)
                    for (int i = 0; i < SizeI; i++)
                        action(i, j, k);
        }

        public override string ToString() => FormattableString.Invariant($"{SizeI} x {SizeJ} x {SizeK}, reference {ReferenceMm} mm");

        static double[,] RandomRotation(Random random)
        {
            double x, y, z, w, squared;
            do
            {
                x = random.NextDouble() * 2 - 1;
                y = random.NextDouble() * 2 - 1;
                z = random.NextDouble() * 2 - 1;
                w = random.NextDouble() * 2 - 1;
                squared = x * x + y * y + z * z + w * w;
            }
            while (squared < 0.01 || squared > 1);
            double s = 2 / squared;
            return new[,]
            {
                { 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w) },
                { s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w) },
                { s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y) },
            };
        }

        void Invert()
        {
            float[,] m = IndexToMm;
            for (int row = 0; row < 3; row++)
                for (int column = 0; column < 3; column++)
                {
                    int r1 = (column + 1) % 3, r2 = (column + 2) % 3, c1 = (row + 1) % 3, c2 = (row + 2) % 3;
                    MmToIndex[row, column] = (double)m[r1, c1] * m[r2, c2] - (double)m[r1, c2] * m[r2, c1];
                }
            double determinant = m[0, 0] * MmToIndex[0, 0] + m[0, 1] * MmToIndex[1, 0] + m[0, 2] * MmToIndex[2, 0];
            for (int row = 0; row < 3; row++)
                for (int column = 0; column < 3; column++)
                    MmToIndex[row, column] /= determinant;
        }
    }
}
