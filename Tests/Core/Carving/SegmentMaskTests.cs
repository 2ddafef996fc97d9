using System;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Carving
{
    public sealed class SegmentMaskTests
    {
        [TestCase(1)]
        [TestCase(31)]
        [TestCase(32)]
        [TestCase(33)]
        [TestCase(1024)]
        [TestCase(SegmentTable.MaximumCount)]
        public void All_AnyCount_HasEveryBitAndNoOther(int count)
        {
            SegmentMask all = SegmentMask.All(count);
            var words = new uint[all.WordCount];
            all.CopyWordsTo(words, 0);

            Assert.That(all.IsAll);
            Assert.That(all.WordCount, Is.EqualTo((count + 31) / 32));
            Assert.That(words.Sum(word => Convert.ToString(word, 2).Count(bit => bit == '1')), Is.EqualTo(count));
            Assert.That(all, Is.EqualTo(SegmentMask.FromIndices(count, Enumerable.Range(0, count))));
        }

        [Test]
        public void With_OneBit_ChangesThatBitOnly()
        {
            SegmentMask none = SegmentMask.None(70);

            SegmentMask one = none.With(37, true);

            Assert.That(none.IsNone);
            Assert.That(one.ClippedSegments(), Is.EqualTo(new[] { 37 }));
            Assert.That(one.With(37, true), Is.SameAs(one));
            Assert.That(one.Toggled(37), Is.EqualTo(none));
            Assert.That(one.GetHashCode(), Is.EqualTo(SegmentMask.FromIndices(70, new[] { 37, 37 }).GetHashCode()));
        }

        [Test]
        public void CopyWordsTo_AtAnOffset_WritesSegmentSInBitSModulo32OfWordSBy32()
        {
            var words = new uint[5];

            SegmentMask.FromIndices(70, new[] { 0, 33, 69 }).CopyWordsTo(words, 1);

            Assert.That(words, Is.EqualTo(new uint[] { 0, 1, 2, 32, 0 }));
        }

        [Test]
        public void Reset_AllOn_IsAllOffAndOtherwiseAllOn()
        {
            Assert.That(SegmentMask.All(5).Reset().IsNone);
            Assert.That(SegmentMask.None(5).Reset().IsAll);
            Assert.That(SegmentMask.All(5).With(3, false).Reset().IsAll);
        }

        [TestCase(0)]
        [TestCase(-1)]
        [TestCase(SegmentTable.MaximumCount + 1)]
        public void All_CountOutsideItsRange_Throws(int count) =>
            Assert.That(() => SegmentMask.All(count), Throws.InstanceOf<ArgumentOutOfRangeException>());

        [TestCase(-1)]
        [TestCase(7)]
        public void Bit_OfNoSegment_Throws(int segment)
        {
            Assert.That(() => SegmentMask.All(7)[segment], Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => SegmentMask.All(7).With(segment, true), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => SegmentMask.FromIndices(7, new[] { segment }), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        [TestCase(double.NaN, 0, 0, 1)]
        [TestCase(0, double.PositiveInfinity, 0, 1)]
        [TestCase(0, 0, 0, double.NaN)]
        [TestCase(0, 0, 0, double.PositiveInfinity)]
        [TestCase(0, 0, 0, -1e-9)]
        [TestCase(0, -2e18, 0, 1)]
        [TestCase(0, 0, 0, 2e18)]
        public void ClipSphere_NumberOutsideItsRange_Throws(double x, double y, double z, double radius) =>
            Assert.That(
                () => new ClipSphere(new PointMm(x, y, z), radius, SegmentMask.All(1)),
                Throws.InstanceOf<ArgumentOutOfRangeException>());
    }
}
