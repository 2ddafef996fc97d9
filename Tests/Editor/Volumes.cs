using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>Volumes for tests.</summary>
    static class Volumes
    {
        /// <summary>4 x 3 x 2 voxels of 0.5 x 1.25 x 2 mm with the segments of <see cref="SegmentTables.Some"/>.</summary>
        public static SegmentedVolume Small()
        {
            var geometry = new VolumeGeometry(4, 3, 2, Affine.FromColumns(
                new VectorMm(0.5, 0, 0), new VectorMm(0, 1.25, 0), new VectorMm(0, 0, 2), new PointMm(0, 0, 0)));
            ushort[] codes = Enumerable.Range(0, 24).Select(v => (ushort)v).ToArray();
            return new SegmentedVolume(
                new IntensityVolume(geometry, codes, -1000.5, 1, -977.5), new LabelMap(geometry, new ushort[24], SegmentTables.Some));
        }
    }
}
