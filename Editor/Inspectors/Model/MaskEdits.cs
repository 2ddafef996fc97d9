using System.Collections.Generic;
using AnatomyCarve.Carving;

namespace AnatomyCarve.Editor
{
    /// <summary>What an edit of several segments' mask bits does.</summary>
    enum MaskEdit
    {
        /// <summary>The sphere clips them.</summary>
        Clip,

        /// <summary>The sphere leaves them.</summary>
        Keep,

        /// <summary>It clips those that it left, and leaves those that it clipped.</summary>
        Invert,
    }

    /// <summary>Edits of many segments in a clip sphere's mask at once.</summary>
    static class MaskEdits
    {
        /// <summary>The mask after an edit of some of its segments; the same mask where the edit changes nothing.</summary>
        public static SegmentMask Apply(SegmentMask mask, MaskEdit edit, IReadOnlyList<int> segments)
        {
            var clipped = new bool[mask.SegmentCount];
            foreach (int segment in mask.ClippedSegments())
                clipped[segment] = true;
            bool changed = false;
            for (int s = 0; s < segments.Count; s++)
            {
                int segment = segments[s];
                bool wanted = edit == MaskEdit.Invert ? !clipped[segment] : edit == MaskEdit.Clip;
                changed |= wanted != clipped[segment];
                clipped[segment] = wanted;
            }
            return changed ? SegmentMask.FromIndices(mask.SegmentCount, Indices(clipped)) : mask;
        }

        static IEnumerable<int> Indices(bool[] clipped)
        {
            for (int segment = 0; segment < clipped.Length; segment++)
                if (clipped[segment])
                    yield return segment;
        }
    }
}
