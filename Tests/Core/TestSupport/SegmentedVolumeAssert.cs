using System;
using System.Linq;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>Compares volumes bit by bit.</summary>
    public static class SegmentedVolumeAssert
    {
        /// <summary>Everything that a volume holds is the same.</summary>
        public static void AreSame(SegmentedVolume actual, SegmentedVolume expected)
        {
            AreSame(actual.Geometry, expected.Geometry);
            AreSame(actual.Labels.Geometry, expected.Labels.Geometry);
            Assert.That(Bits(actual.Intensity.CodeOffset, actual.Intensity.CodeScale, actual.Intensity.ValueMax),
                Is.EqualTo(Bits(expected.Intensity.CodeOffset, expected.Intensity.CodeScale, expected.Intensity.ValueMax)), "code offset, scale, largest value");
            Assert.That(actual.Intensity.Codes.AsSpan().SequenceEqual(expected.Intensity.Codes), "codes");
            Assert.That(actual.Labels.Indices.AsSpan().SequenceEqual(expected.Labels.Indices), "label indices");
            Assert.That(actual.Segments.Select(Text), Is.EqualTo(expected.Segments.Select(Text)));
            Assert.That(actual.Labels.VoxelCounts, Is.EqualTo(expected.Labels.VoxelCounts));
            Assert.That(actual.Warnings, Is.EqualTo(expected.Warnings));
            Assert.That(actual.Intensity.Warnings, Is.EqualTo(expected.Intensity.Warnings));
            Assert.That(actual.Labels.Warnings, Is.EqualTo(expected.Labels.Warnings));
            Assert.That(actual.AutomaticTransferFunction.Points, Is.EqualTo(expected.AutomaticTransferFunction.Points));
            AreSame(actual.Histogram, expected.Histogram);
        }

        /// <summary>Both histograms hold the same.</summary>
        public static void AreSame(IntensityHistogram actual, IntensityHistogram expected)
        {
            Assert.That(new[] { actual.ValueMin, actual.ValueMax, actual.BinWidth }, Is.EqualTo(new[] { expected.ValueMin, expected.ValueMax, expected.BinWidth }));
            Assert.That(actual.Counts, Is.EqualTo(expected.Counts));
        }

        static void AreSame(VolumeGeometry actual, VolumeGeometry expected)
        {
            Assert.That(new[] { actual.SizeI, actual.SizeJ, actual.SizeK }, Is.EqualTo(new[] { expected.SizeI, expected.SizeJ, expected.SizeK }));
            for (int col = 0; col < 3; col++)
                Assert.That(Bits(actual.IjkToLps.Column(col)), Is.EqualTo(Bits(expected.IjkToLps.Column(col))), "axis " + col);
            Assert.That(Bits(actual.IjkToLps.Origin - default(PointMm)), Is.EqualTo(Bits(expected.IjkToLps.Origin - default(PointMm))), "origin");
        }

        static long[] Bits(VectorMm vector) => Bits(vector.X, vector.Y, vector.Z);

        static long[] Bits(params double[] numbers) => numbers.Select(BitConverter.DoubleToInt64Bits).ToArray();

        static string Text(Segment segment) => FormattableString.Invariant(
            $"{segment.Index} {segment.Label} {segment.Name} {segment.Color} {BitConverter.SingleToInt32Bits(segment.Opacity):x8}");
    }
}
