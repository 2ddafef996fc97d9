using System;
using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using System.Threading;

namespace AnatomyCarve.Volumes
{
    /// <summary>Minimum, maximum, mean and hash of an image's values, all components. Immutable.</summary>
    public sealed class VolumeStatistics
    {
        VolumeStatistics(double minimum, double maximum, double mean, long count, long nonFiniteCount, string sha256)
        {
            Minimum = minimum;
            Maximum = maximum;
            Mean = mean;
            Count = count;
            NonFiniteCount = nonFiniteCount;
            Sha256 = sha256;
        }

        /// <summary>The smallest finite value; NaN when there is none.</summary>
        public double Minimum { get; }

        /// <summary>The largest finite value; NaN when there is none.</summary>
        public double Maximum { get; }

        /// <summary>The mean of the finite values; NaN when there is none.</summary>
        public double Mean { get; }

        /// <summary>The number of values, every component counted.</summary>
        public long Count { get; }

        /// <summary>How many of them are NaN or infinite.</summary>
        public long NonFiniteCount { get; }

        /// <summary>SHA-256, in lower-case hexadecimal, of all values as 64-bit little-endian floats in the file's order.</summary>
        public string Sha256 { get; }

        /// <summary>Walks through an image once.</summary>
        internal static VolumeStatistics Of(VolumeData data, double slope, double intercept, CancellationToken cancellation)
        {
            bool scale = slope != 1 || intercept != 0;
            double minimum = double.PositiveInfinity;
            double maximum = double.NegativeInfinity;
            double sum = 0;
            long finite = 0;
            int length = data.Voxels.Length;
            var values = new double[Math.Min(length, VoxelConversion.BlockLength)];
            var bytes = new byte[values.Length * sizeof(double)];
            using (IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256))
            {
                for (int start = 0; start < length;)
                {
                    cancellation.ThrowIfCancellationRequested();
                    int count = Math.Min(values.Length, length - start);
                    VoxelConversion.CopyTo(data.Voxels, data.VoxelType, start, values, count);

                    // The mean of a block first: sums stay small, so that the mean of 10^9 values keeps its digits.
                    double blockSum = 0;
                    for (int n = 0; n < count; n++)
                    {
                        double value = values[n];
                        if (scale)
                        {
                            value = slope * value + intercept;
                            values[n] = value;
                        }

                        if (double.IsFinite(value))
                        {
                            minimum = Math.Min(minimum, value);
                            maximum = Math.Max(maximum, value);
                            blockSum += value;
                            finite++;
                        }
                    }

                    sum += blockSum;
                    AppendLittleEndian(hash, values, bytes, count);
                    start += count;
                }

                bool none = finite == 0;
                return new VolumeStatistics(
                    none ? double.NaN : minimum, none ? double.NaN : maximum, none ? double.NaN : sum / finite, length, length - finite, Hexadecimal(hash.GetHashAndReset()));
            }
        }

        static void AppendLittleEndian(IncrementalHash hash, double[] values, byte[] bytes, int count)
        {
            int byteCount = count * sizeof(double);
            Buffer.BlockCopy(values, 0, bytes, 0, byteCount);
            if (!BitConverter.IsLittleEndian)
                for (int n = 0; n < byteCount; n += sizeof(double))
                    Array.Reverse(bytes, n, sizeof(double));
            hash.AppendData(bytes, 0, byteCount);
        }

        static string Hexadecimal(byte[] bytes)
        {
            var text = new StringBuilder(bytes.Length * 2);
            foreach (byte value in bytes)
                text.Append(value.ToString("x2", CultureInfo.InvariantCulture));
            return text.ToString();
        }
    }
}
