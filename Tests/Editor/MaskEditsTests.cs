using AnatomyCarve.Carving;
using AnatomyCarve.Editor;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Edits of many mask bits at once.</summary>
    sealed class MaskEditsTests
    {
        static readonly SegmentMask Mask = SegmentMask.FromIndices(40, new[] { 0, 3, 35 });

        [TestCase(MaskEdit.Clip, new[] { 0, 3, 4, 35, 39 })]
        [TestCase(MaskEdit.Keep, new[] { 0, 35 })]
        [TestCase(MaskEdit.Invert, new[] { 0, 4, 35, 39 })]
        public void Edit_OfSomeSegments_LeavesTheOthers(int edit, int[] expected) => Assert.That(
            MaskEdits.Apply(Mask, (MaskEdit)edit, new[] { 3, 4, 39 }), Is.EqualTo(SegmentMask.FromIndices(40, expected)));

        [TestCase(MaskEdit.Clip, new[] { 0, 3 })]
        [TestCase(MaskEdit.Keep, new[] { 1, 2 })]
        [TestCase(MaskEdit.Invert, new int[0])]
        public void Edit_ThatChangesNothing_GivesTheSameMask(int edit, int[] segments) =>
            Assert.That(MaskEdits.Apply(Mask, (MaskEdit)edit, segments), Is.SameAs(Mask));
    }
}
