using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Editor;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Rows and columns of the segment table.</summary>
    sealed class TableLayoutTests
    {
        [TestCase(0f, 0, 10)]
        [TestCase(10f, 0, 11)]
        [TestCase(20f, 1, 11)]
        [TestCase(19990f, 999, 1000)]
        [TestCase(1e9f, 1000, 1000)]
        [TestCase(-50f, 0, 8)]
        public void Rows_OfAScrolledView_AreThoseThatAreSeen(float scroll, int first, int end)
        {
            var range = new RowRange(1000, 20f, scroll, 200f);
            Assert.That(range.First, Is.EqualTo(first));
            Assert.That(range.End, Is.EqualTo(end));
        }

        [Test]
        public void Rows_OfAnEmptyList_AreNone() => Assert.That(new RowRange(0, 20f, 0f, 200f).End, Is.Zero);

        [Test]
        public void Columns_OfARow_LieBesideEachOtherWithinIt([Values(200f, 300f, 380f, 500f, 1000f)] float width, [Values] bool editable)
        {
            var row = new Rect(7f, 30f, width, 20f);
            Rect[] columns = All(new SegmentColumns(row, editable)).Where(c => c.width > 0f).OrderBy(c => c.x).ToArray();
            Assert.That(columns.First().xMin, Is.GreaterThanOrEqualTo(row.xMin));
            Assert.That(columns.Last().xMax, Is.LessThanOrEqualTo(row.xMax + 1e-3f));
            for (int c = 1; c < columns.Length; c++)
                Assert.That(columns[c].xMin, Is.GreaterThanOrEqualTo(columns[c - 1].xMax), $"column {c}");
        }

        [Test]
        public void Name_InAnyInspector_HasRoom([Values(280f, 380f, 500f)] float width, [Values] bool editable) =>
            Assert.That(new SegmentColumns(new Rect(0f, 0f, width, 20f), editable).Name.width, Is.GreaterThanOrEqualTo(60f));

        [Test]
        public void Columns_OfAReadOnlyTable_AreNotToEdit()
        {
            var columns = new SegmentColumns(new Rect(0f, 0f, 400f, 20f), false);
            Assert.That(new[] { columns.Visible.width, columns.Opacity.width, columns.Clipped.width }, Is.All.Zero);
            Assert.That(columns.Voxels.width, Is.GreaterThan(0f));
        }

        [Test]
        public void Columns_OfAWideInspector_AreAllThere() =>
            Assert.That(All(new SegmentColumns(new Rect(0f, 0f, 600f, 20f), true)).Select(c => c.width), Is.All.GreaterThan(0f));

        static IEnumerable<Rect> All(SegmentColumns c) => new[] { c.Visible, c.Color, c.Opacity, c.Name, c.Label, c.Voxels, c.Clipped };
    }
}
