using System;
using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>What a volume is said to take, against what it takes.</summary>
    sealed class MemoryForecastTests : PlayModeScene
    {
        [Test]
        public void GpuBytes_OfAVolume_AreWhatIsResident(
            [Values("20 20 20", "17 9 33", "65 64 3", "1 1 1")] string size, [Values(1, 255, 256, 1500)] int segments,
            [Values(TextureLayout.Compact, TextureLayout.Portable)] TextureLayout layout)
        {
            SegmentedVolume volume = Make(size, segments);
            CarvedVolumeRenderer renderer = MakeVolume(volume);
            renderer.Layout = layout;
            renderer.TransferFunction = OpacityTransferFunction.Constant(1); // so that all of it has to be stored
            CarvedPicture picture = renderer.Render(FrontView(volume, 8));
            MemoryForecast forecast = MemoryForecast.Of(volume, "volume", layout);
            Assert.That(renderer.Statistics.Layout, Is.EqualTo(layout));
            Assert.That(forecast.GpuBytes, Is.EqualTo(renderer.Statistics.BytesResident - picture.Bytes));
            Assert.That(forecast.GpuBytes, Is.EqualTo(renderer.Statistics.VolumeBytesResident));
            Assert.That(forecast.CpuBytes, Is.EqualTo(2L * volume.Intensity.Codes.Length + 2L * volume.Labels.Indices.Length));
        }

        [Test]
        public void GpuBytes_OfALargeVolume_ComeToSevenPerVoxel_EightAbove255Segments([Values(255, 256)] int segments, [Values] TextureLayout layout)
        {
            VolumeLimits limits = VolumeLimits.OfDevice(layout, 0);
            var grid = new VolumeGeometry(512, 512, 600, Affine.Identity);
            double bytes = new MemoryForecast("ct", grid, segments, segments, 0, limits).GpuBytesPerVoxel;
            Assert.That(bytes, Is.EqualTo(segments > 255 ? 8.05 : 7.05).Within(0.002));
        }

        [Test]
        public void Forecast_OfAnAsset_IsThatOfItsVolume()
        {
            SegmentedVolume volume = Phantoms.Markers(20);
            VolumeAsset asset = Own(VolumeAsset.Create(volume, "Patient"));
            MemoryForecast ofAsset = MemoryForecast.Of(asset), ofVolume = MemoryForecast.Of(volume);
            Assert.That((ofAsset.SizeI, ofAsset.SizeJ, ofAsset.SizeK, ofAsset.SegmentCount, ofAsset.GpuBytes, ofAsset.CpuBytes),
                Is.EqualTo((ofVolume.SizeI, ofVolume.SizeJ, ofVolume.SizeK, ofVolume.SegmentCount, ofVolume.GpuBytes, ofVolume.CpuBytes)));
            Assert.That(ofAsset.CpuPeakBytes, Is.EqualTo(4 * 20 * 20 * 20 + asset.PackedBytes));
        }

        [Test]
        public void Forecast_OfAnAssetWithoutBytes_IsRefusedClearly()
        {
            var empty = Own(ScriptableObject.CreateInstance<VolumeAsset>());
            empty.name = "Empty";
            Assert.That(() => MemoryForecast.Of(empty), Throws.InstanceOf<AnatomyCarveException>().With.Message.Contains("Empty"));
        }

        [UnityTest]
        public IEnumerator Forecast_OfFiles_KnowsTheirVoxelsAndCountsTheMostLabels()
        {
            using var files = new NrrdFiles();
            SegmentedVolume volume = Phantoms.Markers(20);
            Task<MemoryForecast> forecast = MemoryForecast.OfFilesAsync(files.WriteIntensity("ct.nrrd", volume), files.WriteLabels("labels.nrrd", volume));
            while (!forecast.IsCompleted)
                yield return null;
            long voxels = volume.Geometry.VoxelCount;
            Assert.That(forecast.Result.SegmentCount, Is.Zero, "the header does not say");
            Assert.That(forecast.Result.GpuBytes, Is.GreaterThanOrEqualTo(MemoryForecast.Of(volume).GpuBytes));
            Assert.That(forecast.Result.CpuBytes, Is.EqualTo(4 * voxels));
            Assert.That(forecast.Result.CpuPeakBytes, Is.EqualTo(6 * voxels), "codes, the labels as they are stored, and their indices");
        }

        [UnityTest]
        public IEnumerator Forecast_OfAFileWithoutLabels_HasOneSegment()
        {
            using var files = new NrrdFiles();
            SegmentedVolume volume = Phantoms.Markers(20);
            Task<MemoryForecast> forecast = MemoryForecast.OfFilesAsync(files.WriteIntensity("ct.nrrd", volume));
            while (!forecast.IsCompleted)
                yield return null;
            Assert.That(forecast.Result.GpuBytes, Is.EqualTo(MemoryForecast.Of(SegmentedVolume.Unsegmented(volume.Intensity)).GpuBytes));
        }

        [UnityTest]
        public IEnumerator Forecast_OfAFileThatIsNone_Fails()
        {
            using var files = new NrrdFiles();
            Task<MemoryForecast> forecast = MemoryForecast.OfFilesAsync(files.WriteText("bad.nrrd", "NRRD0004\ntype: nonsense\n\n"));
            while (!forecast.IsCompleted)
                yield return null;
            Assert.That(forecast.Exception.InnerException, Is.InstanceOf<VolumeFormatException>());
        }

        [Test]
        public void Sentence_SaysSizeAndMemory() =>
            Assert.That(MemoryForecast.Of(Make("128 128 64", 3), "ct.nii.gz").ToString(), Does.Match(
                @"^ct\.nii\.gz: 128 x 128 x 64 voxels take at most \d+\.\d MiB on the GPU \(7\.\d\d bytes per voxel\) and 4\.0 MiB of main memory, 4\.0 MiB while they load\.$"));

        [TestCase(8192, 32768, false, 6144)]
        [TestCase(0, 8192, false, 2048, Description = "graphics memory unknown: main memory is shared")]
        [TestCase(512, 16384, false, 4096, Description = "a window on main memory")]
        [TestCase(4096, 8192, true, 2048, Description = "mobile: shared, whatever it says")]
        [TestCase(2048, 0, true, 1536)]
        public void Memory_ThatADeviceHasForAVolume_IsAShareOfItsOwnOrOfMainMemory(int graphicsMiB, int systemMiB, bool isMobile, int expectedMiB) =>
            Assert.That(VolumeLimits.Available(graphicsMiB, systemMiB, isMobile), Is.EqualTo((long)expectedMiB << 20));

        [Test]
        public void Memory_OfADeviceThatDoesNotSay_IsNoLimit() => Assert.That(VolumeLimits.Available(0, 0, false), Is.EqualTo(long.MaxValue));

        [Test]
        public void Sides_LongerThanTheDevicesTextures_DoNotFit([Values(0, 1, 2)] int axis)
        {
            VolumeLimits limits = VolumeLimits.OfDevice(TextureLayout.Automatic, 0);
            int longest = DeviceSupport.LargestSide;
            Assert.That(Hold(longest), Is.True);
            Assert.That(Hold(longest + 1), Is.False);

            bool Hold(int side) => limits.Hold(axis == 0 ? side : 1, axis == 1 ? side : 1, axis == 2 ? side : 1, 1);
        }

        [Test]
        public void Voxels_MoreThanATextureHolds_DoNotFit()
        {
            VolumeLimits limits = VolumeLimits.OfDevice(TextureLayout.Automatic, int.MaxValue);
            Assert.That(limits.Hold(1024, 1024, 1023, 1), Is.True);
            Assert.That(limits.Hold(1024, 1024, 1024, 1), Is.False);
        }

        [Test]
        public void Settings_BelowZero_AreRefused()
        {
            var settings = new MemorySettings();
            Assert.That(() => settings.BudgetMiB = -1, Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => settings.CoarseAboveVoxels = -1, Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        static SegmentedVolume Make(string size, int segments)
        {
            int[] sides = Array.ConvertAll(size.Split(' '), int.Parse);
            var grid = new VolumeGeometry(sides[0], sides[1], sides[2], Affine.Identity);
            var table = new List<Segment>();
            for (int s = 0; s < segments; s++)
                table.Add(new Segment(s, s, "Segment " + s, new SegmentColor(200, 100, 50)));
            return new SegmentedVolume(
                new IntensityVolume(grid, new ushort[grid.VoxelCount], 0, 1, 1000), new LabelMap(grid, new ushort[grid.VoxelCount], new SegmentTable(table)));
        }
    }
}
