using System;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.Cli.Bench.Phantoms
{
    /// <summary>Volumes made of functions of place.</summary>
    static class PhantomVolumes
    {
        static readonly SegmentColor White = new(255, 255, 255);

        /// <summary>Opacity 1 wherever there is a segment, for <see cref="Everything"/>; nothing elsewhere. White, as lit normals need it.</summary>
        /// <param name="geometry">the grid</param>
        /// <param name="segments">how many segments there are, the unlabelled one not counted</param>
        /// <param name="segmentAt">the segment at a place in LPS mm; 0 = none</param>
        public static SegmentedVolume OfSegments(VolumeGeometry geometry, int segments, Func<PointMm, int> segmentAt)
        {
            var indices = new ushort[geometry.VoxelCount];
            Grids.ForEach(geometry, (i, j, k, voxel) => indices[voxel] = (ushort)segmentAt(geometry.IjkToLps.TransformPoint(new PointMm(i, j, k))));
            return Make(geometry, new ushort[indices.Length], 0, indices, segments);
        }

        /// <summary>One segment everywhere, whose opacity is each voxel's intensity / 255. For <see cref="EightBits"/>.</summary>
        public static SegmentedVolume OfOpacities(VolumeGeometry geometry, byte[] opacities)
        {
            var indices = new ushort[opacities.Length];
            Array.Fill(indices, (ushort)1);
            return Make(geometry, [.. opacities.Select(opacity => (ushort)opacity)], 255, indices, 1);
        }

        /// <summary>Every intensity is opaque.</summary>
        public static OpacityTransferFunction Everything { get; } = OpacityTransferFunction.Constant(1);

        /// <summary>Opacity is intensity / 255.</summary>
        public static OpacityTransferFunction EightBits { get; } = new([new TransferPoint(0, 0), new TransferPoint(255, 1)]);

        static SegmentedVolume Make(VolumeGeometry geometry, ushort[] codes, double largest, ushort[] indices, int segments)
        {
            var table = Enumerable.Range(1, segments).Select(index => new Segment(index, index, $"segment {index}", White))
                .Prepend(new Segment(0, 0, SegmentTable.UnlabelledName, White, 0));
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, largest), new LabelMap(geometry, indices, new SegmentTable(table)));
        }
    }
}
