using System;

namespace AnatomyCarve.Metrics
{
    /// <summary>How far two pictures of the same size are apart, as the design defines it. Pixels are compared in their order in the arrays.</summary>
    public static class PictureMetrics
    {
        /// <summary>What stands for "no segment" in a picture of segments.</summary>
        public const ushort NoSegment = 0xFFFF;

        /// <summary>The largest value of an 8-bit component.</summary>
        const double Peak = byte.MaxValue;

        /// <summary>
        /// The root mean square of the depths' differences, over the pixels where both pictures have a depth, and the number of pixels where only
        /// one has. A depth that is not finite is none.
        /// </summary>
        /// <param name="a">Depths in millimetres along the ray.</param>
        /// <param name="b">As many.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The pictures have different numbers of pixels.</exception>
        public static DepthDifference DepthRmse(float[] a, float[] b)
        {
            CheckSizes(a, b);
            double sum = 0;
            int both = 0;
            int onlyOne = 0;
            for (int pixel = 0; pixel < a.Length; pixel++)
            {
                bool inA = float.IsFinite(a[pixel]), inB = float.IsFinite(b[pixel]);
                if (inA && inB)
                {
                    double difference = (double)a[pixel] - b[pixel];
                    sum += difference * difference;
                    both++;
                }
                else if (inA != inB)
                {
                    onlyOne++;
                }
            }
            double rmse = both > 0 ? Math.Sqrt(sum / both) : onlyOne > 0 ? double.NaN : 0;
            return new DepthDifference(rmse, both, onlyOne);
        }

        /// <summary>
        /// The mean absolute error of the first visible segment: of the pixels where at least one picture has a segment, the share in which they
        /// differ.
        /// </summary>
        /// <param name="a">Dense segment indices; <see cref="NoSegment"/> = none.</param>
        /// <param name="b">As many.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The pictures have different numbers of pixels.</exception>
        public static SegmentDifference FirstSegmentMae(ushort[] a, ushort[] b)
        {
            CheckSizes(a, b);
            int considered = 0;
            int differing = 0;
            for (int pixel = 0; pixel < a.Length; pixel++)
            {
                if (a[pixel] != NoSegment || b[pixel] != NoSegment)
                    considered++;
                if (a[pixel] != b[pixel])
                    differing++;
            }
            return new SegmentDifference(considered, differing);
        }

        /// <summary>As for 16-bit pictures, for indices in 32 bits; a negative number is none too.</summary>
        /// <param name="a">Dense segment indices; negative or <see cref="NoSegment"/> = none.</param>
        /// <param name="b">As many.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The pictures have different numbers of pixels.</exception>
        public static SegmentDifference FirstSegmentMae(int[] a, int[] b)
        {
            CheckSizes(a, b);
            int considered = 0;
            int differing = 0;
            for (int pixel = 0; pixel < a.Length; pixel++)
            {
                int inA = a[pixel] == NoSegment ? -1 : Math.Max(-1, a[pixel]);
                int inB = b[pixel] == NoSegment ? -1 : Math.Max(-1, b[pixel]);
                if (inA >= 0 || inB >= 0)
                    considered++;
                if (inA != inB)
                    differing++;
            }
            return new SegmentDifference(considered, differing);
        }

        /// <summary>The difference of two 8-bit pictures over all their components, as they stand in the file (sRGB is not undone).</summary>
        /// <param name="a">Components, in any order.</param>
        /// <param name="b">As many, in the same order.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The pictures have different numbers of components.</exception>
        public static ImageDifference Image(byte[] a, byte[] b)
        {
            CheckSizes(a, b);
            long sum = 0;
            int largest = 0;
            for (int component = 0; component < a.Length; component++)
            {
                int difference = Math.Abs(a[component] - b[component]);
                sum += difference * difference;
                largest = Math.Max(largest, difference);
            }
            double rmse = a.Length > 0 ? Math.Sqrt(sum / (double)a.Length) : 0;
            return new ImageDifference(rmse, sum > 0 ? 20 * Math.Log10(Peak / rmse) : double.PositiveInfinity, largest);
        }

        /// <summary><see cref="ImageDifference.Rmse"/> of two pictures.</summary>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The pictures have different numbers of components.</exception>
        public static double ImageRmse(byte[] a, byte[] b) => Image(a, b).Rmse;

        /// <summary><see cref="ImageDifference.PsnrDecibels"/> of two pictures.</summary>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The pictures have different numbers of components.</exception>
        public static double Psnr(byte[] a, byte[] b) => Image(a, b).PsnrDecibels;

        static void CheckSizes(Array a, Array b)
        {
            if (a == null)
                throw new ArgumentNullException(nameof(a));
            if (b == null)
                throw new ArgumentNullException(nameof(b));
            if (a.Length != b.Length)
                throw new ArgumentException(FormattableString.Invariant($"The pictures differ in size: {a.Length} and {b.Length} values."), nameof(b));
        }
    }
}
