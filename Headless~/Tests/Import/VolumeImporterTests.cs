using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Editor;
using AnatomyCarve.Formats;
using AnatomyCarve.Headless.Tests.Layout;
using AnatomyCarve.Headless.Tests.Scenes;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using Random = System.Random;

namespace AnatomyCarve.Headless.Tests.Import
{
    /// <summary>The package's importers: what they make of scans and segmentations in a project.</summary>
    public sealed class VolumeImporterTests : ProjectTests
    {
        const int I = 12, J = 10, K = 8;

        readonly List<string> m_Messages = new();

        [SetUp]
        public void ForgetMessages() => m_Messages.Clear();

        void StartHost() => Start(o => (o.ExtraRoots, o.Log) = ([Project.Root], (type, text, _) => m_Messages.Add($"{type}: {text}")));

        string Asset(string path) => $"Assets/{Path.GetFileName(Project.Root)}/{path}";

        T Load<T>(string path) where T : UnityEngine.Object => AssetDatabase.LoadAssetAtPath<T>(Asset(path));

        void Write(string path, byte[] bytes, string settings = null) => Project.Write(path, bytes, settings == null ? "" : Settings(path, settings));

        /// <summary>A .meta as Unity writes it for the package's importers.</summary>
        static string Settings(string path, string fields)
        {
            var script = path.EndsWith(".nrrd", StringComparison.Ordinal) ? "NrrdImporter" : "NiftiImporter";
            var guid = PackageTree.OfRepository().GuidOf($"Editor/Importers/{script}.cs.meta");
            return "ScriptedImporter:\n  internalIDToNameTable: []\n  externalObjects: {}\n  serializedVersion: 2\n  userData: \n  assetBundleName: \n"
                + $"  assetBundleVariant: \n  script: {{fileID: 11500000, guid: {guid}, type: 3}}\n{fields}";
        }

        static short[] Intensities()
        {
            var random = new Random(5);
            return Enumerable.Range(0, I * J * K).Select(_ => (short)random.Next(-1000, 2000)).ToArray();
        }

        /// <summary>Labels 0, 3 and 700: with a gap between.</summary>
        static ushort[] Labels() => Enumerable.Range(0, I * J * K).Select(n => (ushort)(n % 7 == 0 ? 700 : n % 3 == 0 ? 3 : 0)).ToArray();

        static byte[] Scan(bool nifti) => nifti ? new NiftiFile(I, J, K, Intensities()).ToBytes() : new NrrdFile(Intensities(), I, J, K).ToBytes();

        static byte[] Segmentation(bool nifti)
        {
            if (nifti)
                return new NiftiFile(I, J, K, Labels()).ToBytes();
            var file = new NrrdFile(Labels(), I, J, K);
            file.FurtherLines.AddRange(["Segment0_ID:=A", "Segment0_Name:=Liver", "Segment0_Color:=1 0.5 0", "Segment0_LabelValue:=3", "Segment0_Layer:=0",
                "Segment1_ID:=B", "Segment1_Name:=Ärmel", "Segment1_Color:=0 0 1", "Segment1_LabelValue:=700", "Segment1_Layer:=0"]);
            return file.ToBytes();
        }

        static SegmentedVolume Unpacked(VolumeAsset asset) => PackedVolume.Read(asset.Data.bytes, asset.name);

        /// <summary>What the loader makes of the files.</summary>
        SegmentedVolume FromFiles(string scan, string labels)
        {
            string Full(string path) => path == null ? null : Path.Combine(Project.Root, path);
            var task = new GameObject("loader").AddComponent<VolumeLoader>().LoadAsync(Full(scan), Full(labels));
            for (var n = 0; n < 60000 && !task.IsCompleted; n++)
            {
                Host.Step();
                Thread.Sleep(1);
            }

            Assert.That(task.IsCompletedSuccessfully, Is.True);
            return task.Result;
        }

        [TestCase("head.nii", "head.seg.nrrd")]
        [TestCase("head.nrrd", "head_labels.nii")]
        [TestCase("head.nrrd", "head-label.nii.gz")]
        [TestCase("head.nii.gz", "head_seg.nrrd")]
        [TestCase("some.head.nrrd", "some.head-seg.nii")]
        [TestCase("head.nii", "head-labels.nrrd")]
        [TestCase("Head.NII", "Head_label.nii")]
        [TestCase("head.nrrd", null)]
        public void Scan_WithItsSegmentation_HoldsWhatTheFilesHold(string scan, string labels)
        {
            byte[] Packed(string path, byte[] bytes) => path.EndsWith(".gz", StringComparison.Ordinal) ? VoxelBytes.Gzip(bytes) : bytes;
            Write(scan, Packed(scan, Scan(!scan.EndsWith(".nrrd", StringComparison.Ordinal))));
            if (labels != null)
                Write(labels, Packed(labels, Segmentation(!labels.EndsWith(".nrrd", StringComparison.Ordinal))));
            StartHost();
            var asset = Load<VolumeAsset>(scan);
            SegmentedVolumeAssert.AreSame(Unpacked(asset), FromFiles(scan, labels));
            Assert.That(asset.Sources, Is.EqualTo(new[] { scan, labels }.Where(s => s != null)));
            Assert.That(asset.Segments.Select(s => s.Label), Is.EqualTo(labels == null ? new long[] { 0 } : [0, 3, 700]));
            Assert.That(m_Messages, Is.Empty);
        }

        [Test]
        public void Scan_Asset_SaysWhatItIs()
        {
            Write("head.nrrd", Scan(false));
            Write("head.seg.nrrd", Segmentation(false));
            StartHost();
            var asset = Load<VolumeAsset>("head.nrrd");
            Assert.That((asset.name, asset.Size, asset.SpacingMm, asset.Orientation), Is.EqualTo(("head", new Vector3Int(I, J, K), Vector3.one, "LPS")));
            Assert.That(asset.OrientationSentence, Is.EqualTo("The first axis runs to the patient's left, the second to the back, the third to the head."));
            Assert.That((asset.ValueMin, asset.ValueMax), Is.EqualTo(((double)Intensities().Min(), (double)Intensities().Max())));
            Assert.That((asset.Histogram.Total, asset.UnpackedBytes, asset.PackedBytes), Is.EqualTo(((long)I * J * K, 4L * I * J * K, asset.Data.dataSize)));
            Assert.That((asset.Segments[1].Name, asset.Segments[1].Color, asset.Segments[1].Voxels),
                Is.EqualTo(("Liver", new Color32(255, 128, 0, 255), (long)Labels().Count(l => l == 3))));
            Assert.That((asset.Segments[2].Name, asset.Segments[0].Label), Is.EqualTo(("Ärmel", 0L)));
        }

        [Test]
        public void Scan_Thumbnail_ShowsSomething()
        {
            Write("head.nrrd", Scan(false));
            Write("head.seg.nrrd", Segmentation(false));
            StartHost();
            var picture = Load<VolumeAsset>("head.nrrd").Thumbnail;
            Assert.That((picture.width, picture.height, picture.name), Is.EqualTo((128, 128, "thumbnail")));
            var alpha = picture.GetPixelData<Color32>(0).Count(c => c.a > 0);
            Assert.That(alpha, Is.InRange(128 * 128 / 5, 128 * 128 - 1), "pixels that are not transparent");
        }

        [Test]
        public void Scan_Objects_HaveFixedNumbers()
        {
            Write("head.nrrd", Scan(false));
            StartHost();
            var asset = Load<VolumeAsset>("head.nrrd");
            long Id(UnityEngine.Object o) => AssetDatabase.TryGetGUIDAndLocalFileIdentifier(o, out _, out var id) ? id : 0;
            Assert.That((Id(asset), Id(asset.Data), Id(asset.Thumbnail)), Is.EqualTo((ImportedFileIds.Of("MonoBehaviour", "volume"),
                ImportedFileIds.Of("TextAsset", "data"), ImportedFileIds.Of("Texture2D", "thumbnail"))));
        }

        [Test]
        public void Scan_ImportedTwice_IsTheSame()
        {
            Write("head.nrrd", Scan(false));
            Write("head.seg.nrrd", Segmentation(false));
            StartHost();
            var first = (Load<VolumeAsset>("head.nrrd").Data.bytes, Load<VolumeAsset>("head.nrrd").Thumbnail.GetRawTextureData());
            AssetImporter.GetAtPath(Asset("head.nrrd")).SaveAndReimport();
            var second = (Load<VolumeAsset>("head.nrrd").Data.bytes, Load<VolumeAsset>("head.nrrd").Thumbnail.GetRawTextureData());
            Assert.That(second, Is.EqualTo(first));
        }

        [Test]
        public void Scan_WhoseSegmentationComesLater_IsImportedAnew()
        {
            Write("head.nrrd", Scan(false));
            StartHost();
            Assert.That(Load<VolumeAsset>("head.nrrd").Segments, Has.Count.EqualTo(1));
            Write("head_labels.nii", Segmentation(true));
            AssetDatabase.Refresh();
            Assert.That(Load<VolumeAsset>("head.nrrd").Segments, Has.Count.EqualTo(3));
            File.Delete(Path.Combine(Project.Root, "head_labels.nii"));
            AssetDatabase.Refresh();
            Assert.That(Load<VolumeAsset>("head.nrrd").Segments, Has.Count.EqualTo(1));
        }

        [Test]
        public void Scan_WithTwoSegmentations_TakesTheFirstAndSaysSo()
        {
            Write("head.nrrd", Scan(false));
            Write("head.seg.nrrd", Segmentation(false));
            Write("head_labels.nii", Segmentation(true));
            StartHost();
            Assert.That(Load<VolumeAsset>("head.nrrd").Sources[1], Is.EqualTo("head.seg.nrrd"));
            Assert.That(m_Messages, Is.EqualTo(new[]
            {
                $"Warning: {Asset("head.nrrd")}: 2 segmentations lie beside it; {Asset("head.seg.nrrd")} is used. Choose another in the import settings.",
            }));
        }

        [Test]
        public void Settings_ChosenSegmentation_IsTaken()
        {
            Write("scans/head.nrrd", Scan(false), "  labels: 1\n  labelsFile: ../labels/other.nii\n");
            Write("labels/other.nii", Segmentation(true));
            StartHost();
            Assert.That(Load<VolumeAsset>("scans/head.nrrd").Sources[1], Is.EqualTo("other.nii"));
        }

        [TestCase("  labels: 1\n  labelsFile: gone.nii\n", "gone.nii, does not exist")]
        [TestCase("  labels: 1\n", "name no file")]
        public void Settings_ChosenSegmentation_ThatIsMissing_IsAnError(string settings, string expected)
        {
            Write("head.nrrd", Scan(false), settings);
            StartHost();
            Assert.That(Load<VolumeAsset>("head.nrrd") == null, Is.True);
            Assert.That(m_Messages, Has.Exactly(1).Contains(expected).And.Exactly(1).StartsWith($"Error: {Asset("head.nrrd")}: "));
        }

        [Test]
        public void Settings_NoSegmentation_LeavesItOut()
        {
            Write("head.nrrd", Scan(false), "  labels: 2\n");
            Write("head.seg.nrrd", Segmentation(false));
            StartHost();
            Assert.That(Load<VolumeAsset>("head.nrrd").Segments, Has.Count.EqualTo(1));
        }

        [TestCase("head.seg.nrrd", false)]
        [TestCase("head_labels.nii", true)]
        [TestCase("unnamed.nrrd", false)]
        public void Segmentation_ByNameOrHeader_ListsItsSegments(string name, bool nifti)
        {
            Write(name, Segmentation(nifti));
            StartHost();
            var asset = Load<SegmentationAsset>(name);
            Assert.That((asset.Segments.Select(s => s.Label), asset.Size, asset.Source), Is.EqualTo((new long[] { 0, 3, 700 }, new Vector3Int(I, J, K), name)));
            Assert.That(asset.Segments[1].Name, nifti ? Is.Not.Empty : Is.EqualTo("Liver"));
        }

        [Test]
        public void Settings_Role_DecidesAgainstTheName()
        {
            Write("scan_seg.nii", Scan(true), "  role: 1\n");
            Write("organs.nii", Segmentation(true), "  role: 2\n");
            StartHost();
            Assert.That((Load<VolumeAsset>("scan_seg.nii") != null, Load<SegmentationAsset>("organs.nii") != null), Is.EqualTo((true, true)));
        }

        [TestCase("head.nrrd")]
        [TestCase("head.nii")]
        [TestCase("head.nii.gz")]
        public void DamagedFile_IsAnErrorWithoutAnAsset(string name)
        {
            var bytes = Scan(!name.EndsWith(".nrrd", StringComparison.Ordinal));
            bytes = name.EndsWith(".gz", StringComparison.Ordinal) ? VoxelBytes.Gzip(bytes) : bytes;
            Write(name, bytes[..(bytes.Length / 2)]);
            StartHost();
            Assert.That(Load<VolumeAsset>(name) == null, Is.True);
            Assert.That(m_Messages, Has.Count.EqualTo(1).And.All.StartsWith($"Error: {Asset(name)}: "), "the path in the project, not on the disk");
        }

        [Test]
        public void SegmentationOnAnotherGrid_IsAnError()
        {
            Write("head.nrrd", Scan(false));
            Write("head.seg.nrrd", new NrrdFile(new byte[6 * 5 * 4], 6, 5, 4) { ["space directions"] = "(2.5,0,0) (0,2,0) (0,0,2)" }.ToBytes());
            StartHost();
            Assert.That(Load<VolumeAsset>("head.nrrd") == null, Is.True);
            Assert.That(m_Messages, Has.Exactly(1).StartsWith($"Error: {Asset("head.seg.nrrd")}").And.Exactly(0).Contains(Project.Root));
        }

        [Test]
        public void Oddities_OfTheFiles_AreWarnings()
        {
            var file = new NiftiFile(I, J, K, Intensities()) { Sform = null };
            Write("head.nii", file.ToBytes());
            StartHost();
            var asset = Load<VolumeAsset>("head.nii");
            Assert.That(asset.Warnings, Is.Not.Empty.And.All.StartsWith("head.nii: "));
            Assert.That(m_Messages, Is.EqualTo(asset.Warnings.Select(w => "Warning: " + w)));
        }

        [Test]
        public void Asset_HoldsNeitherFoldersNorPatients()
        {
            var file = new NrrdFile(Intensities(), I, J, K);
            file["content"] = "Jane Doe";
            file.FurtherLines.AddRange(["PatientName:=Jane Doe", "# Jane Doe"]);
            Write("folder of Jane/head.nrrd", file.ToBytes());
            StartHost();
            var asset = Load<VolumeAsset>("folder of Jane/head.nrrd");
            var all = System.Text.Encoding.UTF8.GetString(asset.Data.bytes) + asset.name + string.Join("", asset.Sources.Concat(asset.Warnings));
            Assert.That(all, Does.Not.Contain("Jane").And.Not.Contain(Path.GetFileName(Project.Root)));
        }

        [Test]
        public void CompressedNifti_GetsItsImporterAsAnOverride()
        {
            Write("head.nii.gz", VoxelBytes.Gzip(Scan(true)));
            Write("text.txt.gz", VoxelBytes.Gzip([1, 2, 3]));
            StartHost();
            Assert.That(AssetDatabase.GetImporterOverride(Asset("head.nii.gz")), Is.EqualTo(typeof(NiftiImporter)));
            Assert.That(AssetDatabase.GetImporterType(Asset("text.txt.gz")), Is.Null);
        }

        [TestCase("ct_abdomen_pelvis.nrrd", "ct_abdomen_pelvis.seg.nrrd")]
        [TestCase("brain_t1.nii.gz", "brain_labels.nii.gz")]
        public void RealScan_HoldsWhatTheFilesHold(string scan, string labels)
        {
            Write("scan" + scan[scan.IndexOf('.')..], File.ReadAllBytes(SharedData.PathOf("demo/" + scan)));
            Write("scan_labels" + labels[labels.LastIndexOf(".n", StringComparison.Ordinal)..], File.ReadAllBytes(SharedData.PathOf("demo/" + labels)));
            StartHost();
            var asset = Load<VolumeAsset>("scan" + scan[scan.IndexOf('.')..]);
            SegmentedVolumeAssert.AreSame(Unpacked(asset), FromFiles(asset.Sources[0], asset.Sources[1]));
            TestContext.Out.WriteLine($"{scan}: {asset.UnpackedBytes} bytes of voxels in {asset.PackedBytes}");
        }

        [Test]
        public void DemoHead_OfTheSample_IsImportedByItsMetas()
        {
            var asset = (VolumeAsset)Host.LoadAsset("Samples~/DemoHead/Colin27.nrrd");
            Assert.That((asset.Segments.Count, asset.Sources), Is.EqualTo((119, new[] { "Colin27.nrrd", "Colin27.seg.nrrd" })));
            Assert.That(AssetDatabase.GetAssetPath(asset), Is.EqualTo("Assets/DemoHead/Colin27.nrrd"));
        }
    }
}
