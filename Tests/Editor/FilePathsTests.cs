using AnatomyCarve.Editor;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Paths in the loader's fields.</summary>
    sealed class FilePathsTests
    {
        [TestCase("/p/Assets/StreamingAssets/ct.nii", "/p/Assets/StreamingAssets", "ct.nii")]
        [TestCase("/p/Assets/StreamingAssets/a/b.nrrd", "/p/Assets/StreamingAssets/", "a/b.nrrd")]
        [TestCase("/p/Assets/StreamingAssets2/ct.nii", "/p/Assets/StreamingAssets", "/p/Assets/StreamingAssets2/ct.nii")]
        [TestCase("/data/ct.nii", "/p/Assets/StreamingAssets", "/data/ct.nii")]
        [TestCase("/P/Assets/StreamingAssets/ct.nii", "/p/Assets/StreamingAssets", "/P/Assets/StreamingAssets/ct.nii")]
        [TestCase(@"C:\p\Assets\StreamingAssets\a\ct.nii", "c:/p/Assets/StreamingAssets", "a/ct.nii")]
        [TestCase(@"D:\data\ct.nii", "C:/p/Assets/StreamingAssets", "D:/data/ct.nii")]
        public void Path_OfAChosenFile_IsRelativeWhereItCanBe(string path, string folder, string expected) =>
            Assert.That(FilePaths.RelativeTo(path, folder), Is.EqualTo(expected));
    }
}
