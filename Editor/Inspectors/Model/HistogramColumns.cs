using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Editor
{
    /// <summary>How high the columns of a plotted histogram are. The scale is logarithmic: a scan's air outnumbers its vessels ten thousand times.</summary>
    static class HistogramColumns
    {
        /// <summary>Fills one height for each column of a plot.</summary>
        /// <param name="histogram">The histogram.</param>
        /// <param name="window">What the columns show, from the first one's left edge to the last one's right.</param>
        /// <param name="heights">Takes 0 (nothing there) to 1 (the fullest bin of the whole histogram).</param>
        public static void Fill(IntensityHistogram histogram, ValueWindow window, float[] heights)
        {
            double whole = Math.Log(1.0 + histogram.MaxCount);
            for (int column = 0; column < heights.Length; column++)
            {
                double from = window.ValueAt(column / (double)heights.Length), to = window.ValueAt((column + 1.0) / heights.Length);
                heights[column] = whole > 0 ? (float)(Math.Log(1.0 + Fullest(histogram, from, to)) / whole) : 0f;
            }
        }

        /// <summary>The fullest bin of a range: a peak that is narrower than a column is still seen.</summary>
        static long Fullest(IntensityHistogram histogram, double from, double to)
        {
            if (to <= histogram.ValueMin || from >= histogram.StartOf(histogram.BinCount))
                return 0;
            int first = histogram.BinOf(from), last = histogram.BinOf(to);
            if (last > first && histogram.StartOf(last) >= to)
                last--;
            long fullest = 0;
            for (int bin = first; bin <= last; bin++)
                fullest = Math.Max(fullest, histogram.Counts[bin]);
            return fullest;
        }
    }
}
