using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Chooses a transfer function under which the body is opaque and the air around it is not: for CT in Hounsfield units a fixed ramp
    /// below fat, for anything else a ramp below the threshold that parts the histogram best (Otsu 1979).
    /// </summary>
    public static class AutomaticTransferFunction
    {
        /// <summary>Hounsfield units of air lie below this; MR scans seldom have negative values, and then few of them.</summary>
        public const double CtAirBelow = -500;

        /// <summary>The share of voxels below <see cref="CtAirBelow"/> that makes a scan a CT whatever its largest value is.</summary>
        const double CtAirShare = 0.01;

        /// <summary>CTs without metal end below this (12 bits, offset 1024); then a single voxel of air is enough.</summary>
        const double CtUsualMaximum = 4096;

        /// <summary>Hounsfield units where a CT's ramp starts: lung and partial volume of the skin lie below, fat (about -100) above.</summary>
        public const double CtTransparentBelow = -350;

        /// <summary>Hounsfield units from which on a CT is opaque.</summary>
        public const double CtOpaqueFrom = -150;

        /// <summary>Where the ramp of other scans starts, as a share of the way from the background's mean to the threshold.</summary>
        const double RampStart = 0.4;

        const int Bins = 1024;

        /// <summary>Values of the criterion that are nearer to each other, relatively, are equal but for rounding.</summary>
        const double Rounding = 1e-9;

        /// <summary>The function for a scan. A constant scan is opaque everywhere.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        public static OpacityTransferFunction For(IntensityVolume volume)
        {
            double minimum = (volume ?? throw new ArgumentNullException(nameof(volume))).ValueMin;
            double span = volume.ValueMax - minimum;
            if (span == 0)
                return OpacityTransferFunction.Constant(1);
            if (IsCt(volume))
                return new OpacityTransferFunction(new[] { new TransferPoint(CtTransparentBelow, 0), new TransferPoint(CtOpaqueFrom, 1) });
            (double background, double threshold) = Otsu(Histogram(volume, span));
            double start = background + (RampStart * (threshold - background));
            return new OpacityTransferFunction(new[] { new TransferPoint(minimum + (span * start), 0), new TransferPoint(minimum + (span * threshold), 1) });
        }

        static bool IsCt(IntensityVolume volume)
        {
            if (volume.ValueMin > CtAirBelow || volume.ValueMax <= CtOpaqueFrom)
                return false;
            if (volume.ValueMax < CtUsualMaximum)
                return true;
            double largestAirCode = (CtAirBelow - volume.CodeOffset) / volume.CodeScale;
            long air = 0;
            foreach (ushort code in volume.Codes)
                air += code <= largestAirCode ? 1 : 0;
            return air >= CtAirShare * volume.Codes.Length;
        }

        static long[] Histogram(IntensityVolume volume, double span)
        {
            var histogram = new long[Bins];
            double binsPerCode = volume.CodeScale / span * (Bins - 1);
            foreach (ushort code in volume.Codes)
                histogram[Math.Min(Bins - 1, (int)((code * binsPerCode) + 0.5))]++;
            return histogram;
        }

        /// <summary>The mean of the lower class and the threshold, as shares of the range.</summary>
        static (double Background, double Threshold) Otsu(long[] histogram)
        {
            double count = 0;
            double sum = 0;
            for (int bin = 0; bin < Bins; bin++)
            {
                count += histogram[bin];
                sum += (double)bin * histogram[bin];
            }

            double lowerCount = 0;
            double lowerSum = 0;
            double best = -1;
            double background = 0;
            int first = 0;
            int last = 0;
            for (int bin = 0; bin < Bins - 1; bin++)
            {
                lowerCount += histogram[bin];
                lowerSum += (double)bin * histogram[bin];
                if (lowerCount == 0 || lowerCount == count)
                    continue;
                double lowerMean = lowerSum / lowerCount;
                double upperMean = (sum - lowerSum) / (count - lowerCount);
                double between = lowerCount * (count - lowerCount) * (upperMean - lowerMean) * (upperMean - lowerMean);
                if (between > best * (1 + Rounding))
                {
                    best = between;
                    background = lowerMean / (Bins - 1);
                    first = bin;
                    last = bin;
                }
                else if (between >= best * (1 - Rounding))
                {
                    last = bin;
                }
            }

            // Where a gap parts the classes every bin in it is as good: its middle.
            return (background, (0.5 + ((first + last) / 2.0)) / (Bins - 1));
        }
    }
}
