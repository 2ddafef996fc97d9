using System;
using System.Linq;
using System.Text;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>Names of the patient's directions: R and L, A and P, S and I.</summary>
    static class OrientationLetters
    {
        /// <summary>A direction that leans more than this towards an axis (the sine of 22.5 degrees) has that axis's letter.</summary>
        const double Leaning = 0.3826834;

        const string Positive = "LPS", Negative = "RAI";

        /// <summary>
        /// The letters of a direction, those of the axis that it is nearest to first: "L", or "LA" for one that points between left and front.
        /// </summary>
        /// <param name="directionLps">Any length; empty for none.</param>
        public static string Of(VectorMm directionLps)
        {
            VectorMm unit = directionLps.Normalized();
            double[] along = { unit.X, unit.Y, unit.Z };
            var letters = new StringBuilder(3);
            foreach (int axis in Enumerable.Range(0, 3).Where(a => Math.Abs(along[a]) > Leaning).OrderByDescending(a => Math.Abs(along[a])))
                letters.Append((along[axis] > 0 ? Positive : Negative)[axis]);
            return letters.ToString();
        }
    }
}
