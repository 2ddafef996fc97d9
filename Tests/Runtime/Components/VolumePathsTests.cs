using System.IO;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Where files are looked for.</summary>
    sealed class VolumePathsTests
    {
        static readonly string Assets = Path.GetFullPath("StreamingAssets");

        [Test]
        public void Path_Relative_CountsFromStreamingAssets() =>
            Assert.That(VolumePaths.Resolve("head/ct.nrrd", Assets), Is.EqualTo(Path.Combine(Assets, "head/ct.nrrd")));

        [Test]
        public void Path_Absolute_StaysAsItIs()
        {
            string path = Path.GetFullPath("ct.nrrd");
            Assert.That(VolumePaths.Resolve(path, Assets), Is.EqualTo(path));
            Assert.That(VolumePaths.Resolve(path, "jar:file:///data/app/base.apk!/assets"), Is.EqualTo(path));
        }

        [TestCase(null)]
        [TestCase("")]
        public void Path_Missing_IsNoFile(string path) => Assert.That(VolumePaths.Resolve(path, Assets), Is.Null);

        [TestCase("ct.nrrd", "jar:file:///data/app/base.apk!/assets/ct.nrrd")]
        [TestCase("head scans/ct 100%.nrrd", "jar:file:///data/app/base.apk!/assets/head%20scans/ct%20100%25.nrrd")]
        [TestCase("jar:file:///data/app/base.apk!/assets/ct.nrrd", "jar:file:///data/app/base.apk!/assets/ct.nrrd")]
        [TestCase("https://example.org/ct.nii.gz", "https://example.org/ct.nii.gz")]
        public void Path_InsideAnAndroidPackageOrOnAServer_IsAnAddress(string path, string expected)
        {
            string resolved = VolumePaths.Resolve(path, "jar:file:///data/app/base.apk!/assets");
            Assert.That(resolved, Is.EqualTo(expected));
            Assert.That(VolumePaths.IsAddress(resolved), Is.True);
            Assert.That(VolumePaths.IsAddress(Path.GetFullPath("ct.nrrd")), Is.False);
        }

        [TestCase("jar:file:///data/app/base.apk!/assets/head%20scans/ct%20100%25.nrrd", "ct 100%.nrrd")]
        [TestCase("https://example.org/scans/ct.nii.gz?user=1#top", "ct.nii.gz")]
        [TestCase("https://example.org/", "example.org")]
        [TestCase("https://", "https:")]
        public void FileName_OfAnAddress_IsItsLastPart(string address, string expected) =>
            Assert.That(VolumePaths.FileNameOf(address), Is.EqualTo(expected));
    }
}
