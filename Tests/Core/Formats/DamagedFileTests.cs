using System;
using System.IO;
using System.Linq;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Formats
{
    /// <summary>The law for any damage: a file is read, or refused by the package's own exception. Damage is random, from a stated seed.</summary>
    public sealed class DamagedFileTests
    {
        const int Rounds = 1500;

        static readonly short[] Voxels = Enumerable.Range(0, 60).Select(n => (short)(n * 37)).ToArray();

        [Test]
        public void Nifti_WithRandomBytesChanged_IsReadOrRefused([Values(1, 2)] int seed, [Values(false, true)] bool gzip)
        {
            byte[] file = new NiftiFile(3, 4, 5, Voxels) { QformCode = 1 }.ToBytes();
            Damage(gzip ? VoxelBytes.Gzip(file) : file, seed, 352);
        }

        [Test]
        public void Nrrd_WithRandomBytesChanged_IsReadOrRefused([Values(1, 2)] int seed, [Values("raw", "gzip", "ascii", "hex")] string encoding)
        {
            var file = new NrrdFile(Voxels, 3, 4, 5) { ["encoding"] = encoding, ["kinds"] = "domain domain domain", ["byte skip"] = "0" };
            file.FurtherLines.AddRange(new[] { "Segment0_ID:=a", "Segment0_Color:=1 0 0", "Segment0_Extent:=0 1 0 1 0 1", "Segment0_LabelValue:=37" });
            Damage(file.ToBytes(), seed, file.HeaderBytes().Length + 20);
        }

        [Test]
        public void AnyFile_CutAnywhere_IsRefused([Values("raw", "gzip")] string encoding)
        {
            byte[] nrrd = new NrrdFile(Voxels, 3, 4, 5) { ["encoding"] = encoding }.ToBytes();
            byte[] nifti = new NiftiFile(3, 4, 5, Voxels).ToBytes();
            foreach (byte[] file in new[] { nrrd, encoding == "raw" ? nifti : VoxelBytes.Gzip(nifti) })
            {
                // The last bytes of gzip data are a mark of the end, checksum and size: without them no voxel is missing.
                int needed = encoding == "raw" ? file.Length : file.Length - 16;
                for (int length = 0; length < needed; length++)
                {
                    byte[] cut = VoxelBytes.Part(file, 0, length);
                    Assert.That(() => VolumeReader.Read(new MemoryStream(cut), "cut"), Throws.TypeOf<VolumeFormatException>(), "cut after " + length);
                }
            }
        }

        static void Damage(byte[] file, int seed, int header)
        {
            var random = new Random(seed);
            for (int round = 0; round < Rounds; round++)
            {
                var damaged = (byte[])file.Clone();
                for (int change = random.Next(1, 5); change > 0; change--)
                    damaged[random.Next(Math.Min(header, damaged.Length))] = (byte)random.Next(256);
                try
                {
                    VolumeData data = VolumeReader.Read(new MemoryStream(damaged), "damaged");
                    Assert.That(data.Voxels.LongLength, Is.EqualTo(data.Geometry.VoxelCount * data.Components));
                }
                catch (VolumeFormatException)
                {
                    // Refused, as it may be.
                }
                catch (Exception problem) when (!(problem is AssertionException))
                {
                    Assert.Fail("seed " + seed + ", round " + round + ": " + problem);
                }
            }
        }
    }
}
