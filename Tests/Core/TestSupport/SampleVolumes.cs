using System;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>Volumes for tests that need some variety, not anatomy. The same arguments give the same volume.</summary>
    public static class SampleVolumes
    {
        /// <summary>A volume of 1 mm voxels from functions of the voxel's number.</summary>
        public static SegmentedVolume Of(int sizeI, int sizeJ, int sizeK, Func<int, int> code, Func<int, int> index, int segments) =>
            Of(new VolumeGeometry(sizeI, sizeJ, sizeK, Affine.Identity), code, index, segments);

        /// <summary>A volume from functions of the voxel's number.</summary>
        public static SegmentedVolume Of(VolumeGeometry geometry, Func<int, int> code, Func<int, int> index, int segments)
        {
            int voxels = (int)geometry.VoxelCount;
            ushort[] codes = Enumerable.Range(0, voxels).Select(voxel => (ushort)code(voxel)).ToArray();
            ushort[] indices = Enumerable.Range(0, voxels).Select(voxel => (ushort)index(voxel)).ToArray();
            return new SegmentedVolume(
                new IntensityVolume(geometry, codes, -1024, 1, 64511), new LabelMap(geometry, indices, Table(segments)));
        }

        /// <summary>A scan with a gradient, noise and an empty margin, and blocks of segments.</summary>
        public static SegmentedVolume Scan(int sizeI, int sizeJ, int sizeK, int segments, int seed)
        {
            var random = new Random(seed);
            return Of(
                sizeI, sizeJ, sizeK,
                voxel => voxel % sizeI < sizeI / 4 ? 0 : 1000 + (voxel % 97) + random.Next(40),
                voxel => voxel / 7 / sizeI % segments,
                segments);
        }

        /// <summary>Segments of labels 0, 3, 6 ..., each of another colour and opacity.</summary>
        public static SegmentTable Table(int segments) => new SegmentTable(Enumerable.Range(0, segments).Select(index => new Segment(
            index, 3L * index, "segment " + index, new SegmentColor((byte)index, (byte)(index * 7), (byte)(index >> 3)), 1f / (1 + (index % 5)))));
    }
}
