using System;
using System.Collections.Generic;
using System.Linq;

namespace AnatomyCarve.Volumes
{
    /// <summary>How often which intensities occur in a scan: voxels by bins of equal width. Immutable.</summary>
    public sealed class IntensityHistogram
    {
        /// <summary>The most bins where no other number is asked for.</summary>
        public const int DefaultBins = 256;

        /// <summary>The most bins there can be: as many as a scan has codes.</summary>
        public const int MaximumBins = 65536;

        readonly long[] counts;

        /// <summary>Makes a histogram from its counts.</summary>
        /// <param name="valueMin">Where bin 0 starts; finite.</param>
        /// <param name="valueMax">The largest value; finite, not below <paramref name="valueMin"/>, in the last bin.</param>
        /// <param name="binWidth">From one bin's start to the next; finite, above 0.</param>
        /// <param name="counts">Voxels in each bin: 1 to <see cref="MaximumBins"/> numbers of 0 or more. They are copied.</param>
        /// <exception cref="ArgumentNullException"><paramref name="counts"/> is null.</exception>
        /// <exception cref="ArgumentException">A number lies outside its range.</exception>
        public IntensityHistogram(double valueMin, double valueMax, double binWidth, IEnumerable<long> counts)
        {
            this.counts = (counts ?? throw new ArgumentNullException(nameof(counts))).ToArray();
            string problem = FindProblem(valueMin, valueMax, binWidth, this.counts);
            if (problem != null)
                throw new ArgumentException(FormattableString.Invariant(
                    $"{this.counts.Length} bins of {binWidth} can't hold the values {valueMin} to {valueMax}; expected {problem}."), nameof(counts));
            ValueMin = valueMin;
            ValueMax = valueMax;
            BinWidth = binWidth;
            Counts = Array.AsReadOnly(this.counts);
            Total = this.counts.Sum();
            MaxCount = this.counts.Max();
            MaxCountBesideBackground = LargestBesideFullest(this.counts);
        }

        /// <summary>The number of bins, at least 1.</summary>
        public int BinCount => counts.Length;

        /// <summary>Voxels in each bin, from the lowest values to the highest.</summary>
        public IReadOnlyList<long> Counts { get; }

        /// <summary>Where bin 0 starts: the scan's smallest value.</summary>
        public double ValueMin { get; }

        /// <summary>The scan's largest value; it lies in the last bin.</summary>
        public double ValueMax { get; }

        /// <summary>From one bin's start to the next, in the scan's unit.</summary>
        public double BinWidth { get; }

        /// <summary>All voxels.</summary>
        public long Total { get; }

        /// <summary>The voxels of the fullest bin.</summary>
        public long MaxCount { get; }

        /// <summary>
        /// The voxels of the fullest bin besides the highest peak, which is the background's as a rule: the fullest bin and those around it for as long as they fall. It
        /// is the height to draw to, where the background would press all else to the floor. <see cref="MaxCount"/> where there is nothing else.
        /// </summary>
        public long MaxCountBesideBackground { get; }

        /// <summary>
        /// Counts a scan's voxels. A bin holds the same whole number of codes as any other (the last one may hold fewer), so that none is empty, or
        /// twice as full, for want of values: the scan decides on the number of bins, up to the one that is asked for.
        /// </summary>
        /// <param name="volume">The scan.</param>
        /// <param name="bins">The most bins: 1 to <see cref="MaximumBins"/>.</param>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException"><paramref name="bins"/> lies outside its range.</exception>
        public static IntensityHistogram Of(IntensityVolume volume, int bins = DefaultBins)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            if (bins < 1 || bins > MaximumBins)
                throw new ArgumentOutOfRangeException(nameof(bins), bins, FormattableString.Invariant($"A histogram has 1 to {MaximumBins} bins."));
            var codeCounts = new int[MaximumBins];
            int largest = 0;
            foreach (ushort code in volume.Codes)
            {
                codeCounts[code]++;
                largest = Math.Max(largest, code);
            }

            int codesPerBin = (largest / bins) + 1;
            var counts = new long[(largest / codesPerBin) + 1];
            for (int code = 0; code <= largest; code++)
                counts[code / codesPerBin] += codeCounts[code];
            double binWidth = codesPerBin * volume.CodeScale;

            // The largest code stands for the largest value but for rounding.
            double valueMax = Math.Min(volume.ValueMax, volume.ValueMin + (binWidth * counts.Length));
            return new IntensityHistogram(volume.ValueMin, valueMax, binWidth, counts);
        }

        /// <summary>The bin of a value; those below the range count to the first bin, those above to the last, NaN to the first.</summary>
        public int BinOf(double value)
        {
            double bin = Math.Floor((value - ValueMin) / BinWidth);
            return bin > 0 ? (int)Math.Min(bin, counts.Length - 1) : 0;
        }

        /// <summary>Where a bin starts, in the scan's unit.</summary>
        /// <param name="bin">0 to <see cref="BinCount"/>; the last of these is where the last bin ends.</param>
        /// <exception cref="ArgumentOutOfRangeException">No such bin.</exception>
        public double StartOf(int bin)
        {
            if (bin < 0 || bin > counts.Length)
                throw new ArgumentOutOfRangeException(nameof(bin), bin, FormattableString.Invariant($"The histogram has bins 0 to {counts.Length - 1}."));
            return ValueMin + (bin * BinWidth);
        }

        /// <summary>What is expected of numbers that make no histogram; null where they make one.</summary>
        internal static string FindProblem(double valueMin, double valueMax, double binWidth, long[] counts)
        {
            if (counts.Length < 1 || counts.Length > MaximumBins)
                return FormattableString.Invariant($"1 to {MaximumBins} bins");
            if (!double.IsFinite(valueMin) || !double.IsFinite(valueMax) || !(valueMax >= valueMin))
                return "a finite range";
            if (!(binWidth > 0) || !double.IsFinite(binWidth))
                return "a finite width above 0";
            return counts.Any(count => count < 0) ? "counts of 0 or more" : null;
        }

        static long LargestBesideFullest(long[] counts)
        {
            int fullest = Array.IndexOf(counts, counts.Max());
            int first = fullest, last = fullest;
            while (first > 0 && counts[first - 1] <= counts[first])
                first--;
            while (last < counts.Length - 1 && counts[last + 1] <= counts[last])
                last++;
            long largest = 0;
            for (int bin = 0; bin < counts.Length; bin++)
            {
                if (bin < first || bin > last)
                    largest = Math.Max(largest, counts[bin]);
            }

            return largest > 0 ? largest : counts[fullest];
        }
    }
}
