using System;
using System.Collections.Generic;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Where most of an image's finite values lie, from a regular sample of them. It tells the scan from what does not belong to it: padding of
    /// -2^31 around a CT, a few values of 1e9 from a broken filter.
    /// </summary>
    sealed class TypicalRange
    {
        const int MostSamples = 1 << 16;
        const double LowShare = 0.05;
        const double HighShare = 0.95;

        readonly List<double> samples = new List<double>();
        readonly long stride;
        long next;

        /// <param name="valueCount">How many values will come.</param>
        internal TypicalRange(long valueCount) => stride = Math.Max(1, valueCount / MostSamples);

        /// <summary>Takes a block of values into account.</summary>
        /// <param name="values">The block.</param>
        /// <param name="start">Where it starts among all values.</param>
        /// <param name="count">How many of the array's values belong to it.</param>
        internal void Include(double[] values, long start, int count)
        {
            for (; next < start + count; next += stride)
            {
                double value = values[next - start];
                if (double.IsFinite(value))
                    samples.Add(value);
            }
        }

        /// <summary>The 5th and the 95th percentile; where they agree, those of the values that differ from them.</summary>
        /// <returns>False where all values agree.</returns>
        internal bool TryFind(out double low, out double high)
        {
            samples.Sort();
            if (Percentiles(out low, out high))
                return true;
            double background = low;
            samples.RemoveAll(value => value == background);
            return Percentiles(out low, out high);
        }

        bool Percentiles(out double low, out double high)
        {
            low = samples.Count == 0 ? 0 : samples[(int)(LowShare * (samples.Count - 1))];
            high = samples.Count == 0 ? 0 : samples[(int)(HighShare * (samples.Count - 1))];
            return high > low;
        }
    }
}
