using System.IO;
using AnatomyCarve.Volumes;
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

        [TestCase("ct.nrrd")]
        [TestCase("jar:file:///data/app/base.apk!/assets/ct.nrrd")]
        public void Path_InsideAnAndroidPackage_IsRefusedAndSaysWhereToPutTheFile(string path) => Assert.That(
            () => VolumePaths.Resolve(path, "jar:file:///data/app/base.apk!/assets"),
            Throws.InstanceOf<AnatomyCarveException>().With.Message.Contain("ct.nrrd").And.Message.Contain("Application.persistentDataPath"));
    }
}
