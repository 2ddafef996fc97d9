using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>Everything that decides a carved field besides the volume, taken at one moment so that it can be compared with the next.</summary>
    sealed class CarvingInputs
    {
        readonly CutMode cut;
        readonly SegmentTable segments;

        CarvingInputs(IReadOnlyList<ClipSphere> spheres, OpacityTransferFunction transferFunction, SegmentTable segments, CutMode cut, AntiAliasSettings antiAlias)
        {
            Spheres = spheres;
            TransferFunction = transferFunction;
            this.segments = segments;
            SegmentOpacities = segments.Select(segment => segment.Opacity).ToArray();
            this.cut = cut;
            AntiAlias = antiAlias;
        }

        public IReadOnlyList<ClipSphere> Spheres { get; }

        public OpacityTransferFunction TransferFunction { get; }

        public float[] SegmentOpacities { get; }

        public AntiAliasSettings AntiAlias { get; }

        public static CarvingInputs Take(
            SegmentedVolume volume, IReadOnlyList<ClipSphere> spheres, OpacityTransferFunction transferFunction, SegmentTable segments, CutMode cut, AntiAliasSettings antiAlias)
        {
            if (spheres == null)
                throw new ArgumentNullException(nameof(spheres));
            if (segments == null)
                throw new ArgumentNullException(nameof(segments));
            if (segments.Count != volume.Segments.Count)
                throw new ArgumentException(FormattableString.Invariant(
                    $"The table has {segments.Count} segments, the volume {volume.Segments.Count}."), nameof(segments));
            foreach (ClipSphere sphere in spheres)
            {
                if (sphere.Mask.SegmentCount != volume.Segments.Count)
                    throw new ArgumentException(FormattableString.Invariant(
                        $"A sphere's mask is for {sphere.Mask.SegmentCount} segments, the volume has {volume.Segments.Count}."), nameof(spheres));
            }
            return new CarvingInputs(
                spheres as CarvingSnapshot ?? (IReadOnlyList<ClipSphere>)spheres.ToArray(),
                transferFunction ?? throw new ArgumentNullException(nameof(transferFunction)),
                segments,
                cut,
                antiAlias ?? throw new ArgumentNullException(nameof(antiAlias)));
        }

        /// <summary>Whether these inputs were taken from the very same objects. Never of a list that may change.</summary>
        public bool AreExactly(
            IReadOnlyList<ClipSphere> spheres, OpacityTransferFunction transferFunction, SegmentTable segments, CutMode cut, AntiAliasSettings antiAlias) =>
            ReferenceEquals(Spheres, spheres)
            && ReferenceEquals(TransferFunction, transferFunction)
            && ReferenceEquals(this.segments, segments)
            && this.cut == cut
            && AntiAlias.Equals(antiAlias);

        /// <summary>Whether at most the spheres and the anti-aliasing differ.</summary>
        public bool SharesOpacitiesWith(CarvingInputs other) =>
            cut == other.cut
            && SegmentOpacities.AsSpan().SequenceEqual(other.SegmentOpacities)
            && SharesTransferFunctionWith(other);

        /// <summary>Whether both show the same intensities.</summary>
        public bool SharesTransferFunctionWith(CarvingInputs other) =>
            ReferenceEquals(TransferFunction, other.TransferFunction) || TransferFunction.Points.SequenceEqual(other.TransferFunction.Points);
    }
}
