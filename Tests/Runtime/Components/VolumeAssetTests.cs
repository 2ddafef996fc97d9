using System;
using System.Collections;
using System.Linq;
using System.Threading.Tasks;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>A volume as an asset: packed at run time, read on another thread.</summary>
    sealed class VolumeAssetTests
    {
        static readonly SegmentedVolume Patient = Phantoms.Markers(20);

        [UnityTest]
        public IEnumerator Open_ReadOnAnotherThread_GivesTheVolume()
        {
            VolumeAsset asset = VolumeAsset.Create(Patient, "patient");
            ReadOnlyMemory<byte> bytes = asset.Open();
            Task<SegmentedVolume> reading = Task.Run(() => PackedVolume.Read(bytes, "patient"));
            while (!reading.IsCompleted)
                yield return null;
            SegmentedVolume read = reading.Result;
            Assert.That(read.Intensity.Codes, Is.EqualTo(Patient.Intensity.Codes));
            Assert.That(read.Labels.Indices, Is.EqualTo(Patient.Labels.Indices));
            Assert.That(read.Segments.Select(s => s.Name), Is.EqualTo(Patient.Segments.Select(s => s.Name)));
            Object.DestroyImmediate(asset);
        }

        [Test]
        public void Create_Asset_SaysWhatTheVolumeIs()
        {
            VolumeAsset asset = VolumeAsset.Create(Patient, "patient");
            Assert.That(asset.name, Is.EqualTo("patient"));
            Assert.That(asset.Size, Is.EqualTo(new Vector3Int(20, 20, 20)));
            Assert.That(asset.SpacingMm, Is.EqualTo(new Vector3(2, 2, 2)));
            Assert.That(asset.Orientation, Is.EqualTo("LPS"));
            Assert.That(asset.Segments.Select(s => s.Name), Is.EqualTo(Patient.Segments.Select(s => s.Name)));
            Assert.That(asset.Segments.Select(s => s.Voxels), Is.EqualTo(Patient.Labels.VoxelCounts));
            Assert.That(asset.Histogram.Counts, Is.EqualTo(Patient.Histogram.Counts));
            Assert.That(asset.PackedBytes, Is.EqualTo(asset.Data.bytes.Length));
            Object.DestroyImmediate(asset);
        }

        [Test]
        public void Instantiate_Asset_KeepsTheHistogram()
        {
            VolumeAsset asset = VolumeAsset.Create(Patient);
            VolumeAsset copy = Object.Instantiate(asset);
            Assert.That(copy.Histogram.Counts, Is.EqualTo(Patient.Histogram.Counts));
            Assert.That(copy.Histogram.BinWidth, Is.EqualTo(Patient.Histogram.BinWidth));
            Object.DestroyImmediate(copy);
            Object.DestroyImmediate(asset);
        }

        [UnityTest]
        public IEnumerator Destroy_AssetMadeAtRunTime_TakesItsPartsAlong()
        {
            VolumeAsset asset = VolumeAsset.Create(Patient);
            TextAsset data = asset.Data;
            Texture2D picture = asset.Thumbnail;
            Object.Destroy(asset);
            yield return null;
            yield return null;
            Assert.That(data == null, Is.True);
            Assert.That(picture == null, Is.True);
        }

        [Test]
        public void Open_AssetWithoutBytes_Throws()
        {
            var asset = ScriptableObject.CreateInstance<VolumeAsset>();
            asset.name = "empty";
            Assert.That(() => asset.Open(), Throws.TypeOf<AnatomyCarveException>().With.Message.Contains("empty"));
            Assert.That(asset.PackedBytes, Is.Zero);
            Object.DestroyImmediate(asset);
        }

        [TestCase("LPS", "The first axis runs to the patient's left, the second to the back, the third to the head.")]
        [TestCase("RAI", "The first axis runs to the patient's right, the second to the front, the third to the feet.")]
        public void Directions_OfACode_AreASentence(string code, string sentence) => Assert.That(AxisDirections.Sentence(code), Is.EqualTo(sentence));

        [TestCase("LP")]
        [TestCase("XYZ")]
        [TestCase(null)]
        public void Directions_OfAnythingElse_AreRefused(string code) => Assert.That(() => AxisDirections.Sentence(code), Throws.ArgumentException);
    }
}
