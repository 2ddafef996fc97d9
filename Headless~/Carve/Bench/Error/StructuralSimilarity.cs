using System;
using System.Linq;

namespace AnatomyCarve.Headless.Cli.Bench.Error
{
    /// <summary>
    /// SSIM (Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE TIP 13(4), 2004) of two grey
    /// pictures: windows of 11 x 11 pixels weighted by a Gaussian of 1.5, K1 = 0.01, K2 = 0.03; the mean over all windows that lie in the picture.
    /// </summary>
    static class StructuralSimilarity
    {
        const int Window = 11;
        const double Sigma = 1.5, K1 = 0.01, K2 = 0.03;

        static readonly double[] Weights = MakeWeights();

        /// <summary>1 for equal pictures.</summary>
        /// <param name="a">grey values, row by row</param>
        /// <param name="b">as many</param>
        /// <param name="width">pixels in a row; 11 or more, as the rows</param>
        /// <param name="peak">the largest grey value that there can be</param>
        public static double Of(double[] a, double[] b, int width, double peak)
        {
            var height = a.Length / width;
            if (a.Length != b.Length || width < Window || height < Window)
            {
                throw new ArgumentException("SSIM compares pictures of one size, 11 x 11 pixels at least.");
            }

            var (c1, c2) = (K1 * K1 * peak * peak, K2 * K2 * peak * peak);
            var (meanA, meanB) = (Blur(a, width), Blur(b, width));
            var (squareA, squareB) = (Blur(Product(a, a), width), Blur(Product(b, b), width));
            var product = Blur(Product(a, b), width);
            return meanA.Select((_, n) =>
            {
                var (ma, mb) = (meanA[n], meanB[n]);
                var (varianceA, varianceB, covariance) = (squareA[n] - ma * ma, squareB[n] - mb * mb, product[n] - ma * mb);
                return (2 * ma * mb + c1) * (2 * covariance + c2) / ((ma * ma + mb * mb + c1) * (varianceA + varianceB + c2));
            }).Average();
        }

        static double[] Product(double[] a, double[] b) => [.. a.Zip(b, (x, y) => x * y)];

        static double[] Blur(double[] picture, int width)
        {
            var height = picture.Length / width;
            int across = width - Window + 1, down = height - Window + 1;
            var rows = new double[across * height];
            for (var n = 0; n < rows.Length; n++)
            {
                for (var w = 0; w < Window; w++) rows[n] += Weights[w] * picture[n % across + w + width * (n / across)];
            }

            var result = new double[across * down];
            for (var n = 0; n < result.Length; n++)
            {
                for (var w = 0; w < Window; w++) result[n] += Weights[w] * rows[n + across * w];
            }

            return result;
        }

        static double[] MakeWeights()
        {
            var bell = Enumerable.Range(0, Window).Select(n => Math.Exp(-Math.Pow(n - Window / 2, 2) / (2 * Sigma * Sigma))).ToArray();
            return [.. bell.Select(weight => weight / bell.Sum())];
        }
    }
}
