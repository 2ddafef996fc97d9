using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// The spheres that one of two carvings has and the other has not. Order and repetition change no picture, so they do not count. Where both begin or end
    /// with the same spheres these are only compared, so that an edit costs next to nothing however long the stack. Its lists are used again.
    /// </summary>
    sealed class SphereDifference
    {
        /// <summary>Up to so many spheres are looked for one by one, without a table of all.</summary>
        const int Few = 32;

        readonly HashSet<ClipSphere> known = new HashSet<ClipSphere>();

        /// <summary>Spheres that only the first has.</summary>
        public List<ClipSphere> Removed { get; } = new List<ClipSphere>();

        /// <summary>Spheres that only the second has.</summary>
        public List<ClipSphere> Added { get; } = new List<ClipSphere>();

        /// <summary>The number of spheres in both lists.</summary>
        public int Count => Removed.Count + Added.Count;

        public void Between(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after)
        {
            if (before == null)
                throw new ArgumentNullException(nameof(before));
            if (after == null)
                throw new ArgumentNullException(nameof(after));
            Removed.Clear();
            Added.Clear();
            if (ReferenceEquals(before, after))
                return;
            if (before is CarvingSnapshot a && after is CarvingSnapshot b && a.SharesFixedWith(b))
            {
                if (Equals(a.Active, b.Active))
                    return;
                if (!IsIn(a.Active, after))
                    Add(Removed, a.Active);
                if (!IsIn(b.Active, before))
                    Add(Added, b.Active);
                return;
            }
            int first = 0, beforeEnd = before.Count, afterEnd = after.Count;
            while (first < beforeEnd && first < afterEnd && before[first].Equals(after[first]))
                first++;
            while (beforeEnd > first && afterEnd > first && before[beforeEnd - 1].Equals(after[afterEnd - 1]))
            {
                beforeEnd--;
                afterEnd--;
            }
            AddMissing(before, first, beforeEnd, after, Removed);
            AddMissing(after, first, afterEnd, before, Added);
        }

        static void Add(List<ClipSphere> list, ClipSphere sphere)
        {
            if (sphere is object && sphere.CanClip)
                list.Add(sphere);
        }

        void AddMissing(IReadOnlyList<ClipSphere> from, int start, int end, IReadOnlyList<ClipSphere> present, List<ClipSphere> missing)
        {
            known.Clear();
            bool many = end - start > Few;
            if (many)
                known.UnionWith(present);
            for (int n = start; n < end; n++)
                if (many ? known.Add(from[n]) : known.Add(from[n]) && !IsIn(from[n], present))
                    Add(missing, from[n]);
            known.Clear();
        }

        /// <summary>Most entries of a long stack are the very same object in both.</summary>
        static bool IsIn(ClipSphere sphere, IReadOnlyList<ClipSphere> spheres)
        {
            if (sphere is null)
                return false;
            for (int n = 0; n < spheres.Count; n++)
                if (sphere.Equals(spheres[n]))
                    return true;
            return false;
        }
    }
}
