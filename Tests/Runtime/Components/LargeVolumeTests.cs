using System;
using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Carving;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Volumes that are too large for the device, and volumes that are shown coarse first; with a small budget and a low threshold.</summary>
    sealed class LargeVolumeTests : PlayModeScene
    {
        /// <summary>64^3 voxels: 1.75 MiB on the GPU.</summary>
        static readonly SegmentedVolume Patient = Phantoms.Markers(64);

        NrrdFiles files;
        VolumeLoader loader;
        CarvedVolumeRenderer shown;
        List<string> events;

        [SetUp]
        public void MakeLoader()
        {
            files = new NrrdFiles();
            GameObject o = Make("Volume", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer));
            loader = o.GetComponent<VolumeLoader>();
            shown = o.GetComponent<CarvedVolumeRenderer>();
            shown.TransferFunction = Opaque();
            events = new List<string>();
            loader.Forecast += forecast => events.Add("forecast");
            loader.CoarseLoaded += volume => events.Add("coarse");
            loader.Loaded += volume => events.Add("loaded");
            loader.Failed += e => events.Add("failed");
        }

        [TearDown]
        public void RemoveFiles() => files.Dispose();

        [UnityTest]
        public IEnumerator Volume_ThatTheDeviceCannotHold_IsMadeCoarserWithAWarning([Values] bool fromFiles)
        {
            loader.Memory.BudgetMiB = 1;
            LogAssert.Expect(LogType.Warning, new Regex(
                "^(ct.nrrd|Patient): the volume was made coarser, from 64 x 64 x 64 to \\d+ x \\d+ x \\d+ voxels, as it needs 1.\\d MiB on the GPU and the budget has 1.0 MiB"));
            Task<SegmentedVolume> load = Load(fromFiles);
            yield return Finished(load);
            VolumeGeometry coarse = load.Result.Geometry;
            Assert.That((coarse.SizeI, coarse.SizeJ, coarse.SizeK), Is.EqualTo((32, 64, 64)), "the smallest factor that fits");
            Assert.That(MemoryForecast.Of(load.Result).GpuBytes, Is.LessThanOrEqualTo(1 << 20));
            Assert.That(load.Result.Warnings, Has.Exactly(1).Contains("was made coarser"));
            Assert.That(events, Is.EqualTo(new[] { "forecast", "loaded" }));
            Assert.That(coarse.CentreLps.DistanceTo(Patient.Geometry.CentreLps), Is.LessThan(1e-9));
        }

        [UnityTest]
        public IEnumerator Volume_ThatTheDeviceCannotHold_IsRefusedBeforeItIsRead_IfSoSet([Values] bool fromFiles)
        {
            loader.Memory.BudgetMiB = 1;
            loader.Memory.WhenTooLarge = WhenTooLarge.Refuse;
            var reports = new Reports();
            Task<SegmentedVolume> load = Load(fromFiles, reports);
            yield return Finished(load);
            Assert.That(load.Exception.InnerException, Is.InstanceOf<VolumeTooLargeException>());
            Assert.That(load.Exception.InnerException.Message, Does.Match(
                "^(ct.nrrd|Patient): the volume of 64 x 64 x 64 voxels cannot be held, as it needs 1.\\d MiB on the GPU and the budget has 1.0 MiB for it; "
                + "32 x 64 x 64 voxels would fit: set When Too Large to Downsample, raise the budget, or resample or crop the scan\\.$"));
            Assert.That(reports.Last, Is.Zero, "nothing was read");
            Assert.That(loader.Volume, Is.Null);
            Assert.That(events, Is.EqualTo(new[] { "forecast", "failed" }));
        }

        [UnityTest]
        public IEnumerator Volume_OfMoreSegmentsThanItsHeaderSays_IsRefusedWhenItHasBeenRead()
        {
            // 300 segments take 8 bytes per voxel, which shows only in the voxels: at 7 bytes 51^3 of them would fit.
            SegmentedVolume many = Many(51, 300);
            var reports = new Reports();
            loader.Memory.BudgetMiB = 1;
            loader.Memory.WhenTooLarge = WhenTooLarge.Refuse;
            Task<SegmentedVolume> load = loader.LoadAsync(files.WriteIntensity("ct.nrrd", many), files.WriteLabels("labels.nrrd", many), default, reports);
            yield return Finished(load);
            Assert.That(reports.Last, Is.GreaterThan(0.8f), "all was read");
            Assert.That(load.Exception?.InnerException, Is.InstanceOf<VolumeTooLargeException>());
        }

        [UnityTest]
        public IEnumerator Volume_ThatFits_IsLoadedAsItIs()
        {
            loader.Memory.BudgetMiB = 2;
            Task<SegmentedVolume> load = Load(false);
            yield return Finished(load);
            Assert.That(load.Result.Geometry.VoxelCount, Is.EqualTo(Patient.Geometry.VoxelCount));
            Assert.That(load.Result.Warnings, Is.Empty);
        }

        [UnityTest]
        public IEnumerator Load_CancelledByWhoHearsItsForecast_LoadsNothing([Values] bool fromFiles)
        {
            loader.Forecast += forecast => loader.Cancel();
            Task<SegmentedVolume> load = Load(fromFiles);
            yield return Finished(load);
            Assert.That(load.IsCanceled, Is.True);
            Assert.That(loader.Volume, Is.Null);
            Assert.That(events, Is.EqualTo(new[] { "forecast" }));
        }

        [UnityTest]
        public IEnumerator LargeVolume_IsShownCoarseFirst_AndSeenInEveryFrame([Values] bool fromFiles)
        {
            loader.Memory.CoarseAboveVoxels = 10000;
            int coarseFrame = 0, loadedFrame = 0;
            loader.CoarseLoaded += volume =>
            {
                Assert.That(volume.Geometry.VoxelCount, Is.LessThanOrEqualTo(10000));
                Assert.That((loader.Volume, loader.IsCoarse), Is.EqualTo((volume, true)));
                coarseFrame = Time.frameCount;
            };
            loader.Loaded += volume => loadedFrame = Time.frameCount;
            Task<SegmentedVolume> load = Load(fromFiles);
            while (!load.IsCompleted)
            {
                if (loader.Volume != null)
                    Assert.That(Count(shown.Render(FrontView(Patient)).Read(), Phantoms.Anterior), Is.GreaterThan(0));
                yield return null;
            }
            Assert.That(events, Is.EqualTo(new[] { "forecast", "coarse", "loaded" }));
            Assert.That(loadedFrame, Is.GreaterThan(coarseFrame), "at least a frame apart");
            Assert.That((loader.Volume, loader.IsCoarse), Is.EqualTo((load.Result, false)));
            Assert.That(load.Result.Labels.Indices, Is.EqualTo(Patient.Labels.Indices));
        }

        [UnityTest]
        public IEnumerator Carving_OfACoarseVolume_HoldsInTheWholeOne([Values] bool fromFiles)
        {
            loader.Memory.CoarseAboveVoxels = 10000;
            CarvingStack carving = null;
            loader.CoarseLoaded += volume =>
            {
                shown.Stack.SetActive(new Vector3(0f, 0f, -0.014f), 0.003f);
                shown.Stack.ToggleSegment(Phantoms.Left);
                shown.Segments = shown.Segments.WithOpacity(Phantoms.Right, 0f);
                carving = shown.Stack.Carving;
            };
            yield return Finished(Load(fromFiles));
            yield return null;
            Assert.That(shown.Stack.Carving, Is.SameAs(carving));
            Assert.That(shown.Stack.Carving.Active.Mask[Phantoms.Left], Is.False);
            Assert.That(shown.Segments[Phantoms.Right].Opacity, Is.Zero);
            PictureData afterCoarse = shown.Render(FrontView(Patient)).Read();

            CarvedVolumeRenderer direct = MakeVolume(Patient);
            direct.Stack.SetActive(new Vector3(0f, 0f, -0.014f), 0.003f);
            direct.Stack.ToggleSegment(Phantoms.Left);
            direct.Segments = direct.Segments.WithOpacity(Phantoms.Right, 0f);
            PictureData expected = direct.Render(FrontView(Patient)).Read();
            Assert.That(afterCoarse.Segments, Is.EqualTo(expected.Segments));
        }

        [UnityTest]
        public IEnumerator Carving_OfAnotherVolume_IsNotKept()
        {
            loader.SetVolume(Patient);
            shown.Stack.SetActive(Vector3.zero, 0.01f);
            yield return null;
            loader.SetVolume(new SegmentedVolume(Patient.Intensity, Patient.Labels));
            Assert.That(shown.Stack.Carving.Active, Is.Null);
        }

        [UnityTest]
        public IEnumerator LargeVolume_WhereAnotherIsShown_IsNotShownCoarse()
        {
            SegmentedVolume before = Phantoms.Cube(8, "Cube");
            loader.SetVolume(before);
            loader.Memory.CoarseAboveVoxels = 10000;
            Task<SegmentedVolume> load = Load(false);
            while (!load.IsCompleted)
            {
                Assert.That(loader.Volume, Is.SameAs(before));
                yield return null;
            }
            Assert.That(events, Is.EqualTo(new[] { "loaded", "forecast", "loaded" }));
        }

        [UnityTest]
        public IEnumerator CoarseVolume_OfALoadThatFails_IsTakenAway()
        {
            loader.Memory.CoarseAboveVoxels = 1 << 20;
            Task<SegmentedVolume> load = loader.LoadAsync(Damaged());
            SegmentedVolume whenItFailed = Patient;
            loader.Failed += e => whenItFailed = loader.Volume;
            yield return Finished(load);
            Assert.That(events, Is.EqualTo(new[] { "forecast", "coarse", "failed" }));
            Assert.That(load.Exception.InnerException, Is.InstanceOf<VolumeFormatException>());
            Assert.That(whenItFailed, Is.Null);
            Assert.That((loader.Volume, loader.IsCoarse), Is.EqualTo(((SegmentedVolume)null, false)));
        }

        [UnityTest]
        public IEnumerator CoarseVolume_OfALoadThatIsCancelled_IsTakenAway([Values] bool byItsToken)
        {
            using var source = new CancellationTokenSource();
            loader.Memory.CoarseAboveVoxels = 10000;
            loader.CoarseLoaded += volume =>
            {
                if (byItsToken)
                    source.Cancel();
                else
                    loader.Cancel();
            };
            Task<SegmentedVolume> load = loader.LoadAsync(Own(VolumeAsset.Create(Patient, "Patient")), source.Token);
            yield return Finished(load);
            Assert.That(load.IsCanceled, Is.True);
            Assert.That((loader.Volume, loader.IsCoarse), Is.EqualTo(((SegmentedVolume)null, false)));
            Assert.That(events, Is.EqualTo(new[] { "forecast", "coarse" }));
        }

        [UnityTest]
        public IEnumerator Volume_ThatIsMadeCoarser_IsShownCoarseFirstToo()
        {
            loader.Memory.BudgetMiB = 1;
            loader.Memory.CoarseAboveVoxels = 10000;
            LogAssert.Expect(LogType.Warning, new Regex("was made coarser"));
            object origin = null;
            loader.CoarseLoaded += volume => origin = volume.Origin;
            Task<SegmentedVolume> load = Load(false);
            yield return Finished(load);
            Assert.That(events, Is.EqualTo(new[] { "forecast", "coarse", "loaded" }));
            Assert.That(load.Result.Origin, Is.SameAs(origin));
        }

        Task<SegmentedVolume> Load(bool fromFiles, IProgress<float> progress = null) => fromFiles
            ? loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient), files.WriteLabels("labels.nrrd", Patient), default, progress)
            : loader.LoadAsync(Own(VolumeAsset.Create(Patient, "Patient")), default, progress);

        /// <summary>An asset whose first slice is damaged: the middle slices of coarse cells are whole.</summary>
        VolumeAsset Damaged()
        {
            var grid = new VolumeGeometry(512, 512, 8, Affine.FromColumns(new VectorMm(1, 0, 0), new VectorMm(0, 1, 0), new VectorMm(0, 0, 0.1), default));
            var codes = new ushort[grid.VoxelCount];
            for (int v = 0; v < codes.Length; v++)
                codes[v] = (ushort)(v * 31 % 1000);
            SegmentedVolume volume = SegmentedVolume.Unsegmented(new IntensityVolume(grid, codes, 0, 1, 1000));
            byte[] packed = PackedVolume.Write(volume);
            packed[PackedVolume.ReadInfo(packed, "packed").HeaderBytes] ^= 0x55;
            VolumeAsset asset = Own(VolumeAsset.Create(volume, packed, new byte[4], new string[0]));
            Own(asset.Data);
            Own(asset.Thumbnail);
            return asset;
        }

        static SegmentedVolume Many(int size, int segments)
        {
            var grid = new VolumeGeometry(size, size, size, Affine.Identity);
            var indices = new ushort[grid.VoxelCount];
            for (int v = 0; v < indices.Length; v++)
                indices[v] = (ushort)(v % segments);
            var table = new List<Segment>();
            for (int s = 0; s < segments; s++)
                table.Add(new Segment(s, s, "Segment " + s, new SegmentColor(200, 100, 50)));
            return new SegmentedVolume(new IntensityVolume(grid, new ushort[grid.VoxelCount], 0, 1, 1000), new LabelMap(grid, indices, new SegmentTable(table)));
        }

        static IEnumerator Finished(Task task)
        {
            while (!task.IsCompleted)
                yield return null;
        }

        sealed class Reports : IProgress<float>
        {
            volatile float last;

            public float Last => last;

            public void Report(float value) => last = value;
        }
    }
}
