using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Numbers of the segment table as texts.</summary>
    sealed class SegmentTextsTests
    {
        [Test]
        public void Label_AskedAgain_IsTheSameText()
        {
            var texts = new SegmentTexts();
            string label = texts.Label(SegmentTables.Some, 4);
            Assert.That(label, Is.EqualTo("118"));
            Assert.That(texts.Label(SegmentTables.Some, 4), Is.SameAs(label));
        }

        [Test]
        public void Label_OfATableWithAnotherOpacity_IsTheSameText()
        {
            var texts = new SegmentTexts();
            string label = texts.Label(SegmentTables.Some, 4);
            Assert.That(texts.Label(SegmentTables.Some.WithOpacity(1, 0.5f), 4), Is.SameAs(label));
        }

        [Test]
        public void Label_OfAnotherTable_IsItsOwn()
        {
            var texts = new SegmentTexts();
            texts.Label(SegmentTables.Some, 1);
            Assert.That(texts.Label(SegmentTables.Of((0, "a"), (77, "b"), (78, "c"), (79, "d"), (80, "e")), 1), Is.EqualTo("77"));
        }

        [Test]
        public void Voxels_BeforeTheyAreCounted_AreDots() => Assert.That(new SegmentTexts().Voxels(null, 0), Is.EqualTo("..."));

        [Test]
        public void Voxels_OfASegment_AreGroupedInThousands() => Assert.That(new SegmentTexts().Voxels(new[] { 1234567L }, 0), Is.EqualTo("1,234,567"));
    }
}
