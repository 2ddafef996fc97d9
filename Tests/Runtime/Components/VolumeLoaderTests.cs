using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Text.RegularExpressions;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Loading from files and memory: what is published, when, and what stays when it fails.</summary>
    sealed class VolumeLoaderTests : PlayModeScene
    {
        static readonly SegmentedVolume Patient = Phantoms.Markers(20);

        NrrdFiles files;
        VolumeLoader loader;
        List<string> events;

        [SetUp]
        public void MakeLoader()
        {
            files = new NrrdFiles();
            loader = Make("Volume").AddComponent<VolumeLoader>();
            events = new List<string>();
            loader.Loaded += v => events.Add("loaded");
            loader.Failed += e => events.Add("failed " + e.GetType().Name);
        }

        [TearDown]
        public void RemoveFiles() => files.Dispose();

        [UnityTest]
        public IEnumerator Load_OfTwoFiles_PublishesTheVolume()
        {
            Task<SegmentedVolume> load = loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient), files.WriteLabels("labels.nrrd", Patient));
            yield return Finished(load);
            Assert.That(loader.Volume, Is.SameAs(load.Result));
            Assert.That(loader.Volume.Labels.Indices, Is.EqualTo(Patient.Labels.Indices));
            Assert.That(loader.Volume.Intensity.Codes, Is.EqualTo(Patient.Intensity.Codes));
            Assert.That(loader.Volume.Geometry.Matches(Patient.Geometry, out string difference), Is.True, difference);
            Assert.That(events, Is.EqualTo(new[] { "loaded" }));
            Assert.That(loader.IsLoading, Is.False);
            Assert.That(loader.Progress, Is.EqualTo(1f));
        }

        [UnityTest]
        public IEnumerator Load_WithoutLabels_IsUnlabelled()
        {
            Task<SegmentedVolume> load = loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient));
            yield return Finished(load);
            Assert.That(loader.Volume.Segments.Count, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator Load_RaisesLoaded_OnTheMainThread()
        {
            Thread main = Thread.CurrentThread;
            Thread raised = null;
            loader.Loaded += v => raised = Thread.CurrentThread;
            yield return Finished(loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient)));
            Assert.That(raised, Is.SameAs(main));
        }

        [UnityTest]
        public IEnumerator Load_Progress_RisesToOne()
        {
            var reported = new Reports();
            yield return Finished(loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient), files.WriteLabels("labels.nrrd", Patient), default, reported));
            float[] values = reported.Values();
            Assert.That(values, Is.Ordered);
            Assert.That(values[0], Is.Zero);
            Assert.That(values[values.Length - 1], Is.EqualTo(1f));
        }

        [UnityTest]
        public IEnumerator Load_OfABadFile_KeepsWhatWasThere()
        {
            loader.SetVolume(Patient);
            Task<SegmentedVolume> load = loader.LoadAsync(files.WriteText("bad.nrrd", "NRRD0004\ntype: nonsense\n\n"));
            yield return Finished(load);
            Assert.That(load.Exception.InnerException, Is.InstanceOf<VolumeFormatException>());
            Assert.That(loader.Volume, Is.SameAs(Patient));
            Assert.That(events, Is.EqualTo(new[] { "loaded", "failed VolumeFormatException" }));
        }

        [UnityTest]
        public IEnumerator Load_OfFilesOnDifferentGrids_Fails()
        {
            SegmentedVolume other = Phantoms.Markers(16);
            Task<SegmentedVolume> load = loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient), files.WriteLabels("labels.nrrd", other));
            yield return Finished(load);
            Assert.That(load.Exception.InnerException, Is.InstanceOf<VolumeMismatchException>());
            Assert.That(loader.Volume, Is.Null);
        }

        [UnityTest]
        public IEnumerator Load_WhileItReads_IsLoading()
        {
            using (var gate = new Gate())
            {
                Task<SegmentedVolume> load = loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient), null, default, gate);
                Assert.That(loader.IsLoading, Is.True);
                Assert.That(loader.Volume, Is.Null);
                gate.Open();
                yield return Finished(load);
            }
            Assert.That(loader.IsLoading, Is.False);
        }

        [UnityTest]
        public IEnumerator Load_Cancelled_KeepsWhatWasThereAndIsNoFailure()
        {
            loader.SetVolume(Patient);
            using (var source = new CancellationTokenSource())
            using (var gate = new Gate())
            {
                Task<SegmentedVolume> load = loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient), null, source.Token, gate);
                source.Cancel();
                gate.Open();
                yield return Finished(load);
                Assert.That(load.IsCanceled, Is.True);
            }
            Assert.That(loader.Volume, Is.SameAs(Patient));
            Assert.That(events, Is.EqualTo(new[] { "loaded" }));
        }

        [UnityTest]
        public IEnumerator Load_WhileAnotherRuns_TakesItsPlaceAndItsProgress()
        {
            string path = files.WriteIntensity("ct.nrrd", Patient);
            using (var gate = new Gate())
            {
                Task<SegmentedVolume> first = loader.LoadAsync(path, null, default, gate);
                Task<SegmentedVolume> second = loader.LoadAsync(path, files.WriteLabels("labels.nrrd", Patient));
                yield return Finished(second);
                gate.Open();
                yield return Finished(first);
                Assert.That(first.IsCanceled, Is.True);
                Assert.That(loader.Volume, Is.SameAs(second.Result));
            }
            Assert.That(loader.Progress, Is.EqualTo(1f));
            Assert.That(events, Is.EqualTo(new[] { "loaded" }));
        }

        [UnityTest]
        public IEnumerator Loader_DestroyedWhileItLoads_PublishesNothing()
        {
            using (var gate = new Gate())
            {
                Task<SegmentedVolume> load = loader.LoadAsync(files.WriteIntensity("ct.nrrd", Patient), null, default, gate);
                Object.DestroyImmediate(loader.gameObject);
                gate.Open();
                yield return Finished(load);
                Assert.That(load.IsCanceled, Is.True);
            }
            Assert.That(events, Is.Empty);
        }

        [UnityTest]
        public IEnumerator Load_OfAnOddFile_LogsWhatWasOddWithItsName()
        {
            string path = files.WriteText("odd.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1 1 1\nencoding: ascii\n\n7\n");
            LogAssert.Expect(LogType.Warning, new Regex("^odd\\.nrrd: .*no space directions"));
            Task<SegmentedVolume> load = loader.LoadAsync(path, path);
            yield return Finished(load);
            Assert.That(load.Result.Warnings, Has.Count.GreaterThanOrEqualTo(2).And.All.StartsWith("odd.nrrd: "), "one of each file at least");
        }

        [UnityTest]
        public IEnumerator Load_OfSeveralValuesPerVoxel_WarnsThatOneIsShown()
        {
            string path = files.WriteText("colour.nrrd", "NRRD0004\ntype: uint8\ndimension: 4\nspace: left-posterior-superior\nsizes: 3 1 1 1\n"
                + "kinds: vector domain domain domain\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nencoding: ascii\n\n7 8 9\n");
            Task<SegmentedVolume> load = loader.LoadAsync(path);
            yield return Finished(load);
            Assert.That(load.Result.Warnings, Has.Exactly(1).Contains("3 values per voxel"));
        }

        [UnityTest]
        public IEnumerator Load_OfARelativePath_LooksInStreamingAssets()
        {
            Task<SegmentedVolume> load = loader.LoadAsync("no-such-file.nrrd");
            yield return Finished(load);
            Assert.That(load.Exception.InnerException.Message, Does.Contain(Application.streamingAssetsPath));
        }

        [UnityTest]
        public IEnumerator Start_WithPaths_LoadsThem()
        {
            VolumeLoader starting = StartWith(files.WriteIntensity("ct.nrrd", Patient), files.WriteLabels("labels.nrrd", Patient));
            yield return Until(() => starting.Volume != null);
            Assert.That(starting.Volume, Is.Not.Null);
            Assert.That(starting.Volume.Segments.Count, Is.EqualTo(Patient.Segments.Count));
        }

        [UnityTest]
        public IEnumerator Start_WithABadPath_SaysSoOnce()
        {
            LogAssert.Expect(LogType.Exception, new Regex("missing\\.nrrd"));
            VolumeLoader starting = StartWith(files.PathOf("missing.nrrd"), "");
            int failures = 0;
            starting.Failed += e => failures++;
            yield return Until(() => failures > 0);
            yield return null;
            Assert.That(failures, Is.EqualTo(1));
        }

        [Test]
        public void Load_OfNothing_IsRefused()
        {
            Assert.That(() => loader.LoadAsync(""), Throws.ArgumentException);
            Assert.That(() => loader.LoadAsync((VolumeAsset)null), Throws.ArgumentNullException);
            Assert.That(() => loader.LoadAsync((byte[])null), Throws.ArgumentNullException);
        }

        [Test]
        public void SetVolume_Null_IsRefused() => Assert.That(() => loader.SetVolume(null), Throws.ArgumentNullException);

        /// <summary>A loader whose paths are set before it starts.</summary>
        VolumeLoader StartWith(string intensityPath, string labelsPath)
        {
            GameObject o = Make("Starting volume");
            o.SetActive(false);
            var starting = o.AddComponent<VolumeLoader>();
            starting.IntensityPath = intensityPath;
            starting.LabelsPath = labelsPath;
            o.SetActive(true);
            return starting;
        }

        static IEnumerator Finished(Task task)
        {
            while (!task.IsCompleted)
                yield return null;
        }

        /// <summary>Frames until something has happened on another thread; frames without a display may be very short.</summary>
        static IEnumerator Until(Func<bool> happened)
        {
            var clock = Stopwatch.StartNew();
            while (!happened() && clock.Elapsed < TimeSpan.FromSeconds(60))
                yield return null;
        }

        /// <summary>Holds the thread that reads, at its first report, until it is opened.</summary>
        sealed class Gate : IProgress<float>, IDisposable
        {
            readonly Thread main = Thread.CurrentThread;
            readonly ManualResetEventSlim open = new ManualResetEventSlim();

            public void Open() => open.Set();

            public void Report(float value)
            {
                if (Thread.CurrentThread != main)
                    open.Wait(TimeSpan.FromSeconds(60));
            }

            public void Dispose() => open.Set();
        }

        sealed class Reports : IProgress<float>
        {
            readonly List<float> values = new List<float>();

            public void Report(float value)
            {
                lock (values)
                    values.Add(value);
            }

            public float[] Values()
            {
                lock (values)
                    return values.ToArray();
            }
        }
    }
}
