using System;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests.Carving
{
    /// <summary>Volumes made by hand: intensities are codes 0..100, and the transfer function <see cref="Ramp"/> shows them as opacities 0..1.</summary>
    static class Phantoms
    {
        public static readonly OpacityTransferFunction Ramp = OpacityTransferFunction.Parse("0:0,100:1");

        public static SegmentTable Segments(int count) =>
            new SegmentTable(Enumerable.Range(0, count).Select(index => new Segment(index, 3 * index, "segment " + index, default)));

        public static SegmentedVolume Of(VolumeGeometry geometry, ushort[] codes, ushort[] labels, int segmentCount) =>
            new SegmentedVolume(
                new IntensityVolume(geometry, codes, 0, 1, 100), new LabelMap(geometry, labels, Segments(segmentCount)));

        /// <summary>A volume of 1 mm voxels, axes along L, P, S, origin at voxel (0, 0, 0).</summary>
        public static SegmentedVolume Cube(int size, int segmentCount, Func<int, int, int, int> code, Func<int, int, int, int> segment) =>
            On(new VolumeGeometry(size, size, size, Affine.Identity), segmentCount, code, segment);

        public static SegmentedVolume On(
            VolumeGeometry geometry, int segmentCount, Func<int, int, int, int> code, Func<int, int, int, int> segment)
        {
            var codes = new ushort[geometry.VoxelCount];
            var labels = new ushort[geometry.VoxelCount];
            int voxel = 0;
            for (int k = 0; k < geometry.SizeK; k++)
                for (int j = 0; j < geometry.SizeJ; j++)
                    for (int i = 0; i < geometry.SizeI; i++, voxel++)
                    {
                        codes[voxel] = (ushort)code(i, j, k);
                        labels[voxel] = (ushort)segment(i, j, k);
                    }
            return Of(geometry, codes, labels, segmentCount);
        }

        public static CarvedField Field(SegmentedVolume volume, CutMode cut, AntiAliasSettings antiAlias, params ClipSphere[] spheres)
        {
            var field = new CarvedField(volume);
            field.Update(spheres, Ramp, volume.Segments, cut, antiAlias);
            return field;
        }

        /// <summary>A function's value at every voxel, i fastest.</summary>
        public static T[] Map<T>(VolumeGeometry geometry, Func<int, int, int, T> value)
        {
            var values = new T[geometry.VoxelCount];
            int voxel = 0;
            for (int k = 0; k < geometry.SizeK; k++)
                for (int j = 0; j < geometry.SizeJ; j++)
                    for (int i = 0; i < geometry.SizeI; i++)
                        values[voxel++] = value(i, j, k);
            return values;
        }
    }
}
