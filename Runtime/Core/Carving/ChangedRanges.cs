using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>Where along k, in rectangles of columns, the spheres in which two carvings differ make a difference. For few of them.</summary>
    sealed class ChangedRanges
    {
        readonly ChangedSpheres changed;
        readonly KRange[] touched = new KRange[ChangedSpheres.Few], covered = new KRange[ChangedSpheres.Few];
        readonly List<int> lenders = new List<int>();
        bool lendInside; // whether other surfaces than theirs are near

        public ChangedRanges(ChangedSpheres changed) => this.changed = changed;

        /// <summary>
        /// Where along k opacities within a halo of a brick's columns can differ, as far as the spheres' places say so: where one touches, but not where it and one
        /// of the other carving with the same mask cover all.
        /// </summary>
        /// <param name="columns">The columns with the halo around them.</param>
        /// <param name="haloVoxels">The halo along k.</param>
        public KRange Differing(in VoxelBox columns, int haloVoxels)
        {
            for (int number = 0; number < changed.Count; number++)
                changed.Reach.Along(changed[number].Place, columns, out touched[number], out covered[number]);
            KRange range = KRange.Nowhere;
            for (int number = 0; number < changed.Count; number++)
                if (!touched[number].IsEmpty)
                    range = range.Or(Outside(touched[number], CoveredInBoth(number), haloVoxels, columns));
            return range;
        }

        /// <summary>Where along k a sphere, and one of the other carving that clips the same, both cover all of the columns.</summary>
        KRange CoveredInBoth(int number)
        {
            if (covered[number].IsEmpty)
                return KRange.Nowhere;
            (int first, int end) = changed.OppositesOf(number);
            for (int other = first; other < end; other++)
            {
                KRange both = covered[number].And(covered[other]);
                if (!both.IsEmpty && changed[number].Mask.Equals(changed[other].Mask))
                    return both;
            }
            return KRange.Nowhere;
        }

        /// <summary>Finds the spheres that can change the normals of a brick by themselves, for <see cref="WithOtherNormals"/>.</summary>
        public void FindLenders(int x, int y, int z)
        {
            lenders.Clear();
            for (int number = 0; number < changed.Count; number++)
                if (changed.LendsNormals(number, x, y, z))
                    lenders.Add(number);
            lendInside = lenders.Count > 0 && (changed.Index == null || changed.Index.HasOtherSurfaceIn(x, y, z));
        }

        /// <summary>Where along k columns of that brick can take another normal because a sphere's surface came or went.</summary>
        public KRange WithOtherNormals(in VoxelBox columns)
        {
            KRange range = KRange.Nowhere;
            foreach (int number in lenders)
            {
                changed.Reach.Along(changed[number].Surface, columns, out KRange near, out KRange deep);
                range = range.Or(Outside(near, lendInside ? KRange.Nowhere : deep, 0, columns)); // deep inside all is as it was, if no other's surface is there
            }
            return range;
        }

        /// <summary>Where within the columns' ends a place within a halo lies in a range, but not in another.</summary>
        static KRange Outside(KRange range, KRange without, int haloVoxels, in VoxelBox columns)
        {
            KRange all = range.And(new KRange(columns.MinK - haloVoxels, columns.MaxK + haloVoxels));
            if (without.IsEmpty)
                return all.Widened(haloVoxels);
            var own = new KRange(columns.MinK, columns.MaxK);
            KRange below = all.And(new KRange(int.MinValue, without.First - 1)), above = all.And(new KRange(without.Last + 1, int.MaxValue));
            return below.Widened(haloVoxels).And(own).Or(above.Widened(haloVoxels).And(own));
        }
    }
}
