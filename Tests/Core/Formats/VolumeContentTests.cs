using System;
using System.Buffers;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    /// <summary>The law: a file's content in memory is read as the file is.</summary>
    public sealed class VolumeContentTests
    {
        const string Name = "a content";

        static IEnumerable<string> Files() => SharedData.FilesIn("readers", "files").Where(file => !file.StartsWith("dicom/"));

        [TestCaseSource(nameof(Files))]
        public void Content_IsReadAsItsFileIs(string file)
        {
            string path = SharedData.PathOf("readers/" + file);
            JObject ofFile = Described(() => VolumeReader.Read(path));
            JObject ofContent = Described(() => VolumeReader.Read(File.ReadAllBytes(path), path));
            Assert.That(ofContent.ToString(), Is.EqualTo(ofFile.ToString()));
            Assert.That(VolumeReader.CanRead(File.ReadAllBytes(path)), Is.EqualTo(VolumeReader.CanRead(path)));
        }

        [TestCaseSource(nameof(Files))]
        public void Header_SaysWhatReadingFinds(string file)
        {
            string path = SharedData.PathOf("readers/" + file);
            VolumeData data;
            VolumeFileInfo info;
            try
            {
                info = VolumeReader.ReadInfo(path);
                data = VolumeReader.Read(path);
            }
            catch (VolumeFormatException refusal)
            {
                Assert.That(Described(() => VolumeReader.Read(path))["refusal"]?.ToString(), Is.EqualTo(refusal.Message), "the header is refused as the file is");
                return;
            }

            Assert.That(info.Geometry.Matches(data.Geometry, 0, out string difference), Is.True, difference);
            Assert.That((info.VoxelType, (int)info.Components, info.Format, info.Source), Is.EqualTo((data.VoxelType, data.Components, data.Format, data.Source)));
            Assert.That(info.Segments.Select(segment => segment.Name), Is.EqualTo(data.Segments.Select(segment => segment.Name)));
            Assert.That(info.StoredBytes, Is.EqualTo(data.Voxels.LongLength * data.VoxelType.SizeOf()));
            Assert.That(VolumeReader.ReadInfo(File.ReadAllBytes(path), path).IsCompressed, Is.EqualTo(info.IsCompressed));
        }

        [Test]
        public void Header_OfMoreVoxelsThanThereAre_IsReadAllTheSame()
        {
            byte[] file = new NrrdFile(new byte[] { 5, 6, 7 }, 3, 1, 1) { ["sizes"] = "1000 1000 1000" }.ToBytes();
            Assert.That(VolumeReader.ReadInfo(file, Name).StoredBytes, Is.EqualTo(1e9));
        }

        [Test]
        public void Memory_OfAnyKind_IsRead([Values("raw", "gzip", "hex", "ascii")] string encoding)
        {
            byte[] file = new NrrdFile(new byte[] { 5, 6, 7 }, 3, 1, 1) { ["encoding"] = encoding }.ToBytes();
            Assert.That(VolumeReader.Read(file, Name).Voxels, Is.EqualTo(new byte[] { 5, 6, 7 }));
            byte[] around = VoxelBytes.Join(new byte[3], file, new byte[] { 9, 9 });
            Assert.That(VolumeReader.Read(around.AsMemory(3, file.Length), Name).Voxels, Is.EqualTo(new byte[] { 5, 6, 7 }));
            using (var foreign = new ForeignMemory(file))
                Assert.That(VolumeReader.Read(foreign.Memory, Name).Voxels, Is.EqualTo(new byte[] { 5, 6, 7 }));
        }

        [Test]
        public void Voxels_FromTheContentsEndOn_AreFound()
        {
            byte[] file = new NrrdFile(new byte[] { 5, 6, 7 }, 3, 1, 1) { ["byte skip"] = "-1" }.ToBytes();
            Assert.That(VolumeReader.Read(file, Name).Voxels, Is.EqualTo(new byte[] { 5, 6, 7 }));
        }

        [Test]
        public void Messages_CallTheContentByItsName()
        {
            var refusal = Assert.Throws<VolumeFormatException>(() => VolumeReader.Read(new byte[] { 1, 2, 3 }, Name));
            Assert.That(refusal.File, Is.EqualTo(Name));
            refusal = Assert.Throws<VolumeFormatException>(() => VolumeReader.Read(ReadOnlyMemory<byte>.Empty, Name));
            Assert.That(refusal.Message, Does.StartWith(Name + ": ").And.Contain("empty"));
            Assert.That(VolumeReader.Read(new NrrdFile(new byte[1], 1, 1, 1).ToBytes(), Name).Source, Is.EqualTo(Name));
        }

        [Test]
        public void Content_IsNotCopied()
        {
            const int voxels = 8 << 20;
            byte[] file = new NrrdFile(new byte[voxels], 256, 256, 128).ToBytes();
            VolumeReader.Read(file, Name);
            long before = GC.GetAllocatedBytesForCurrentThread();
            VolumeReader.Read(file, Name);
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(voxels + (1 << 20)));
        }

        [Test]
        public void Cancellation_And_Progress_AreHeeded()
        {
            byte[] file = new NrrdFile(new byte[64], 4, 4, 4).ToBytes();
            Assert.That(() => VolumeReader.Read(file, Name, new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
            var told = new Told();
            VolumeReader.Read(file, Name, default, told);
            Assert.That(told.Last, Is.EqualTo(1));
        }

        [TestCase(new byte[0])]
        [TestCase(new byte[] { 0x1F, 0x8B })]
        [TestCase(new byte[] { 0x1F, 0x8B, 8, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13 })]
        public void CanRead_OfOtherContent_IsFalse(byte[] content) => Assert.That(VolumeReader.CanRead(content), Is.False);

        /// <summary>What was read, or why it was not.</summary>
        static JObject Described(Func<VolumeData> read)
        {
            try
            {
                VolumeData data = read();
                return new JObject
                {
                    ["geometry"] = data.Geometry.IjkToLps.ToString(),
                    ["sizes"] = new JArray(data.Geometry.SizeI, data.Geometry.SizeJ, data.Geometry.SizeK, data.Components),
                    ["hash"] = data.StoredStatistics().Sha256,
                    ["scaling"] = new JArray(data.Slope, data.Intercept),
                    ["warnings"] = new JArray(data.Warnings),
                    ["metadata"] = JObject.FromObject(data.Metadata),
                    ["segments"] = new JArray(data.Segments.Select(segment => segment.ToString())),
                    ["source"] = data.Source,
                };
            }
            catch (VolumeFormatException refusal)
            {
                return new JObject { ["refusal"] = refusal.Message };
            }
        }

        sealed class Told : IProgress<float>
        {
            public float Last { get; private set; }

            public void Report(float value) => Last = value;
        }

        /// <summary>Memory that is not simply an array, as native memory is not.</summary>
        sealed class ForeignMemory : MemoryManager<byte>
        {
            readonly byte[] bytes;

            public ForeignMemory(byte[] bytes) => this.bytes = bytes;

            public override Span<byte> GetSpan() => bytes;

            public override MemoryHandle Pin(int elementIndex = 0) => throw new NotSupportedException("Nothing has to be pinned.");

            public override void Unpin() => throw new NotSupportedException("Nothing has to be pinned.");

            protected override void Dispose(bool disposing)
            {
            }
        }
    }
}
