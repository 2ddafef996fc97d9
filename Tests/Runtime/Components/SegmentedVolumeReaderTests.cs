using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Volumes from files, and from their content in memory.</summary>
    sealed class SegmentedVolumeReaderTests
    {
        NrrdFiles files;
        string scan, labels;

        [SetUp]
        public void WriteFiles()
        {
            files = new NrrdFiles();
            SegmentedVolume volume = Phantoms.Markers(12);
            scan = files.WriteIntensity("scan.nrrd", volume);
            labels = files.WriteLabels("labels.nrrd", volume);
        }

        [TearDown]
        public void DeleteFiles() => files.Dispose();

        [Test]
        public void Content_GivesTheVolumeOfTheFiles()
        {
            SegmentedVolume ofFiles = SegmentedVolumeReader.Read(scan, labels, CancellationToken.None, null);
            SegmentedVolume ofContent = SegmentedVolumeReader.Read(Content(scan, "a"), Content(labels, "b"), CancellationToken.None, null);
            Assert.That(ofContent.Intensity.Codes, Is.EqualTo(ofFiles.Intensity.Codes));
            Assert.That(ofContent.Labels.Indices, Is.EqualTo(ofFiles.Labels.Indices));
            Assert.That(ofContent.Segments.Select(segment => segment.Label), Is.EqualTo(ofFiles.Segments.Select(segment => segment.Label)));
            Assert.That(ofContent.Segments.Count, Is.GreaterThan(1));
            Assert.That(ofContent.Geometry.Matches(ofFiles.Geometry, 0, out _));
        }

        [Test]
        public void FileAndContent_MayBeMixed()
        {
            SegmentedVolume volume = SegmentedVolumeReader.Read(VolumeSource.OfFile(scan), Content(labels, "b"), CancellationToken.None, null);
            Assert.That(volume.Segments.Count, Is.GreaterThan(1));
        }

        [Test]
        public void LabelsMissing_MeansUnlabelled()
        {
            Assert.That(VolumeSource.OfFile(null), Is.Null);
            Assert.That(VolumeSource.OfFile(""), Is.Null);
            SegmentedVolume volume = SegmentedVolumeReader.Read(Content(scan, "a"), null, CancellationToken.None, null);
            Assert.That(volume.Segments.Count, Is.EqualTo(1));
        }

        [Test]
        public void Warnings_BeginWithTheNameWithoutFolders()
        {
            string text = File.ReadAllText(scan).Split(new[] { "\n\n" }, StringSplitOptions.None)[0];
            byte[] bytes = File.ReadAllBytes(scan);
            byte[] odd = System.Text.Encoding.ASCII.GetBytes(text + "\nunheard of: field\n\n").Concat(bytes.Skip(text.Length + 2)).ToArray();
            SegmentedVolume volume = SegmentedVolumeReader.Read(VolumeSource.OfContent(odd, "some folder/odd.nrrd"), null, CancellationToken.None, null);
            Assert.That(volume.Warnings, Has.Count.EqualTo(1));
            Assert.That(volume.Warnings[0], Does.StartWith("odd.nrrd: "));
        }

        [Test]
        public void Refusals_NameTheContent()
        {
            var refusal = Assert.Throws<VolumeFormatException>(
                () => SegmentedVolumeReader.Read(VolumeSource.OfContent(new byte[3], "folder/scan"), null, CancellationToken.None, null));
            Assert.That(refusal.File, Is.EqualTo("folder/scan"));
            string other = files.WriteLabels("other.nrrd", Phantoms.Markers(13));
            var mismatch = Assert.Throws<VolumeMismatchException>(
                () => SegmentedVolumeReader.Read(Content(scan, "one"), Content(other, "two"), CancellationToken.None, null));
            Assert.That(mismatch.Message, Does.StartWith("two and one: "));
            Assert.That(() => SegmentedVolumeReader.Read((VolumeSource)null, null, CancellationToken.None, null), Throws.ArgumentNullException);
        }

        [Test]
        public void Progress_Ascends_AndEndsAtOne([Values(false, true)] bool labelled)
        {
            var told = new Told();
            SegmentedVolumeReader.Read(Content(scan, "a"), labelled ? Content(labels, "b") : null, CancellationToken.None, told);
            Assert.That(told.Values, Is.Ordered);
            Assert.That(told.Values.Last(), Is.EqualTo(1f).Within(1e-5f));
        }

        static VolumeSource Content(string path, string name) => VolumeSource.OfContent(File.ReadAllBytes(path), name);

        sealed class Told : IProgress<float>
        {
            public List<float> Values { get; } = new List<float>();

            public void Report(float value) => Values.Add(value);
        }
    }
}
