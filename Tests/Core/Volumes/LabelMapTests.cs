using System;
using System.Linq;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public sealed class LabelMapTests
    {
        static readonly int[] Labels = { 0, 2047, 2048, 2049, 2050, 65535, 3, 0, 65535, 7 };

        [TestCase(typeof(ushort))]
        [TestCase(typeof(int))]
        [TestCase(typeof(uint))]
        [TestCase(typeof(long))]
        [TestCase(typeof(ulong))]
        [TestCase(typeof(float))]
        [TestCase(typeof(double))]
        public void LabelsWithGaps_BecomeDenseIndicesInAscendingOrder(Type type)
        {
            Array voxels = Array.CreateInstance(type, Labels.Length);
            for (int n = 0; n < Labels.Length; n++)
                voxels.SetValue(Convert.ChangeType(Labels[n], type), n);
            LabelMap map = LabelMap.FromVolumeData(Line(voxels));
            Assert.That(map.Segments.Select(segment => segment.Label), Is.EqualTo(new[] { 0, 3, 7, 2047, 2048, 2049, 2050, 65535 }));
            Assert.That(map.Indices.Select(index => map.Segments[index].Label), Is.EqualTo(Labels));
            Assert.That(map.Warnings, Is.Empty);
        }

        [Test]
        public void LabelsWithoutNames_AreNamedByNumberAndColouredByTheTable()
        {
            LabelMap map = LabelMap.FromVolumeData(Line(new byte[] { 0, 5 }));
            Assert.That(map.Segments[1].Name, Is.EqualTo("Label 5"));
            Assert.That(map.Segments[1].Color, Is.EqualTo(PredefinedSegmentColors.ForLabel(5)));
            Assert.That(map.Segments[0].Name, Is.EqualTo(SegmentTable.UnlabelledName));
        }

        [Test]
        public void NegativeLabels_FollowRowZeroInOrder()
        {
            LabelMap map = LabelMap.FromVolumeData(Line(new short[] { 4, -3, 0 }));
            Assert.That(map.Segments.Select(segment => segment.Label), Is.EqualTo(new[] { 0, -3, 4 }));
            Assert.That(map.Indices, Is.EqualTo(new ushort[] { 2, 1, 0 }));
        }

        [Test]
        public void MapWithoutZero_StillHasRowZero()
        {
            LabelMap map = LabelMap.FromVolumeData(Line(new byte[] { 9, 9 }));
            Assert.That(map.Segments.Select(segment => segment.Label), Is.EqualTo(new[] { 0, 9 }));
            Assert.That(map.CountVoxels(), Is.EqualTo(new[] { 0, 2 }));
        }

        [TestCase(1.5f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(1e30f)]
        public void ValueThatIsNoWholeNumber_IsRefused(float value)
        {
            var refusal = Assert.Throws<VolumeFormatException>(() => LabelMap.FromVolumeData(Line(new[] { 0f, value })));
            Assert.That(refusal.Message, Does.Contain("a whole number"));
        }

        [Test]
        public void MoreLabelsThanTheTableHolds_AreRefused()
        {
            int[] voxels = Enumerable.Range(0, 70000).ToArray();
            var refusal = Assert.Throws<VolumeFormatException>(() => LabelMap.FromVolumeData(Line(voxels)));
            Assert.That(refusal.Message, Does.Contain("intensity volume"));
        }

        [Test]
        public void SeveralValuesPerVoxelWithoutSegments_AreRefused()
        {
            var data = new VolumeData(new VolumeGeometry(2, 1, 1, Affine.Identity), new byte[6], 3);
            Assert.That(() => LabelMap.FromVolumeData(data), Throws.TypeOf<VolumeFormatException>());
        }

        [Test]
        public void ScaledLabels_AreReadAfterScaling()
        {
            var data = new VolumeData(new VolumeGeometry(3, 1, 1, Affine.Identity), new byte[] { 0, 1, 2 }, 1, ComponentOrder.Fastest, 10);
            Assert.That(LabelMap.FromVolumeData(data).Segments.Select(segment => segment.Label), Is.EqualTo(new[] { 0, 10, 20 }));
        }

        [Test]
        public void OverlappingLayers_AreMergedSoThatTheLaterSegmentWins()
        {
            // The file lists the segment of layer 1 first, so that of layer 0 wins where both are.
            var description = new VolumeDescription();
            description.Segments.Add(new SegmentInfo("a", "first", 2, 1));
            description.Segments.Add(new SegmentInfo("b", "second", 1, 0));
            LabelMap map = LabelMap.FromVolumeData(Layers(description, new byte[] { 1, 2, 1, 0, 0, 2, 0, 0 }));
            Assert.That(map.Indices.Select(index => map.Segments[index].Name), Is.EqualTo(new[] { "second", "second", "first", SegmentTable.UnlabelledName }));
            Assert.That(map.Warnings, Has.Some.StartsWith("Several segments claim 1 of the voxels"));
        }

        [Test]
        public void SameValueInTwoLayers_BecomesTwoLabels()
        {
            var description = new VolumeDescription();
            description.Segments.Add(new SegmentInfo("a", "A", 1, 0));
            description.Segments.Add(new SegmentInfo("b", "B", 1, 1));
            LabelMap map = LabelMap.FromVolumeData(Layers(description, new byte[] { 1, 0, 0, 1, 0, 0, 0, 0 }));
            Assert.That(map.Segments.Select(segment => segment.Name + " " + segment.Label), Is.EqualTo(new[] { "Unlabelled 0", "A 1", "B 2" }));
            Assert.That(map.Indices, Is.EqualTo(new ushort[] { 1, 2, 0, 0 }));
            Assert.That(map.Warnings, Has.Some.Contains("becomes label 2"));
        }

        [Test]
        public void ValuesThatNoSegmentNames_AreKeptWithAWarning()
        {
            var description = new VolumeDescription();
            description.Segments.Add(new SegmentInfo("a", "A", 1));
            var data = new VolumeData(new VolumeGeometry(3, 1, 1, Affine.Identity), new byte[] { 0, 1, 6 }, description: description);
            LabelMap map = LabelMap.FromVolumeData(data);
            Assert.That(map.Segments.Select(segment => segment.Name), Is.EqualTo(new[] { "Unlabelled", "A", "Label 6" }));
            Assert.That(map.Warnings, Has.Some.Contains("values 6"));
        }

        [Test]
        public void SegmentWithoutColour_TakesThatOfItsName()
        {
            var description = new VolumeDescription();
            description.Segments.Add(new SegmentInfo("a", "Liver", 200));
            description.Segments.Add(new SegmentInfo("b", "something else", 3));
            description.Segments.Add(new SegmentInfo("c", "spleen", 9, 0, new SegmentColor(1, 2, 3)));
            var data = new VolumeData(new VolumeGeometry(2, 1, 1, Affine.Identity), new byte[] { 0, 200 }, description: description);
            SegmentTable table = LabelMap.FromVolumeData(data).Segments;
            Assert.That(table.FindByName("liver").Color, Is.EqualTo(new SegmentColor(221, 130, 101)));
            Assert.That(table.FindByName("something else").Color, Is.EqualTo(PredefinedSegmentColors.ForLabel(3)));
            Assert.That(table.FindByName("spleen").Color, Is.EqualTo(new SegmentColor(1, 2, 3)));
        }

        [Test]
        public void SegmentedVolume_OfDifferentGrids_IsRefused()
        {
            IntensityVolume scan = IntensityVolume.FromVolumeData(Line(new byte[4]));
            LabelMap other = LabelMap.FromVolumeData(Line(new byte[5]));
            Assert.That(() => new SegmentedVolume(scan, other), Throws.TypeOf<VolumeMismatchException>());
            Assert.That(SegmentedVolume.Unsegmented(scan).Segments, Has.Count.EqualTo(1));
        }

        [Test]
        public void IndexWithoutARow_IsRefused()
        {
            var geometry = new VolumeGeometry(1, 1, 1, Affine.Identity);
            Assert.That(() => new LabelMap(geometry, new ushort[] { 1 }, SegmentTable.UnlabelledOnly()), Throws.ArgumentException);
        }

        static VolumeData Line(Array voxels) => new VolumeData(new VolumeGeometry(voxels.Length, 1, 1, Affine.Identity), voxels);

        static VolumeData Layers(VolumeDescription description, byte[] voxels) =>
            new VolumeData(new VolumeGeometry(voxels.Length / 2, 1, 1, Affine.Identity), voxels, 2, description: description);
    }
}
