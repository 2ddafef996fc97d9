using System;
using System.Collections.Generic;
using System.Linq;

namespace AnatomyCarve.Volumes
{
    /// <summary>What is shown and carved: intensities and the segments of the same grid. Immutable.</summary>
    public sealed class SegmentedVolume
    {
        /// <summary>How far the corners of both grids may lie apart, mm.</summary>
        public const double GeometryToleranceMm = 0.01;

        readonly Lazy<OpacityTransferFunction> automatic;
        readonly Lazy<IntensityHistogram> histogram;
        readonly Lazy<BlockContents> blocks;

        /// <summary>Puts intensities and labels together.</summary>
        /// <param name="intensity">The scan.</param>
        /// <param name="labels">Its segments, on the same grid.</param>
        /// <param name="warnings">What was odd in both, a sentence each; null = what each of them says.</param>
        /// <exception cref="ArgumentNullException">One of them is null.</exception>
        /// <exception cref="VolumeMismatchException">The grids differ in size, or by more than 0.01 mm in place.</exception>
        public SegmentedVolume(IntensityVolume intensity, LabelMap labels, IEnumerable<string> warnings = null)
        {
            Intensity = intensity ?? throw new ArgumentNullException(nameof(intensity));
            Labels = labels ?? throw new ArgumentNullException(nameof(labels));
            if (!intensity.Geometry.Matches(labels.Geometry, GeometryToleranceMm, out string difference))
                throw new VolumeMismatchException("The scan and its segmentation lie on different grids. " + difference);
            Warnings = (warnings ?? intensity.Warnings.Concat(labels.Warnings)).ToArray();
            automatic = new Lazy<OpacityTransferFunction>(() => OpacityTransferFunction.Automatic(intensity));
            histogram = new Lazy<IntensityHistogram>(() => IntensityHistogram.Of(intensity));
            blocks = new Lazy<BlockContents>(() => BlockContents.Of(intensity, labels));
        }

        /// <summary>The same, with what was computed from the intensities before.</summary>
        /// <param name="histogram">Null = it is computed when it is first asked for.</param>
        /// <param name="origin">See <see cref="Origin"/>.</param>
        internal SegmentedVolume(
            IntensityVolume intensity, LabelMap labels, IEnumerable<string> warnings, OpacityTransferFunction automatic, IntensityHistogram histogram,
            object origin)
            : this(intensity, labels, warnings)
        {
            this.automatic = new Lazy<OpacityTransferFunction>(automatic);
            if (histogram != null)
                this.histogram = new Lazy<IntensityHistogram>(histogram);
            Origin = origin;
        }

        SegmentedVolume(SegmentedVolume other, string[] warnings)
        {
            (Intensity, Labels, Warnings, Origin) = (other.Intensity, other.Labels, warnings, other.Origin);
            (automatic, histogram, blocks) = (other.automatic, other.histogram, other.blocks);
        }

        /// <summary>The scan.</summary>
        public IntensityVolume Intensity { get; }

        /// <summary>The segments' voxels.</summary>
        public LabelMap Labels { get; }

        /// <summary>The segments by dense index, as the file gave them.</summary>
        public SegmentTable Segments => Labels.Segments;

        /// <summary>Where the voxels lie: the scan's grid.</summary>
        public VolumeGeometry Geometry => Intensity.Geometry;

        /// <summary>
        /// The same object for a volume and for those that were made coarser of the same data: what was carved in one holds in the other, as they have the same
        /// segments in the same place. It holds nothing and says nothing else.
        /// </summary>
        public object Origin { get; } = new object();

        /// <summary>What was odd while the volume was made, a sentence each; where it comes from files, each starts with the file's name.</summary>
        public IReadOnlyList<string> Warnings { get; }

        /// <summary>
        /// The transfer function that suits the scan, <see cref="OpacityTransferFunction.Automatic"/>. Computed once, when it is first asked for, on whichever
        /// thread that is; a loader asks for it before it publishes a volume.
        /// </summary>
        public OpacityTransferFunction AutomaticTransferFunction => automatic.Value;

        /// <summary>
        /// How often which intensities occur, in at most <see cref="IntensityHistogram.DefaultBins"/> bins. Computed once, when it is first asked for, on
        /// whichever thread that is.
        /// </summary>
        public IntensityHistogram Histogram => histogram.Value;

        /// <summary>
        /// Which segments lie in which blocks of 8 x 8 x 8 voxels. Computed once, when it is first asked for, on whichever thread that is; a loader asks for it
        /// before it publishes a volume.
        /// </summary>
        public BlockContents Blocks => blocks.Value;

        /// <summary>The same volume with one more warning.</summary>
        /// <param name="warning">A sentence.</param>
        /// <exception cref="ArgumentNullException"><paramref name="warning"/> is null.</exception>
        public SegmentedVolume WithWarning(string warning) => new SegmentedVolume(
            this, Warnings.Append(warning ?? throw new ArgumentNullException(nameof(warning))).ToArray());

        /// <summary>A scan without a segmentation: every voxel has label 0.</summary>
        /// <param name="intensity">The scan.</param>
        /// <param name="warnings">What was odd in it, a sentence each; may be null.</param>
        /// <exception cref="ArgumentNullException"><paramref name="intensity"/> is null.</exception>
        public static SegmentedVolume Unsegmented(IntensityVolume intensity, IEnumerable<string> warnings = null)
        {
            VolumeGeometry geometry = (intensity ?? throw new ArgumentNullException(nameof(intensity))).Geometry;
            return new SegmentedVolume(
                intensity, new LabelMap(geometry, new ushort[geometry.VoxelCount], SegmentTable.UnlabelledOnly()), warnings);
        }
    }
}
