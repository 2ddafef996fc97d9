using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>The spheres that one of two carvings has and the other has not. Order and repetition change no picture, so they do not count.</summary>
    static class SphereDifference
    {
        public static IReadOnlyList<ClipSphere> Between(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after)
        {
            if (before == null)
                throw new ArgumentNullException(nameof(before));
            if (after == null)
                throw new ArgumentNullException(nameof(after));
            if (ReferenceEquals(before, after))
                return Array.Empty<ClipSphere>();
            if (before is CarvingSnapshot a && after is CarvingSnapshot b && a.SharesFixedWith(b))
                return OfActive(a.Active, b.Active);
            var difference = new List<ClipSphere>();
            AddMissing(before, after, difference);
            AddMissing(after, before, difference);
            return difference;
        }

        static IReadOnlyList<ClipSphere> OfActive(ClipSphere before, ClipSphere after)
        {
            if (Equals(before, after))
                return Array.Empty<ClipSphere>();
            if (before is null || after is null)
                return new[] { before ?? after };
            return new[] { before, after };
        }

        static void AddMissing(IReadOnlyList<ClipSphere> from, IReadOnlyList<ClipSphere> present, List<ClipSphere> missing)
        {
            var known = new HashSet<ClipSphere>(present);
            foreach (ClipSphere sphere in from)
            {
                if (!known.Contains(sphere))
                    missing.Add(sphere);
            }
        }
    }
}
