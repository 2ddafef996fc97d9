using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Search in the segment table.</summary>
    sealed class SegmentFilterTests
    {
        [TestCase("", new[] { 0, 1, 2, 3, 4 })]
        [TestCase("   ", new[] { 0, 1, 2, 3, 4 })]
        [TestCase("LIVER", new[] { 1 })]
        [TestCase("kidney", new[] { 2, 3 })]
        [TestCase("left", new[] { 2, 4 })]
        [TestCase("left kidney", new[] { 2 })]
        [TestCase("left, head", new[] { 4 })]
        [TestCase("11", new[] { 2, 4 })]
        [TestCase("118", new[] { 4 })]
        [TestCase("12 right", new[] { 3 })]
        [TestCase("spleen", new int[0])]
        [TestCase("left spleen", new int[0])]
        public void Rows_OfASearch_HoldEachWordInNameOrLabel(string search, int[] expected) =>
            Assert.That(new SegmentFilter { Search = search }.Rows(SegmentTables.Some), Is.EqualTo(expected));

        [Test]
        public void NegativeLabel_IsFoundByItsNumber()
        {
            SegmentTable table = SegmentTables.Of((0, "Unlabelled"), (-7, "odd"), (7, "even"));
            Assert.That(new SegmentFilter { Search = "-7" }.Rows(table), Is.EqualTo(new[] { 1 }));
        }

        [Test]
        public void Rows_AfterAnotherSearchOrTable_AreOthers()
        {
            var filter = new SegmentFilter { Search = "liver" };
            Assert.That(filter.Rows(SegmentTables.Some), Is.EqualTo(new[] { 1 }));
            filter.Search = "kidney";
            Assert.That(filter.Rows(SegmentTables.Some), Is.EqualTo(new[] { 2, 3 }));
            Assert.That(filter.Rows(SegmentTables.Of((0, "kidney"))), Is.EqualTo(new[] { 0 }));
        }

        [Test]
        public void Rows_WithoutATable_AreNone() => Assert.That(new SegmentFilter { Search = "liver" }.Rows(null), Is.Empty);

        [Test]
        public void Search_OfNull_IsEmpty() => Assert.That(new SegmentFilter { Search = null }.Search, Is.Empty);
    }
}
