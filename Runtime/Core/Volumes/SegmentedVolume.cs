using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>What is shown and carved: intensities and the segments of the same grid. Immutable.</summary>
    public sealed class SegmentedVolume
    {
        /// <summary>How far the corners of both grids may lie apart, mm.</summary>
        public const double GeometryToleranceMm = 0.01;

        /// <summary>Puts intensities and labels together.</summary>
        /// <param name="intensity">The scan.</param>
        /// <param name="labels">Its segments, on the same grid.</param>
        /// <exception cref="ArgumentNullException">One of them is null.</exception>
        /// <exception cref="VolumeMismatchException">The grids differ in size, or by more than 0.01 mm in place.</exception>
        public SegmentedVolume(IntensityVolume intensity, LabelMap labels)
        {
            Intensity = intensity ?? throw new ArgumentNullException(nameof(intensity));
            Labels = labels ?? throw new ArgumentNullException(nameof(labels));
            if (!intensity.Geometry.Matches(labels.Geometry, GeometryToleranceMm, out string difference))
                throw new VolumeMismatchException("The scan and its segmentation lie on different grids. " + difference);
        }

        /// <summary>The scan.</summary>
        public IntensityVolume Intensity { get; }

        /// <summary>The segments' voxels.</summary>
        public LabelMap Labels { get; }

        /// <summary>The segments by dense index, as the file gave them.</summary>
        public SegmentTable Segments => Labels.Segments;

        /// <summary>Where the voxels lie: the scan's grid.</summary>
        public VolumeGeometry Geometry => Intensity.Geometry;

        /// <summary>A scan without a segmentation: every voxel has label 0.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="intensity"/> is null.</exception>
        public static SegmentedVolume Unsegmented(IntensityVolume intensity)
        {
            VolumeGeometry geometry = (intensity ?? throw new ArgumentNullException(nameof(intensity))).Geometry;
            return new SegmentedVolume(
                intensity, new LabelMap(geometry, new ushort[geometry.VoxelCount], SegmentTable.UnlabelledOnly()));
        }
    }
}
