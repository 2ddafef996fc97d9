using System;
using System.IO;
using System.Text;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests
{
    /// <summary>Volumes as NRRD files in a folder of one's own, which goes away with it.</summary>
    sealed class NrrdFiles : IDisposable
    {
        readonly string folder = Path.Combine(Path.GetTempPath(), "anatomycarve-" + Guid.NewGuid().ToString("N"));

        public NrrdFiles() => Directory.CreateDirectory(folder);

        public string PathOf(string name) => Path.Combine(folder, name);

        /// <summary>Writes the intensities of a volume that has axes along the patient's.</summary>
        public string WriteIntensity(string name, SegmentedVolume volume) => Write(name, volume.Geometry, volume.Intensity.Codes);

        /// <summary>Writes the dense segment indices as labels.</summary>
        public string WriteLabels(string name, SegmentedVolume volume) => Write(name, volume.Geometry, volume.Labels.Indices);

        public string WriteText(string name, string text)
        {
            File.WriteAllText(PathOf(name), text);
            return PathOf(name);
        }

        public void Dispose() => Directory.Delete(folder, true);

        string Write(string name, VolumeGeometry geometry, ushort[] voxels)
        {
            string header = FormattableString.Invariant($@"NRRD0004
type: ushort
dimension: 3
space: left-posterior-superior
sizes: {geometry.SizeI} {geometry.SizeJ} {geometry.SizeK}
space directions: ({geometry.SpacingMm.X:R},0,0) (0,{geometry.SpacingMm.Y:R},0) (0,0,{geometry.SpacingMm.Z:R})
space origin: ({geometry.IjkToLps[0, 3]:R},{geometry.IjkToLps[1, 3]:R},{geometry.IjkToLps[2, 3]:R})
endian: little
encoding: raw

").Replace("\r", "");
            using (FileStream stream = File.Create(PathOf(name)))
            {
                byte[] text = Encoding.ASCII.GetBytes(header);
                stream.Write(text, 0, text.Length);
                foreach (ushort voxel in voxels)
                {
                    stream.WriteByte((byte)voxel);
                    stream.WriteByte((byte)(voxel >> 8));
                }
            }
            return PathOf(name);
        }
    }
}
