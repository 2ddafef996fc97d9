using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using AnatomyCarve.Editor;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>What the Inspectors say about a volume.</summary>
    sealed class VolumeSummaryTests
    {
        [Test]
        public void Lines_OfAVolume_AreTheSameInEachCulture()
        {
            CultureInfo before = Thread.CurrentThread.CurrentCulture;
            try
            {
                Thread.CurrentThread.CurrentCulture = CultureInfo.GetCultureInfo("de-DE");
                Dictionary<string, string> lines = VolumeSummary.Of(Volumes.Small()).ToDictionary(l => l.title, l => l.text);
                Assert.That(lines["Size"], Is.EqualTo("4 x 3 x 2 voxels"));
                Assert.That(lines["Spacing"], Is.EqualTo("0.5 x 1.25 x 2 mm"));
                Assert.That(lines["Extent"], Is.EqualTo("2 x 3.8 x 4 mm"));
                Assert.That(lines["Orientation"], Is.EqualTo("LPS. The first axis runs to the patient's left, the second to the back, the third to the head."));
                Assert.That(lines["Intensities"], Is.EqualTo("-1000.5 to -977.5"));
                Assert.That(lines["Segments"], Is.EqualTo("4"));
                Assert.That(lines["Memory"], Is.EqualTo("0.0 MiB, on the GPU 0.0 MiB"));
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [Test]
        public void Segments_OfAnUnsegmentedVolume_AreNone() => Assert.That(
            VolumeSummary.Of(SegmentedVolume.Unsegmented(Volumes.Small().Intensity)).Single(l => l.title == "Segments").text, Is.EqualTo("none"));

        [Test]
        public void Lines_OfAnAsset_AreThoseOfItsVolumeAndItsFiles()
        {
            VolumeAsset asset = VolumeAsset.Create(Volumes.Small(), new byte[3 << 20], new byte[4], new[] { "ct.nrrd", "ct.seg.nrrd" });
            try
            {
                Dictionary<string, string> lines = VolumeSummary.Of(asset).ToDictionary(l => l.title, l => l.text);
                foreach ((string title, string text) in VolumeSummary.Of(Volumes.Small()))
                    if (title != "Memory")
                        Assert.That(lines[title], Is.EqualTo(text), title);
                Assert.That(lines["Memory"], Is.EqualTo("0.0 MiB, packed 3.0 MiB"));
                Assert.That(lines["Made of"], Is.EqualTo("ct.nrrd, ct.seg.nrrd"));
            }
            finally
            {
                Object.DestroyImmediate(asset.Data);
                Object.DestroyImmediate(asset.Thumbnail);
                Object.DestroyImmediate(asset);
            }
        }

        [Test]
        public void Segments_OfAnAsset_MakeTheVolumesTable()
        {
            SegmentedVolume volume = Volumes.Small();
            VolumeAssetSegment[] listed = AssetSegments.Of(volume.Labels);
            SegmentTable table = AssetTable.Of(listed);
            Assert.That(table.Select(s => s.ToString()), Is.EqualTo(volume.Segments.Select(s => s.ToString())));
            Assert.That(table.Select(s => s.Color), Is.EqualTo(volume.Segments.Select(s => s.Color)));
            Assert.That(AssetTable.VoxelCounts(listed), Is.EqualTo(new[] { 24L, 0L, 0L, 0L, 0L }));
        }

        [Test]
        public void Segments_OfAnEmptyAsset_MakeNoTable() => Assert.That(AssetTable.Of(new VolumeAssetSegment[0]), Is.Null);

        [Test]
        public void Bytes_OfAGibibyte_AreGroupedMebibytes() => Assert.That(VolumeSummary.Bytes(3L << 30), Is.EqualTo("3,072.0 MiB"));
    }
}
