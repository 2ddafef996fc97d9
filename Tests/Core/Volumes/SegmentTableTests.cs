using System;
using System.Linq;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class SegmentTableTests
    {
        static readonly SegmentColor Red = new SegmentColor(255, 0, 0);

        [Test]
        public void IndexOfLabel_FindsTheRowOrMinusOne()
        {
            SegmentTable table = Table();
            Assert.That(table.IndexOfLabel(40), Is.EqualTo(2));
            Assert.That(table.IndexOfLabel(0), Is.EqualTo(0));
            Assert.That(table.IndexOfLabel(5), Is.EqualTo(-1));
        }

        [Test]
        public void FindByName_IgnoresCase()
        {
            Assert.That(Table().FindByName("SPLEEN").Label, Is.EqualTo(40));
            Assert.That(Table().FindByName("heart"), Is.Null);
        }

        [Test]
        public void Edit_GivesANewTableAndLeavesTheOldOneAlone()
        {
            SegmentTable table = Table();
            SegmentTable edited = table.WithOpacity(1, 0.25f).WithColor(2, Red).WithName(1, "hepar");
            Assert.That(edited.Select(segment => segment.Opacity), Is.EqualTo(new[] { 1f, 0.25f, 1f }));
            Assert.That(edited[2].Color, Is.EqualTo(Red));
            Assert.That(edited[1].Name, Is.EqualTo("hepar"));
            Assert.That(edited.IndexOfLabel(40), Is.EqualTo(2));
            Assert.That(table[1].Opacity, Is.EqualTo(1f));
            Assert.That(table[1].Name, Is.EqualTo("liver"));
        }

        [Test]
        public void EditOutsideTheRanges_IsRefused()
        {
            Assert.That(() => Table().WithOpacity(3, 1), Throws.InstanceOf<ArgumentException>());
            Assert.That(() => Table().WithOpacity(1, 1.01f), Throws.ArgumentException);
            Assert.That(() => Table().WithOpacity(1, float.NaN), Throws.ArgumentException);
        }

        [Test]
        public void RowsOutOfOrder_AreRefused()
        {
            Assert.That(() => new SegmentTable(new[] { Row(0, 1) }), Throws.ArgumentException, "row 0 without label 0");
            Assert.That(() => new SegmentTable(new[] { Row(0, 0), Row(1, 3), Row(2, 2) }), Throws.ArgumentException, "descending");
            Assert.That(() => new SegmentTable(new[] { Row(0, 0), Row(1, 0) }), Throws.ArgumentException, "twice");
            Assert.That(() => new SegmentTable(new[] { Row(0, 0), Row(2, 3) }), Throws.ArgumentException, "wrong index");
            Assert.That(() => new SegmentTable(new Segment[0]), Throws.ArgumentException, "empty");
        }

        [Test]
        public void Color_FromFloats_RoundsAndClamps()
        {
            Assert.That(SegmentColor.FromFloats(0.866667, -1, 2), Is.EqualTo(new SegmentColor(221, 0, 255)));
            Assert.That(() => SegmentColor.FromFloats(double.NaN, 0, 0), Throws.ArgumentException);
        }

        static SegmentTable Table() => new SegmentTable(new[]
        {
            Row(0, 0), new Segment(1, 3, "liver", default), new Segment(2, 40, "spleen", default),
        });

        static Segment Row(int index, long label) => new Segment(index, label, "row", default);
    }
}
