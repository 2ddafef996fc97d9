using System;
using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>The histogram behind a transfer function.</summary>
    sealed class HistogramColumnsTests
    {
        /// <summary>Bins of 10 from 0 to 40.</summary>
        static readonly IntensityHistogram Histogram = new IntensityHistogram(0, 40, 10, new long[] { 999999, 0, 999, 9 });

        [Test]
        public void Heights_OfBins_AreLogarithms() => Assert.That(Fill(0, 40, 4), Is.EqualTo(new[] { 1f, 0f, 0.5f, 1f / 6f }).Within(1e-6f));

        [Test]
        public void Heights_OutsideTheScansRange_AreZero() =>
            Assert.That(Fill(-20, 60, 8), Is.EqualTo(new[] { 0f, 0f, 1f, 0f, 0.5f, 1f / 6f, 0f, 0f }).Within(1e-6f));

        [Test]
        public void Peak_NarrowerThanAColumn_IsSeen() => Assert.That(Fill(-35, 405, 2)[0], Is.EqualTo(1f).Within(1e-6f));

        [Test]
        public void Columns_NarrowerThanABin_AreAsHighAsIt()
        {
            float[] heights = Fill(20.1, 29.9, 50);
            Assert.That(heights, Is.All.EqualTo(0.5f).Within(1e-6f));
        }

        [Test]
        public void Histogram_WithoutVoxels_IsFlat() =>
            Assert.That(Fill(0, 1, 3, new IntensityHistogram(0, 1, 1, new long[] { 0 })), Is.All.EqualTo(0f));

        static float[] Fill(double from, double to, int columns, IntensityHistogram histogram = null)
        {
            var heights = new float[columns];
            HistogramColumns.Fill(histogram ?? Histogram, new ValueWindow(from, to), heights);
            return heights;
        }
    }
}
