using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Threading;
using System.Threading.Tasks;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Hosting
{
    /// <summary>Volumes in StreamingAssets where these lie inside the application's package, as on Android and Quest.</summary>
    public sealed class AndroidVolumeTests
    {
        string folder;
        UnityHost host;
        VolumeLoader loader;
        List<string> errors;

        [SetUp]
        public void MakePackage()
        {
            folder = Directory.CreateTempSubdirectory("anatomycarve-android-").FullName;
            using (ZipArchive package = ZipFile.Open(Path.Combine(folder, "base.apk"), ZipArchiveMode.Create))
            {
                Write(package, "assets/head scans/ct.nrrd", Nrrd(1000));
                Write(package, "assets/head scans/labels.nrrd", Nrrd(3));
                Write(package, "assets/patient/image.nrrd", Nrrd(700));
                Write(package, "assets/patient/labels/image.nrrd", Nrrd(3));
                Write(package, "assets/broken.nrrd", [1, 2, 3]);
            }
            errors = [];
            host = UnityHost.Start(new HostOptions
            {
                StreamingAssets = $"jar:file://{folder}/base.apk!/assets",
                DataFolder = Path.Combine(folder, "data"),
                Log = (type, message, _) => { if (type is LogType.Error or LogType.Exception) errors.Add(message); },
            });
            loader = new GameObject("Volume").AddComponent<VolumeLoader>();
        }

        [TearDown]
        public void RemovePackage()
        {
            host.Dispose();
            Directory.Delete(folder, true);
        }

        [Test]
        public void Files_InsideThePackage_AreLoaded()
        {
            SegmentedVolume volume = Finish(loader.LoadAsync("head scans/ct.nrrd", "head scans/labels.nrrd"));
            Assert.That(volume.Intensity.ValueMax, Is.EqualTo(1000));
            Assert.That(volume.Segments[1].Label, Is.EqualTo(3));
            Assert.That(errors, Is.Empty);
            Assert.That(Copies(), Is.Empty, "the copies are gone");
        }

        [Test]
        public void Files_OfAStartingLoader_AreLoaded()
        {
            loader.IntensityPath = "head scans/ct.nrrd";
            Assert.That(host.RunUntil(() => { Thread.Sleep(1); return loader.Volume != null; }, 5000), Is.True);
        }

        [Test]
        public void File_ThatThePackageLacks_IsRefusedByItsAddress()
        {
            var problem = Assert.Throws<AnatomyCarveException>(() => Finish(loader.LoadAsync("missing.nrrd")));
            Assert.That(problem.Message, Does.Contain("assets/missing.nrrd").And.Contain("could not be fetched"));
            Assert.That(Copies(), Is.Empty);
        }

        [Test]
        public void File_ThatIsDamaged_IsRefusedAndLeavesNoCopy()
        {
            var problem = Assert.Throws<VolumeFormatException>(() => Finish(loader.LoadAsync("broken.nrrd")));
            Assert.That(problem.Message, Does.Contain("broken.nrrd"));
            Assert.That(Copies(), Is.Empty);
        }

        [Test]
        public void Fetching_Cancelled_LeavesNoCopy()
        {
            using var source = new CancellationTokenSource();
            Task<SegmentedVolume> load = loader.LoadAsync("head scans/ct.nrrd", null, source.Token);
            source.Cancel();
            Assert.Throws(Is.InstanceOf<OperationCanceledException>(), () => Finish(load));
            Assert.That(Copies(), Is.Empty);
            Assert.That(errors, Is.Empty);
        }

        [Test]
        public void Files_OfOneNameInTwoFolders_AreBothRead()
        {
            SegmentedVolume volume = Finish(loader.LoadAsync("patient/image.nrrd", "patient/labels/image.nrrd"));
            Assert.That(volume.Intensity.ValueMax, Is.EqualTo(700));
            Assert.That(volume.Segments.Count, Is.EqualTo(2), "unlabelled, and the label 3");
            Assert.That(Copies(), Is.Empty);
        }

        [Test]
        public void Address_ThatIsNotSecure_IsRefusedWithWhatToDo()
        {
            var problem = Assert.Throws<AnatomyCarveException>(() => Finish(loader.LoadAsync("http://hospital.example/ct.nrrd")));
            Assert.That(problem.Message, Does.Contain("http://hospital.example/ct.nrrd").And.Contain("https://"));
            Assert.That(Copies(), Is.Empty);
        }

        [Test]
        public void Copies_ThatAProcessLeftLongAgo_AreRemoved()
        {
            string old = Directory.CreateDirectory(Path.Combine(Application.temporaryCachePath, "anatomycarve-old")).FullName;
            string young = Directory.CreateDirectory(Path.Combine(Application.temporaryCachePath, "anatomycarve-young")).FullName;
            Directory.SetLastWriteTimeUtc(old, DateTime.UtcNow.AddDays(-2));
            Finish(loader.LoadAsync("head scans/ct.nrrd"));
            Assert.That(Copies(), Is.EqualTo(new[] { young }), "the young one may be of a load that runs");
            Directory.Delete(young);
        }

        SegmentedVolume Finish(Task<SegmentedVolume> load)
        {
            for (int frame = 0; frame < 5000 && !load.IsCompleted; frame++)
            {
                host.Step();
                Thread.Sleep(1);
            }
            return load.GetAwaiter().GetResult();
        }

        string[] Copies() => Directory.Exists(Application.temporaryCachePath)
            ? Directory.GetDirectories(Application.temporaryCachePath, "anatomycarve-*")
            : [];

        static void Write(ZipArchive package, string name, byte[] content)
        {
            using Stream stream = package.CreateEntry(name).Open();
            stream.Write(content);
        }

        /// <summary>Two voxels, 0 and another value.</summary>
        static byte[] Nrrd(ushort value) =>
        [
            .. "NRRD0004\ntype: ushort\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 1 1\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"u8,
            .. "space origin: (0,0,0)\nendian: little\nencoding: raw\n\n"u8, 0, 0, (byte)value, (byte)(value >> 8),
        ];
    }
}
