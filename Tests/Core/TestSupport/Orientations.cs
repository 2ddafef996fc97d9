using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>The 48 ways in which a grid's axes can run along the patient's.</summary>
    public static class Orientations
    {
        /// <summary>Their codes, "LPS" to "IAR"; the three letters say where i, j and k run to.</summary>
        public static IEnumerable<string> Codes()
        {
            string[] pairs = { "LR", "PA", "SI" };
            int[][] permutations = { new[] { 0, 1, 2 }, new[] { 0, 2, 1 }, new[] { 1, 0, 2 }, new[] { 1, 2, 0 }, new[] { 2, 0, 1 }, new[] { 2, 1, 0 } };
            foreach (int[] permutation in permutations)
                for (int signs = 0; signs < 8; signs++)
                    yield return new string(new[]
                    {
                        pairs[permutation[0]][signs & 1], pairs[permutation[1]][(signs >> 1) & 1], pairs[permutation[2]][signs >> 2],
                    });
        }

        /// <summary>The unit vector, LPS, that a letter stands for.</summary>
        public static VectorMm Direction(char letter)
        {
            switch (letter)
            {
                case 'L':
                    return new VectorMm(1, 0, 0);
                case 'R':
                    return new VectorMm(-1, 0, 0);
                case 'P':
                    return new VectorMm(0, 1, 0);
                case 'A':
                    return new VectorMm(0, -1, 0);
                case 'S':
                    return new VectorMm(0, 0, 1);
                default:
                    return new VectorMm(0, 0, -1);
            }
        }

        /// <summary>A grid of an orientation with spacings along the patient's axes (x, y, z), mm, and a place for voxel (0, 0, 0).</summary>
        public static Affine Grid(string code, VectorMm spacingMm, PointMm origin)
        {
            VectorMm Axis(int n)
            {
                VectorMm unit = Direction(code[n]);
                return new VectorMm(unit.X * spacingMm.X, unit.Y * spacingMm.Y, unit.Z * spacingMm.Z);
            }

            return Affine.FromColumns(Axis(0), Axis(1), Axis(2), origin);
        }
    }
}
