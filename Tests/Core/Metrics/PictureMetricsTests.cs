using System;
using AnatomyCarve.Metrics;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Metrics
{
    /// <summary>The metrics on pairs made by hand, whose results are known exactly.</summary>
    public sealed class PictureMetricsTests
    {
        const float None = float.PositiveInfinity;

        [Test]
        public void DepthRmse_HandMadePair_IsExact()
        {
            DepthDifference difference = PictureMetrics.DepthRmse(
                new[] { 1f, 10f, None, 5f, None, 7f }, new[] { 4f, 6f, None, None, 2f, 7f });
            Assert.That(difference.Both, Is.EqualTo(3));
            Assert.That(difference.OnlyOne, Is.EqualTo(2));
            Assert.That(difference.RmseMm, Is.EqualTo(Math.Sqrt(25 / 3.0)));
        }

        [Test]
        public void DepthRmse_NaN_IsNoDepth()
        {
            DepthDifference difference = PictureMetrics.DepthRmse(new[] { float.NaN, float.NaN, 3f }, new[] { 1f, None, 3f });
            Assert.That(difference.Both, Is.EqualTo(1));
            Assert.That(difference.OnlyOne, Is.EqualTo(1));
            Assert.That(difference.RmseMm, Is.EqualTo(0));
        }

        [Test]
        public void DepthRmse_NoPixelInCommon_IsZeroIfBothAreEmptyAndUndefinedOtherwise()
        {
            Assert.That(PictureMetrics.DepthRmse(new[] { None, None }, new[] { None, None }).RmseMm, Is.EqualTo(0));
            Assert.That(PictureMetrics.DepthRmse(new[] { None, 1f }, new[] { 2f, None }).RmseMm, Is.NaN);
        }

        [Test]
        public void FirstSegmentMae_HandMadePair_CountsPixelsWhereAtLeastOneHasASegment()
        {
            const ushort no = PictureMetrics.NoSegment;
            SegmentDifference difference = PictureMetrics.FirstSegmentMae(
                new ushort[] { 0, 1, 2, no, no, 5, 6, no }, new ushort[] { 0, 1, 3, 4, no, no, 6, no });
            Assert.That(difference.Considered, Is.EqualTo(6));
            Assert.That(difference.Differing, Is.EqualTo(3));
            Assert.That(difference.Mae, Is.EqualTo(0.5));
        }

        [Test]
        public void FirstSegmentMae_Integers_TakeNegativeAndFFFFAsNone()
        {
            SegmentDifference difference = PictureMetrics.FirstSegmentMae(new[] { -1, 0xFFFF, -7, 3, 70000 }, new[] { 0xFFFF, 2, -1, 3, 70001 });
            Assert.That(difference.Considered, Is.EqualTo(3));
            Assert.That(difference.Differing, Is.EqualTo(2));
        }

        [Test]
        public void FirstSegmentMae_NoSegmentAnywhere_IsZero() =>
            Assert.That(PictureMetrics.FirstSegmentMae(new[] { -1, -1 }, new[] { -1, -1 }).Mae, Is.EqualTo(0));

        [Test]
        public void Image_HandMadePair_IsExact()
        {
            ImageDifference difference = PictureMetrics.Image(new byte[] { 0, 100, 200, 255 }, new byte[] { 0, 103, 196, 255 });
            Assert.That(difference.Rmse, Is.EqualTo(2.5));
            Assert.That(difference.Largest, Is.EqualTo(4));
            Assert.That(difference.PsnrDecibels, Is.EqualTo(20 * Math.Log10(102)));
            Assert.That(PictureMetrics.Psnr(new byte[] { 0 }, new byte[] { 255 }), Is.EqualTo(0));
        }

        [Test]
        public void Image_Identical_HasInfinitePsnr()
        {
            Assert.That(PictureMetrics.Psnr(new byte[] { 1, 2 }, new byte[] { 1, 2 }), Is.EqualTo(double.PositiveInfinity));
            Assert.That(PictureMetrics.ImageRmse(new byte[] { 1, 2 }, new byte[] { 1, 2 }), Is.EqualTo(0));
        }

        [Test]
        public void Metrics_DifferentSizes_Throw()
        {
            Assert.That(() => PictureMetrics.DepthRmse(new float[2], new float[3]), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureMetrics.FirstSegmentMae(new int[2], new int[3]), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureMetrics.Image(new byte[2], new byte[3]), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => PictureMetrics.Image(null, new byte[3]), Throws.InstanceOf<ArgumentNullException>());
        }
    }
}
