using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// The spheres that only one of two carvings has, and where each of them matters: the part of <see cref="DirtyBrickSet"/> that looks at spheres. A sphere
    /// that stands in both in the same place but with another mask counts once, with the segments in which the masks differ.
    /// </summary>
    sealed class ChangedSpheres
    {
        /// <summary>Up to so many, each is compared with each.</summary>
        const int Few = 16;

        readonly BrickGrid bricks;
        readonly CentredGrid grid;
        readonly SphereReach reach;
        readonly SphereDifference difference = new SphereDifference();
        readonly List<ClipSphere> remasked = new List<ClipSphere>();
        Changed[] spheres = new Changed[8]; // first those of the earlier carving, then of the later, then of both with another mask
        int firstAdded, firstRemasked;
        readonly KRange[] touched = new KRange[Few], covered = new KRange[Few];
        readonly List<int> lenders = new List<int>();
        bool lendInside; // whether other surfaces than theirs are near
        CutMode cut;

        public ChangedSpheres(BrickGrid bricks, CentredGrid grid)
        {
            this.bricks = bricks;
            this.grid = grid;
            reach = new SphereReach(grid);
        }

        /// <summary>What is visible before carving; null = anything may be.</summary>
        public VisibleContents Contents { get; set; }

        /// <summary>The later carving's spheres; null = where others hide what differs is not looked for.</summary>
        public SphereIndex Index { get; set; }

        public int Count { get; private set; }

        /// <summary>Whether they are so few that the surroundings of single bricks are worth a look.</summary>
        public bool AreFew => Count <= Few;

        /// <summary>Takes the spheres in which two carvings differ.</summary>
        public void Take(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, CutMode cutMode)
        {
            cut = cutMode;
            difference.Between(before, after);
            TakeRemasked();
            Count = 0;
            foreach (ClipSphere sphere in difference.Removed)
                Add(sphere);
            firstAdded = Count;
            foreach (ClipSphere sphere in difference.Added)
                Add(sphere);
            firstRemasked = Count;
            foreach (ClipSphere sphere in remasked)
                Add(sphere);
        }

        /// <summary>The voxels whose coverage or normal a sphere can change.</summary>
        public VoxelBox BoxOf(int number) => spheres[number].Box;

        /// <summary>Whether a sphere can make a difference to the opacities of a box of voxels within a brick.</summary>
        public bool Matters(int number, int x, int y, int z, in VoxelBox box)
        {
            ref readonly Changed sphere = ref spheres[number];
            ReadOnlySpan<ushort> segments = Contents == null ? default : Contents[bricks.IndexOf(x, y, z)];
            if (Contents != null && !sphere.Mask.HoldsAny(segments))
                return false;
            BoxCover cover = reach.Cover(sphere.Place, box);
            if (cover == BoxCover.None)
                return false;
            (int first, int end) = OppositesOf(number);
            if (cover == BoxCover.Whole && end - first <= Few)
                for (int other = first; other < end; other++)
                    if ((Contents == null ? sphere.Mask.Equals(spheres[other].Mask) : sphere.Mask.IsWithin(spheres[other].Mask, segments))
                        && reach.Cover(spheres[other].Place, box) == BoxCover.Whole)
                        return false;
            return Index == null || Contents == null || !Index.IsHiddenByOthers(x, y, z, box, cut, sphere.Mask, segments);
        }

        /// <summary>Whether any of the spheres can.</summary>
        public bool AnyMatters(int x, int y, int z, in VoxelBox box)
        {
            for (int number = 0; number < Count; number++)
                if (Matters(number, x, y, z, box))
                    return true;
            return false;
        }

        /// <summary>Whether a sphere can change the normals of a brick by itself, without a change of opacity near by.</summary>
        public bool LendsNormals(int number, int x, int y, int z)
        {
            ref readonly Changed sphere = ref spheres[number];
            if (Contents != null && !Contents.AnyIsIn(sphere.Mask, bricks.IndexOf(x, y, z)))
                return false;
            VoxelBox box = bricks.VoxelsOf(x, y, z);
            BoxCover cover = reach.Cover(sphere.Surface, box);
            if (cover != BoxCover.Whole)
                return cover == BoxCover.Part;
            (int first, int end) = OppositesOf(number);
            for (int other = first; other < end; other++)
                if (reach.Cover(spheres[other].Surface, box) == BoxCover.Part)
                    return true;
            return Index == null || Index.HasOtherSurfaceIn(x, y, z);
        }

        /// <summary>
        /// Where along k opacities within a halo of a brick's columns can differ, as far as the spheres' places say so: where one touches, but not where it and one
        /// of the other carving with the same mask cover all.
        /// </summary>
        /// <param name="columns">The columns with the halo around them.</param>
        /// <param name="haloVoxels">The halo along k.</param>
        public KRange Differing(in VoxelBox columns, int haloVoxels)
        {
            for (int number = 0; number < Count; number++)
                reach.Along(spheres[number].Place, columns, out touched[number], out covered[number]);
            KRange range = KRange.Nowhere;
            for (int number = 0; number < Count; number++)
                if (!touched[number].IsEmpty)
                    range = range.Or(Outside(touched[number], CoveredInBoth(number), haloVoxels, columns));
            return range;
        }

        /// <summary>Where along k a sphere, and one of the other carving that clips the same, both cover all of the columns.</summary>
        KRange CoveredInBoth(int number)
        {
            if (covered[number].IsEmpty)
                return KRange.Nowhere;
            (int first, int end) = OppositesOf(number);
            for (int other = first; other < end; other++)
            {
                KRange both = covered[number].And(covered[other]);
                if (!both.IsEmpty && spheres[number].Mask.Equals(spheres[other].Mask))
                    return both;
            }
            return KRange.Nowhere;
        }

        /// <summary>Finds the spheres that can change the normals of a brick by themselves, for <see cref="WithOtherNormals"/>.</summary>
        public void FindLenders(int x, int y, int z)
        {
            lenders.Clear();
            for (int number = 0; number < Count; number++)
                if (LendsNormals(number, x, y, z))
                    lenders.Add(number);
            lendInside = lenders.Count > 0 && (Index == null || Index.HasOtherSurfaceIn(x, y, z));
        }

        /// <summary>Where along k columns of that brick can take another normal because a sphere's surface came or went.</summary>
        public KRange WithOtherNormals(in VoxelBox columns)
        {
            KRange range = KRange.Nowhere;
            foreach (int number in lenders)
            {
                reach.Along(spheres[number].Surface, columns, out KRange near, out KRange deep);
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

        /// <summary>The first and the end of the spheres that only the other carving has; none for one that stands in both.</summary>
        (int first, int end) OppositesOf(int number) => number < firstAdded ? (firstAdded, firstRemasked) : number < firstRemasked ? (0, firstAdded) : (0, 0);

        /// <summary>Takes the spheres that stand in both carvings in the same place out of both lists.</summary>
        void TakeRemasked()
        {
            remasked.Clear();
            if (difference.Count > Few)
                return;
            for (int r = difference.Removed.Count - 1; r >= 0; r--)
            {
                ClipSphere before = difference.Removed[r];
                int a = difference.Added.FindIndex(sphere =>
                    sphere.CentreLps.Equals(before.CentreLps) && sphere.RadiusMm.Equals(before.RadiusMm) && sphere.Mask.SegmentCount == before.Mask.SegmentCount);
                if (a < 0)
                    continue;
                remasked.Add(before.WithMask(before.Mask.DifferenceFrom(difference.Added[a].Mask)));
                difference.Removed.RemoveAt(r);
                difference.Added.RemoveAt(a);
            }
        }

        void Add(ClipSphere sphere)
        {
            SphereF place = grid.ToCentred(sphere);
            if (!reach.TrySurfaceBox(place, out VoxelBox box))
                return;
            if (Count == spheres.Length)
                Array.Resize(ref spheres, 2 * Count);
            spheres[Count++] = new Changed(sphere.Mask, reach.Of(place, cut), reach.SurfaceOf(place), box);
        }

        readonly struct Changed
        {
            public Changed(SegmentMask mask, in SphereReach.Ready place, in SphereReach.Ready surface, in VoxelBox box)
            {
                Mask = mask;
                Place = place;
                Surface = surface;
                Box = box;
            }

            public SegmentMask Mask { get; }

            public SphereReach.Ready Place { get; }

            public SphereReach.Ready Surface { get; }

            public VoxelBox Box { get; }
        }
    }
}
