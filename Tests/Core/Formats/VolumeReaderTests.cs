using System.IO;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    public sealed class VolumeReaderTests
    {
        string folder;

        [SetUp]
        public void MakeFolder()
        {
            folder = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
            Directory.CreateDirectory(folder);
        }

        [TearDown]
        public void DeleteFolder() => Directory.Delete(folder, true);

        [Test]
        public void Content_AndNotTheName_DecidesTheFormat()
        {
            string nifti = Write("a.nrrd", VoxelBytes.Gzip(new NiftiFile(1, 1, 1, new byte[] { 4 }).ToBytes()));
            string nrrd = Write("b.nii.gz", new NrrdFile(new byte[] { 5 }, 1, 1, 1).ToBytes());
            Assert.That(VolumeReader.Read(nifti).Format, Is.EqualTo("NIfTI-1"));
            Assert.That(VolumeReader.Read(nrrd).Format, Is.EqualTo("NRRD"));
            Assert.That(VolumeReader.CanRead(nifti) && VolumeReader.CanRead(nrrd), Is.True);
        }

        [Test]
        public void MissingFile_IsRefusedByName()
        {
            string path = Path.Combine(folder, "nothing.nii");
            var refusal = Assert.Throws<VolumeFormatException>(() => VolumeReader.Read(path));
            Assert.That(refusal.Message, Is.EqualTo(path + ": the file is not there; expected a file that can be read."));
            Assert.That(VolumeReader.CanRead(path), Is.False);
        }

        [Test]
        public void Folder_IsRefused()
        {
            Assert.That(() => VolumeReader.Read(folder), Throws.TypeOf<VolumeFormatException>());
        }

        [Test]
        public void OtherContent_IsRefused()
        {
            string path = Write("c.nii", new byte[] { 1, 2, 3 });
            Assert.That(() => VolumeReader.Read(path), Throws.TypeOf<VolumeFormatException>());
            Assert.That(VolumeReader.CanRead(path), Is.False);
        }

        [Test]
        public void DicomFile_IsRefusedByName()
        {
            var bytes = new byte[400];
            new[] { (byte)'D', (byte)'I', (byte)'C', (byte)'M' }.CopyTo(bytes, 128);
            string path = Write("d.dcm", bytes);
            Assert.That(() => VolumeReader.Read(path), Throws.TypeOf<VolumeFormatException>().With.Message.Contains("DICOM"));
        }

        [Test]
        public void Stream_IsReadFromItsPosition()
        {
            byte[] file = new NrrdFile(new byte[] { 5, 6 }, 2, 1, 1).ToBytes();
            using (var stream = new MemoryStream(VoxelBytes.Join(new byte[100], file)) { Position = 100 })
                Assert.That(VolumeReader.Read(stream, "test").Voxels, Is.EqualTo(new byte[] { 5, 6 }));
        }

        string Write(string name, byte[] bytes)
        {
            string path = Path.Combine(folder, name);
            File.WriteAllBytes(path, bytes);
            return path;
        }
    }
}
