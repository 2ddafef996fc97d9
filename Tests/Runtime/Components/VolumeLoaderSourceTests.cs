using System;
using System.Collections;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>What a loader takes: assets, contents of files; and what it loads by itself.</summary>
    sealed class VolumeLoaderSourceTests : PlayModeScene
    {
        static readonly SegmentedVolume Patient = Phantoms.Markers(20);

        readonly Thread main = Thread.CurrentThread;
        NrrdFiles files;
        VolumeLoader loader;
        VolumeAsset asset;

        [SetUp]
        public void MakeLoader()
        {
            files = new NrrdFiles();
            loader = Make("Volume").AddComponent<VolumeLoader>();
            asset = VolumeAsset.Create(Patient, "Patient");
        }

        [TearDown]
        public void RemoveFiles()
        {
            files.Dispose();
            Object.DestroyImmediate(asset);
        }

        [UnityTest]
        public IEnumerator Asset_Loaded_IsTheVolumeThatItWasMadeOf()
        {
            Task<SegmentedVolume> load = loader.LoadAsync(asset);
            yield return Finished(load);
            AssertIsPatient(load.Result);
            Assert.That(loader.Volume, Is.SameAs(load.Result));
            Assert.That(loader.Progress, Is.EqualTo(1f));
        }

        [UnityTest]
        public IEnumerator Volume_SetInALoadsLastProgress_Stays()
        {
            SegmentedVolume other = Phantoms.Cube(8, "Cube");
            bool set = false;
            Task<SegmentedVolume> load = loader.LoadAsync(asset, default, new Reporter(share =>
            {
                if (share == 1f && Thread.CurrentThread == main)
                {
                    loader.SetVolume(other);
                    set = true;
                }
            }));
            while (!load.IsCompleted)
                yield return null;
            Assert.That(set, Is.True, "the last progress is told on the main thread");
            Assert.That(load.IsCanceled, Is.True);
            Assert.That(loader.Volume, Is.SameAs(other));
        }

        [Test]
        public void Listeners_BehindOneThatSetsAnotherVolume_AreToldOfThatOneLast()
        {
            SegmentedVolume other = Phantoms.Cube(8, "Cube");
            SegmentedVolume last = null;
            loader.Loaded += volume =>
            {
                if (volume != other)
                    loader.SetVolume(other);
            };
            loader.Loaded += volume => last = volume;
            loader.SetVolume(Patient);
            Assert.That(last, Is.SameAs(other));
            Assert.That(loader.Volume, Is.SameAs(other));
        }

        sealed class Reporter : IProgress<float>
        {
            readonly Action<float> report;

            public Reporter(Action<float> report) => this.report = report;

            public void Report(float value) => report(value);
        }

        [UnityTest]
        public IEnumerator Contents_OfFiles_AreLoadedAsTheFiles()
        {
            byte[] intensity = File.ReadAllBytes(files.WriteIntensity("ct.nrrd", Patient)), labels = File.ReadAllBytes(files.WriteLabels("labels.nrrd", Patient));
            Task<SegmentedVolume> load = loader.LoadAsync(intensity, labels);
            yield return Finished(load);
            Assert.That(load.Result.Intensity.Codes, Is.EqualTo(Patient.Intensity.Codes));
            Assert.That(load.Result.Labels.Indices, Is.EqualTo(Patient.Labels.Indices));
        }

        [UnityTest]
        public IEnumerator Contents_ThatAreNoVolume_AreRefusedByTheirName()
        {
            Task<SegmentedVolume> load = loader.LoadAsync(new byte[] { 1, 2, 3 }, null, "the upload");
            while (!load.IsCompleted)
                yield return null;
            Assert.That(load.Exception.InnerException, Is.InstanceOf<VolumeFormatException>());
            Assert.That(load.Exception.InnerException.Message, Does.StartWith("the upload"));
            Assert.That(loader.Volume, Is.Null);
        }

        [UnityTest]
        public IEnumerator Asset_OfAStartingLoader_ComesBeforeFiles()
        {
            GameObject o = Make("Starting volume");
            o.SetActive(false);
            var starting = o.AddComponent<VolumeLoader>();
            starting.Asset = asset;
            starting.IntensityPath = files.PathOf("missing.nrrd");
            o.SetActive(true);
            while (starting.Volume == null)
                yield return null;
            AssertIsPatient(starting.Volume);
        }

        [UnityTest]
        public IEnumerator Asset_SetWhilePlaying_IsNotLoadedByItself()
        {
            yield return null;
            loader.Asset = asset;
            yield return null;
            yield return null;
            Assert.That(loader.IsLoading, Is.False);
            Assert.That(loader.Volume, Is.Null);
        }

        [UnityTest]
        public IEnumerator Asset_WithoutBytes_IsRefusedClearly()
        {
            var empty = ScriptableObject.CreateInstance<VolumeAsset>();
            empty.name = "Empty";
            Task<SegmentedVolume> load = loader.LoadAsync(empty);
            while (!load.IsCompleted)
                yield return null;
            Object.DestroyImmediate(empty);
            Assert.That(load.Exception.InnerException, Is.InstanceOf<AnatomyCarveException>());
            Assert.That(load.Exception.InnerException.Message, Does.Contain("Empty"));
        }

        static void AssertIsPatient(SegmentedVolume volume)
        {
            Assert.That(volume.Intensity.Codes, Is.EqualTo(Patient.Intensity.Codes));
            Assert.That(volume.Labels.Indices, Is.EqualTo(Patient.Labels.Indices));
            Assert.That(volume.Geometry.Matches(Patient.Geometry, 0, out string difference), Is.True, difference);
            Assert.That(volume.Segments.Count, Is.EqualTo(Patient.Segments.Count));
            for (int s = 0; s < volume.Segments.Count; s++)
                Assert.That((volume.Segments[s].Name, volume.Segments[s].Label, volume.Segments[s].Color),
                    Is.EqualTo((Patient.Segments[s].Name, Patient.Segments[s].Label, Patient.Segments[s].Color)));
        }

        static IEnumerator Finished(Task task)
        {
            while (!task.IsCompleted)
                yield return null;
            Assert.That(task.Exception, Is.Null);
        }
    }
}
