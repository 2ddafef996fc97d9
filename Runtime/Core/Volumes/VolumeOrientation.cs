using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>Names the anatomical direction that each axis of a grid runs to.</summary>
    static class VolumeOrientation
    {
        const string PositiveLetters = "LPS";
        const string NegativeLetters = "RAI";

        static readonly int[][] Permutations =
        {
            new[] { 0, 1, 2 }, new[] { 0, 2, 1 }, new[] { 1, 0, 2 }, new[] { 1, 2, 0 }, new[] { 2, 0, 1 }, new[] { 2, 1, 0 },
        };

        /// <summary>The three letters of the assignment of axes to patient axes that is closest over all.</summary>
        internal static string Code(Affine ijkToLps)
        {
            int[] best = null;
            double bestSum = double.NegativeInfinity;
            foreach (int[] permutation in Permutations)
            {
                double sum = 0;
                for (int axis = 0; axis < 3; axis++)
                    sum += Math.Abs(Component(ijkToLps.Column(axis).Normalized(), permutation[axis]));
                if (sum > bestSum)
                {
                    bestSum = sum;
                    best = permutation;
                }
            }

            var letters = new char[3];
            for (int axis = 0; axis < 3; axis++)
            {
                double along = Component(ijkToLps.Column(axis), best[axis]);
                letters[axis] = (along >= 0 ? PositiveLetters : NegativeLetters)[best[axis]];
            }

            return new string(letters);
        }

        static double Component(VectorMm vector, int index) => index == 0 ? vector.X : index == 1 ? vector.Y : vector.Z;
    }
}
