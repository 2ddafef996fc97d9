using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// A scan's intensities as 16-bit codes, ready for the GPU: value = CodeOffset + CodeScale * code. Whole numbers that span no more
    /// than 65,535 are kept exactly; others are rounded to the nearest of 65,536 steps. Immutable.
    /// </summary>
    /// <remarks>
    /// A few values far from all others would leave no steps for the rest: where the 65,536 steps over all values are coarser than a thousandth of
    /// the typical range (5th to 95th percentile), they cover that range and 32 times it on either side instead; what lies beyond counts as the ends,
    /// and a warning says how many voxels that are.
    /// </remarks>
    public sealed class IntensityVolume
    {
        const double CoarsestStep = 1e-3;
        const double MarginInTypicalRanges = 32;

        /// <summary>Makes a volume from its codes. The array is kept, not copied.</summary>
        /// <param name="geometry">Where the voxels lie.</param>
        /// <param name="codes">One code per voxel, i fastest.</param>
        /// <param name="codeOffset">The value of code 0; finite.</param>
        /// <param name="codeScale">The step from one code to the next; finite, greater than 0.</param>
        /// <param name="valueMax">The largest value, that of the largest code.</param>
        /// <param name="warnings">What was odd, a sentence each; may be null.</param>
        /// <exception cref="ArgumentException">An array of another length, or numbers outside their ranges.</exception>
        public IntensityVolume(VolumeGeometry geometry, ushort[] codes, double codeOffset, double codeScale, double valueMax, IEnumerable<string> warnings = null)
        {
            Geometry = geometry ?? throw new ArgumentNullException(nameof(geometry));
            Codes = codes ?? throw new ArgumentNullException(nameof(codes));
            if (codes.LongLength != geometry.VoxelCount)
                throw new ArgumentException(FormattableString.Invariant($"{geometry.VoxelCount} voxels need as many codes, not {codes.LongLength}."), nameof(codes));
            if (!double.IsFinite(codeOffset) || !double.IsFinite(codeScale) || codeScale <= 0 || !double.IsFinite(valueMax) || valueMax < codeOffset)
                throw new ArgumentException(FormattableString.Invariant($"Codes can't stand for {codeOffset} to {valueMax} in steps of {codeScale}."), nameof(codeScale));
            CodeOffset = codeOffset;
            CodeScale = codeScale;
            ValueMax = valueMax;
            Warnings = warnings == null ? Array.Empty<string>() : warnings.ToArray();
        }

        /// <summary>What was odd while the volume was made, a sentence each.</summary>
        public IReadOnlyList<string> Warnings { get; }

        /// <summary>Where the voxels lie.</summary>
        public VolumeGeometry Geometry { get; }

        /// <summary>One code per voxel, i fastest. Not to be changed.</summary>
        public ushort[] Codes { get; }

        /// <summary>The smallest value: that of code 0.</summary>
        public double ValueMin => CodeOffset;

        /// <summary>The largest value.</summary>
        public double ValueMax { get; }

        /// <summary>value = CodeOffset + CodeScale * code.</summary>
        public double CodeScale { get; }

        /// <summary>value = CodeOffset + CodeScale * code.</summary>
        public double CodeOffset { get; }

        /// <summary>The intensity that a code stands for.</summary>
        public double ValueOf(ushort code) => CodeOffset + (CodeScale * code);

        /// <summary>
        /// Makes a scan from one component of an image. NaN takes the smallest finite value, infinite values the nearest finite one;
        /// an image without finite values becomes 0 everywhere.
        /// </summary>
        /// <param name="data">The image.</param>
        /// <param name="component">Which of its components, from 0.</param>
        /// <param name="cancellation">Cancels the work.</param>
        /// <param name="progress">Told the share done, 0 to 1; may be null.</param>
        /// <exception cref="ArgumentOutOfRangeException">No such component.</exception>
        /// <exception cref="AnatomyCarveException">The values span more than double precision can hold.</exception>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public static IntensityVolume FromVolumeData(
            VolumeData data, int component = 0, CancellationToken cancellation = default, IProgress<float> progress = null)
        {
            (data ?? throw new ArgumentNullException(nameof(data))).CheckComponent(component);
            var range = new ValueRange();
            var typical = new TypicalRange(data.Geometry.VoxelCount);
            ComponentBlocks.ForEach(data, component, cancellation, (values, start, count) =>
            {
                range.Include(values, count);
                typical.Include(values, start, count);
                progress?.Report(0.4f * (start + count) / data.Geometry.VoxelCount);
            });

            if (double.IsInfinity(range.Maximum - range.Minimum))
                throw new AnatomyCarveException(
                    FormattableString.Invariant($"{data.Source}: the values span {range.Minimum} to {range.Maximum}, more than can be shown."));
            double minimum = range.Minimum, maximum = range.Maximum;
            double storedStep = data.VoxelType.IsFloat() ? 0 : Math.Abs(data.Slope);
            double scale = range.CodeStep(storedStep);
            bool isExact = scale == 1 || scale == storedStep;
            bool isNarrowed = false;
            if (!isExact && typical.TryFind(out double low, out double high) && scale > CoarsestStep * (high - low))
            {
                double margin = MarginInTypicalRanges * (high - low);
                minimum = Math.Max(minimum, low - margin);
                maximum = Math.Min(maximum, high + margin);
                scale = (maximum - minimum) / ushort.MaxValue;
                isNarrowed = true;
            }
            long beyond = 0;
            var codes = new ushort[data.Geometry.VoxelCount];
            ComponentBlocks.ForEach(data, component, cancellation, (values, start, count) =>
            {
                beyond += Encode(values, codes, start, count, minimum, maximum, scale);
                progress?.Report(0.4f + (0.6f * (start + count) / data.Geometry.VoxelCount));
            });
            string[] warnings = isNarrowed
                ? new[]
                {
                    FormattableString.Invariant(
                        $"{beyond} voxels lie far from all others ({range.Minimum} to {range.Maximum}); they count as {minimum:G6} or {maximum:G6}.")
                }
                : null;
            return new IntensityVolume(data.Geometry, codes, minimum, scale, maximum, warnings);
        }

        /// <returns>How many finite values lie outside of minimum to maximum.</returns>
        static long Encode(double[] values, ushort[] codes, int start, int count, double minimum, double maximum, double scale)
        {
            double span = maximum - minimum;
            long beyond = 0;
            for (int n = 0; n < count; n++)
            {
                double above = values[n] - minimum;
                if ((above < 0 || above > span) && double.IsFinite(values[n]))
                    beyond++;

                // NaN fails the first comparison and takes code 0, as minus infinity does.
                codes[start + n] = above > 0 ? (ushort)Math.Min(ushort.MaxValue, Math.Round(Math.Min(above, span) / scale)) : (ushort)0;
            }
            return beyond;
        }
    }
}
