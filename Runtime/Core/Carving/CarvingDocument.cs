using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>A segment as a carving file names it: by label, by name or by both, never by neither. Immutable.</summary>
    public readonly struct SegmentReference : IEquatable<SegmentReference>
    {
        /// <summary>Names a segment.</summary>
        /// <param name="label">Its value in the label map; null = only the name is known.</param>
        /// <param name="name">Its name; null = only the label is known.</param>
        /// <exception cref="ArgumentException">Neither is given.</exception>
        public SegmentReference(long? label, string name)
        {
            if (label == null && name == null)
                throw new ArgumentException("A segment is named by its label, its name or both.", nameof(label));
            Label = label;
            Name = name;
        }

        /// <summary>The segment's value in the label map; null where only the name is known.</summary>
        public long? Label { get; }

        /// <summary>The segment's name; null where only the label is known.</summary>
        public string Name { get; }

        /// <inheritdoc/>
        public bool Equals(SegmentReference other) => Label == other.Label && string.Equals(Name, other.Name, StringComparison.Ordinal);

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is SegmentReference other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Label, Name);

        /// <summary>For messages: label 5 "liver".</summary>
        public override string ToString() =>
            Label == null ? $"\"{Name}\"" : FormattableString.Invariant($"label {Label}") + (Name == null ? "" : $" \"{Name}\"");
    }

    /// <summary>A clip sphere as a carving file holds it. Immutable.</summary>
    public sealed class CarvingDocumentSphere
    {
        /// <summary>Makes a sphere.</summary>
        /// <param name="centerLps">LPS millimetres, each coordinate within +-<see cref="ClipSphere.LargestMm"/>.</param>
        /// <param name="radiusMm">Millimetres, 0 to <see cref="ClipSphere.LargestMm"/>.</param>
        /// <param name="clipped">The segments that it clips.</param>
        /// <exception cref="ArgumentOutOfRangeException">A number lies outside its range.</exception>
        /// <exception cref="ArgumentNullException"><paramref name="clipped"/> is null.</exception>
        public CarvingDocumentSphere(PointMm centerLps, double radiusMm, IEnumerable<SegmentReference> clipped)
        {
            ClipSphere.CheckPlace(centerLps, nameof(centerLps), radiusMm, nameof(radiusMm));
            CentreLps = centerLps;
            RadiusMm = radiusMm;
            Clipped = Array.AsReadOnly((clipped ?? throw new ArgumentNullException(nameof(clipped))).ToArray());
        }

        /// <summary>Centre, LPS millimetres.</summary>
        public PointMm CentreLps { get; }

        /// <summary>Radius, millimetres.</summary>
        public double RadiusMm { get; }

        /// <summary>The segments that the sphere clips, in the file's order; also those that the volume at hand lacks.</summary>
        public IReadOnlyList<SegmentReference> Clipped { get; }

        internal bool SamePlace(CarvingDocumentSphere other) =>
            other is object && CentreLps.Equals(other.CentreLps) && RadiusMm.Equals(other.RadiusMm);
    }

    /// <summary>
    /// What a carving file says, whatever volume is at hand: spheres by place and by names of segments. <see cref="CarvingBinding"/> fits it to a
    /// volume's segments and back; segments that the volume lacks stay here. Immutable.
    /// </summary>
    public sealed class CarvingDocument
    {
        /// <summary>Makes a document.</summary>
        /// <param name="fixedSpheres">The fixed spheres, oldest first.</param>
        /// <param name="active">The active sphere; null = none.</param>
        /// <param name="warnings">What a reader found odd; null = nothing.</param>
        /// <exception cref="ArgumentNullException"><paramref name="fixedSpheres"/> is null.</exception>
        public CarvingDocument(
            IEnumerable<CarvingDocumentSphere> fixedSpheres, CarvingDocumentSphere active = null, IEnumerable<string> warnings = null)
        {
            Fixed = Array.AsReadOnly((fixedSpheres ?? throw new ArgumentNullException(nameof(fixedSpheres))).ToArray());
            Active = active;
            Warnings = Array.AsReadOnly((warnings ?? Array.Empty<string>()).ToArray());
        }

        /// <summary>The fixed spheres, oldest first.</summary>
        public IReadOnlyList<CarvingDocumentSphere> Fixed { get; }

        /// <summary>The active sphere; null = none.</summary>
        public CarvingDocumentSphere Active { get; }

        /// <summary>What the reader found odd but could read, a sentence each.</summary>
        public IReadOnlyList<string> Warnings { get; }
    }
}
