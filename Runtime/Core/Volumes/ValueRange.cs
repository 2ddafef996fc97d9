using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>The range of an image's finite values, and whether they are all whole numbers.</summary>
    sealed class ValueRange
    {
        const double LargestCode = ushort.MaxValue;

        double minimum = double.PositiveInfinity;
        double maximum = double.NegativeInfinity;
        bool whole = true;

        /// <summary>The smallest finite value; 0 when there is none.</summary>
        internal double Minimum => minimum <= maximum ? minimum : 0;

        /// <summary>The largest finite value; 0 when there is none.</summary>
        internal double Maximum => minimum <= maximum ? maximum : 0;

        /// <summary>Takes values into account.</summary>
        internal void Include(double[] values, int count)
        {
            for (int n = 0; n < count; n++)
            {
                double value = values[n];
                if (!double.IsFinite(value))
                    continue;
                minimum = value < minimum ? value : minimum;
                maximum = value > maximum ? value : maximum;
                whole = whole && Math.Floor(value) == value;
            }
        }

        /// <summary>The step between codes: 1 for whole numbers, the stored values' own step where the range permits; else a 65,535th of it.</summary>
        /// <param name="storedStep">What one step of the stored values means; 0 for values that have no steps.</param>
        internal double CodeStep(double storedStep)
        {
            double span = Maximum - Minimum;
            if (whole && span <= LargestCode)
                return 1;
            bool keepsStored = storedStep > 0 && span / storedStep <= LargestCode + 0.5;
            return keepsStored ? storedStep : Math.Max(span / LargestCode, double.Epsilon);
        }
    }
}
