using System;
using System.Linq;
using System.Security.Cryptography;
using AnatomyCarve.Volumes;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>Compares what was read with what an expected.json says.</summary>
    public static class VolumeAssert
    {
        /// <summary>The tolerance of positions and spacings, mm, as expected.json states it.</summary>
        public const double ToleranceMm = 1e-4;

        static readonly double[,] LpsToRas = { { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 } };

        /// <summary>The grid lies where the 4x4 matrix (voxel index to RAS mm) says.</summary>
        public static void PlacesVoxels(JToken ijkToRas, VolumeGeometry geometry, double unitMm = 1)
        {
            for (int row = 0; row < 3; row++)
                for (int col = 0; col < 4; col++)
                {
                    double actual = LpsToRas[row, row] * geometry.IjkToLps[row, col];
                    Assert.That(actual, Is.EqualTo((double)ijkToRas[row][col] * unitMm).Within(ToleranceMm), "ijkToRas[" + row + ", " + col + "]");
                }
        }

        /// <summary>The sizes are those of a list.</summary>
        public static void HasSizes(JToken dims, VolumeGeometry geometry) =>
            Assert.That(new[] { geometry.SizeI, geometry.SizeJ, geometry.SizeK }, Is.EqualTo(dims.Select(size => (int)size).ToArray()));

        /// <summary>The stored values have a minimum, maximum, mean and both hashes.</summary>
        public static void HasStoredValues(JToken expected, VolumeData data)
        {
            VolumeStatistics statistics = data.StoredStatistics();
            HasStatistics(expected, statistics, 0);
            Assert.That(statistics.Sha256, Is.EqualTo((string)expected["sha256_f64_le"]), "SHA-256 as doubles");
            Assert.That(Sha256OfStored(data), Is.EqualTo((string)expected["sha256_native_le"]), "SHA-256 as stored");
        }

        /// <summary>Minimum, maximum and mean agree within a share of themselves (the mean at least within rounding).</summary>
        public static void HasStatistics(JToken expected, VolumeStatistics actual, double relative)
        {
            IsNear((double)expected["min"], actual.Minimum, relative, "minimum");
            IsNear((double)expected["max"], actual.Maximum, relative, "maximum");
            IsNear((double)expected["mean"], actual.Mean, Math.Max(relative, 1e-12), "mean");
        }

        /// <summary>Voxels have the values that a list of probes gives; null stands for a number that is not finite.</summary>
        public static void HasProbes(JToken probes, double relative, Func<int, int, int, int, double> valueOf)
        {
            foreach (JToken probe in probes)
            {
                JToken ijk = probe["ijk"];
                JToken[] values = probe["value"] is JArray several ? several.ToArray() : new[] { probe["value"] };
                for (int component = 0; component < values.Length; component++)
                {
                    double actual = valueOf((int)ijk[0], (int)ijk[1], (int)ijk[2], component);
                    if (values[component].Type == JTokenType.Null)
                        Assert.That(double.IsFinite(actual), Is.False, "probe at " + ijk);
                    else if (values[component].Type == JTokenType.String)
                        Assert.That(double.IsFinite(actual), Is.False, "probe at " + ijk + ", expected " + values[component]);
                    else
                        IsNear((double)values[component], actual, relative, "probe at " + ijk + ", component " + component);
                }
            }
        }

        static void IsNear(double expected, double actual, double relative, string what)
        {
            if (relative == 0)
                Assert.That(actual, Is.EqualTo(expected), what);
            else
                Assert.That(actual, Is.EqualTo(expected).Within(relative * Math.Max(1e-9, Math.Abs(expected))), what);
        }

        static string Sha256OfStored(VolumeData data)
        {
            var bytes = new byte[Buffer.ByteLength(data.Voxels)];
            Buffer.BlockCopy(data.Voxels, 0, bytes, 0, bytes.Length);
            using (SHA256 sha = SHA256.Create())
                return string.Concat(sha.ComputeHash(bytes).Select(value => value.ToString("x2")));
        }
    }
}
