using System;
using System.Collections.Generic;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    /// <summary>Every damaged file of ../shared/data/readers: refused with a clear message or read, never a crash or a large allocation.</summary>
    public sealed class MalformedFileTests
    {
        const string Folder = "readers";

        /// <summary>What reading a small damaged file may allocate in all: far more than they hold, far less than their headers claim.</summary>
        const long LargestAllocation = 64L << 20;

        static IEnumerable<string> Files() => SharedData.FilesIn(Folder, "malformed");

        [TestCaseSource(nameof(Files))]
        public void MalformedFile_Read_IsHandledAsExpected(string file)
        {
            JObject expected = SharedData.Expected(Folder, "malformed", file);
            string path = SharedData.PathOf(Folder + "/" + file);
            VolumeData data = null;
            VolumeFormatException refusal = null;
            long before = GC.GetAllocatedBytesForCurrentThread();
            try
            {
                data = VolumeReader.Read(path);
            }
            catch (VolumeFormatException problem)
            {
                refusal = problem;
            }

            long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
            Assert.That(allocated, Is.LessThan(LargestAllocation));
            if ((string)expected["expect"] == "refuse")
                Assert.That(refusal, Is.Not.Null, "should be refused: " + expected["why"]);
            if (refusal != null)
            {
                Assert.That(refusal.Message, Does.StartWith(path + ": ").And.EndWith("."));
                Assert.That(new[] { refusal.File, refusal.Field, refusal.FoundValue, refusal.Expectation }, Has.None.Null.And.None.Empty);
                TestContext.WriteLine(refusal.Message);
            }
            else
            {
                Assert.That(data.Statistics().Count, Is.EqualTo(data.Geometry.VoxelCount * data.Components));
                TestContext.WriteLine("read; warnings: " + string.Join(" ", data.Warnings));
            }
        }

        [TestCase("bad/nrrd_gz_two_members.nrrd", "nrrd/gzip_int16_le.nrrd")]
        [TestCase("bad/nrrd_raw_too_long.nrrd", "nrrd/raw_int16_le.nrrd")]
        [TestCase("bad/nii_pixdim_neg.nii", "nifti/n1_int16_le.nii")]
        [TestCase("bad/nii_bitpix.nii", "nifti/n1_int16_le.nii")]
        [TestCase("bad/nii_voxoff_zero.nii", "nifti/n1_int16_le.nii")]
        public void OddButReadableFile_Read_HasTheVoxelsOfTheIntactOne(string odd, string intact)
        {
            VolumeData read = VolumeReader.Read(SharedData.PathOf(Folder + "/" + odd));
            VolumeData reference = VolumeReader.Read(SharedData.PathOf(Folder + "/" + intact));
            Assert.That(read.Voxels, Is.EqualTo(reference.Voxels));
        }

        [Test]
        public void SegmentColorThatIsText_Read_WarnsAndLeavesTheColourOut()
        {
            VolumeData data = VolumeReader.Read(SharedData.PathOf(Folder + "/bad/seg_color_bad.seg.nrrd"));
            Assert.That(data.Segments, Has.Some.Matches<SegmentInfo>(segment => segment.Color == null));
            Assert.That(data.Warnings, Has.Some.Contains("_Color"));
        }

        [Test]
        public void SegmentLayerOutOfRange_Read_WarnsAndLeavesTheSegmentOut()
        {
            VolumeData data = VolumeReader.Read(SharedData.PathOf(Folder + "/bad/seg_layer_out_of_range.seg.nrrd"));
            Assert.That(data.Segments, Has.Count.EqualTo(3));
            Assert.That(data.Warnings, Has.Some.Contains("layer"));
        }
    }
}
