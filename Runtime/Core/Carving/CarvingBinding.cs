using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// A carving document fitted to a volume's segments, and the way back. A segment is found by its label; by its name, whatever the case, where only
    /// the name is known.
    /// </summary>
    public sealed class CarvingBinding
    {
        CarvingBinding(IReadOnlyList<ClipSphere> fixedSpheres, ClipSphere active, IReadOnlyList<string> warnings)
        {
            Fixed = fixedSpheres;
            Active = active;
            Warnings = warnings;
        }

        /// <summary>The fixed spheres, oldest first, for <see cref="CarvingStack.Replace"/>.</summary>
        public IReadOnlyList<ClipSphere> Fixed { get; }

        /// <summary>The active sphere; null = none.</summary>
        public ClipSphere Active { get; }

        /// <summary>
        /// The document's warnings, then a sentence for every segment that the volume lacks, that has another name than its label says, or whose name is
        /// not unique; each said once.
        /// </summary>
        public IReadOnlyList<string> Warnings { get; }

        /// <summary>Fits a document to a volume's segments. What the volume lacks is left out and warned about; the document keeps it.</summary>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        public static CarvingBinding Bind(CarvingDocument document, SegmentTable segments)
        {
            if (document == null)
                throw new ArgumentNullException(nameof(document));
            if (segments == null)
                throw new ArgumentNullException(nameof(segments));
            var warnings = new List<string>(document.Warnings);
            var found = new Dictionary<SegmentReference, int>();
            ClipSphere Sphere(CarvingDocumentSphere sphere)
            {
                var mask = SegmentMask.FromIndices(segments.Count, Indices(sphere, segments, found, warnings));
                return new ClipSphere(sphere.CentreLps, sphere.RadiusMm, mask);
            }
            ClipSphere[] fixedSpheres = document.Fixed.Select(Sphere).ToArray();
            ClipSphere active = document.Active is null ? null : Sphere(document.Active);
            return new CarvingBinding(Array.AsReadOnly(fixedSpheres), active, warnings.AsReadOnly());
        }

        /// <summary>The document of a carving: every clipped segment with label and name.</summary>
        /// <param name="carving">The carving.</param>
        /// <param name="segments">The volume's segments.</param>
        /// <param name="previous">
        /// The document that the carving was read from, or null. Segments that the volume lacks are taken over from it for spheres that still
        /// are where they were, so that loading and saving loses nothing.
        /// </param>
        /// <exception cref="ArgumentNullException"><paramref name="carving"/> or <paramref name="segments"/> is null.</exception>
        /// <exception cref="ArgumentException">A mask is for another number of segments.</exception>
        public static CarvingDocument Document(CarvingSnapshot carving, SegmentTable segments, CarvingDocument previous = null)
        {
            if (carving == null)
                throw new ArgumentNullException(nameof(carving));
            if (segments == null)
                throw new ArgumentNullException(nameof(segments));
            IReadOnlyList<CarvingDocumentSphere> old = previous?.Fixed ?? Array.Empty<CarvingDocumentSphere>();
            return new CarvingDocument(
                carving.Fixed.Select((sphere, index) => Sphere(sphere, segments, index < old.Count ? old[index] : null)),
                carving.Active is null ? null : Sphere(carving.Active, segments, previous?.Active));
        }

        static CarvingDocumentSphere Sphere(ClipSphere sphere, SegmentTable segments, CarvingDocumentSphere old)
        {
            if (sphere.Mask.SegmentCount != segments.Count)
                throw new ArgumentException(FormattableString.Invariant(
                    $"A sphere's mask is for {sphere.Mask.SegmentCount} segments, the table has {segments.Count}."), nameof(segments));
            IEnumerable<SegmentReference> clipped = sphere.Mask.ClippedSegments()
                .Select(index => new SegmentReference(segments[index].Label, segments[index].Name));
            var written = new CarvingDocumentSphere(sphere.CentreLps, sphere.RadiusMm, clipped);
            if (!written.SamePlace(old))
                return written;
            IEnumerable<SegmentReference> lacking = old.Clipped.Where(reference => IndexOf(reference, segments) < 0);
            return new CarvingDocumentSphere(sphere.CentreLps, sphere.RadiusMm, written.Clipped.Concat(lacking));
        }

        static IEnumerable<int> Indices(
            CarvingDocumentSphere sphere, SegmentTable segments, Dictionary<SegmentReference, int> found, List<string> warnings)
        {
            foreach (SegmentReference reference in sphere.Clipped)
            {
                if (!found.TryGetValue(reference, out int index))
                {
                    index = IndexOf(reference, segments);
                    found.Add(reference, index);
                    string warning = Warning(reference, index, segments);
                    if (warning != null)
                        warnings.Add(warning);
                }
                if (index >= 0)
                    yield return index;
            }
        }

        static int IndexOf(SegmentReference reference, SegmentTable segments) =>
            reference.Label is long label ? segments.IndexOfLabel(label) : segments.FindByName(reference.Name)?.Index ?? -1;

        static string Warning(SegmentReference reference, int index, SegmentTable segments)
        {
            if (index < 0)
                return $"The carving clips {reference}, which this volume does not have.";
            if (reference.Label != null && reference.Name != null && reference.Name != segments[index].Name)
                return $"The carving calls {reference} what this volume calls \"{segments[index].Name}\"; the label counts.";
            if (reference.Label == null && segments.Count(segment => string.Equals(segment.Name, reference.Name, StringComparison.OrdinalIgnoreCase)) > 1)
                return FormattableString.Invariant(
                    $"The carving clips {reference}; this volume has several segments of that name, and the one with label {segments[index].Label} is taken.");
            return null;
        }
    }
}
