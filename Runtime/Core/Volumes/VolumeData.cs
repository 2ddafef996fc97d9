using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// An image as a file has it: its voxels in their stored type and order, where they lie, and what the header says beside.
    /// What a reader returns; <see cref="IntensityVolume"/> and <see cref="LabelMap"/> are made from it.
    /// </summary>
    public sealed class VolumeData
    {
        /// <summary>Makes an image. The array is kept, not copied.</summary>
        /// <param name="geometry">Where the voxels lie.</param>
        /// <param name="voxels">sbyte[], byte[], short[], ushort[], int[], uint[], long[], ulong[], float[] or double[], one element per value.</param>
        /// <param name="components">Values per voxel, at least 1.</param>
        /// <param name="order">Where the values of one voxel lie.</param>
        /// <param name="slope">value = slope * stored + intercept; finite, not 0.</param>
        /// <param name="intercept">See <paramref name="slope"/>; finite.</param>
        /// <param name="description">What the file says beside the voxels; null for nothing.</param>
        /// <exception cref="ArgumentException">An array of another type or length, or a scaling that can't be used.</exception>
        public VolumeData(
            VolumeGeometry geometry,
            Array voxels,
            int components = 1,
            ComponentOrder order = ComponentOrder.Fastest,
            double slope = 1,
            double intercept = 0,
            VolumeDescription description = null)
        {
            Geometry = geometry ?? throw new ArgumentNullException(nameof(geometry));
            VoxelType = VoxelTypes.Of(voxels);
            if (components < 1 || voxels.LongLength != geometry.VoxelCount * components)
                throw new ArgumentException(
                    FormattableString.Invariant($"{geometry.SizeI} x {geometry.SizeJ} x {geometry.SizeK} voxels of {components} values don't make {voxels.LongLength} values."),
                    nameof(voxels));
            if (slope == 0 || !double.IsFinite(slope) || !double.IsFinite(intercept))
                throw new ArgumentException(FormattableString.Invariant($"Values can't be scaled by slope {slope} and intercept {intercept}."), nameof(slope));
            Voxels = voxels;
            Components = components;
            ComponentOrder = order;
            Slope = slope;
            Intercept = intercept;
            description ??= new VolumeDescription();
            Segments = description.Segments.ToArray();
            Warnings = description.Warnings.ToArray();
            Metadata = new Dictionary<string, string>(description.Metadata);
            Source = description.Source ?? string.Empty;
            Format = description.Format ?? string.Empty;
        }

        /// <summary>Where the voxels lie.</summary>
        public VolumeGeometry Geometry { get; }

        /// <summary>The stored type.</summary>
        public VoxelType VoxelType { get; }

        /// <summary>Values per voxel: channels, time points or layers.</summary>
        public int Components { get; }

        /// <summary>Where the values of one voxel lie.</summary>
        public ComponentOrder ComponentOrder { get; }

        /// <summary>The stored values in the file's order; the array's type is that of <see cref="VoxelType"/>. Not to be changed.</summary>
        public Array Voxels { get; }

        /// <summary>value = Slope * stored + Intercept.</summary>
        public double Slope { get; }

        /// <summary>value = Slope * stored + Intercept.</summary>
        public double Intercept { get; }

        /// <summary>True when values differ from the stored ones.</summary>
        public bool HasScaling => Slope != 1 || Intercept != 0;

        /// <summary>The segments that the file names; empty if none.</summary>
        public IReadOnlyList<SegmentInfo> Segments { get; }

        /// <summary>What was odd in the file but could be read, a sentence each.</summary>
        public IReadOnlyList<string> Warnings { get; }

        /// <summary>Key/value pairs of the file's header, as they stand there (escapes resolved).</summary>
        public IReadOnlyDictionary<string, string> Metadata { get; }

        /// <summary>The file, or what the caller named the stream.</summary>
        public string Source { get; }

        /// <summary>The file format's name, such as "NIfTI-1" or "NRRD".</summary>
        public string Format { get; }

        /// <summary>A stored value, converted to double.</summary>
        /// <param name="index">Its place in <see cref="Voxels"/>.</param>
        public double StoredValue(long index) => VoxelConversion.At(Voxels, VoxelType, index);

        /// <summary>A value after slope and intercept.</summary>
        /// <param name="index">Its place in <see cref="Voxels"/>.</param>
        public double Value(long index) => HasScaling ? Slope * StoredValue(index) + Intercept : StoredValue(index);

        /// <summary>A voxel's value after slope and intercept.</summary>
        /// <param name="i">0 to SizeI - 1.</param>
        /// <param name="j">0 to SizeJ - 1.</param>
        /// <param name="k">0 to SizeK - 1.</param>
        /// <param name="component">0 to <see cref="Components"/> - 1.</param>
        /// <exception cref="ArgumentOutOfRangeException">An index outside its range.</exception>
        public double Value(int i, int j, int k, int component = 0)
        {
            if (i < 0 || i >= Geometry.SizeI || j < 0 || j >= Geometry.SizeJ || k < 0 || k >= Geometry.SizeK)
                throw new ArgumentOutOfRangeException(nameof(i), FormattableString.Invariant($"({i}, {j}, {k}) lies outside the volume."));
            return Value(IndexOf(i + (long)Geometry.SizeI * (j + (long)Geometry.SizeJ * k), component));
        }

        /// <summary>Minimum, maximum, mean and hash of all values after slope and intercept.</summary>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public VolumeStatistics Statistics(CancellationToken cancellation = default) =>
            VolumeStatistics.Of(this, Slope, Intercept, cancellation);

        /// <summary>Minimum, maximum, mean and hash of all stored values, converted to double.</summary>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        public VolumeStatistics StoredStatistics(CancellationToken cancellation = default) =>
            VolumeStatistics.Of(this, 1, 0, cancellation);

        /// <summary>The place in <see cref="Voxels"/> of one component of a voxel.</summary>
        /// <param name="voxel">i + SizeI * (j + SizeJ * k).</param>
        /// <param name="component">0 to <see cref="Components"/> - 1.</param>
        /// <exception cref="ArgumentOutOfRangeException">No such component.</exception>
        internal long IndexOf(long voxel, int component)
        {
            CheckComponent(component);
            return ComponentOrder == ComponentOrder.Fastest ? voxel * Components + component : voxel + component * Geometry.VoxelCount;
        }

        /// <summary>Throws when there is no such component.</summary>
        internal void CheckComponent(int component)
        {
            if (component < 0 || component >= Components)
                throw new ArgumentOutOfRangeException(nameof(component), component, FormattableString.Invariant($"The image has components 0 to {Components - 1}."));
        }
    }
}
