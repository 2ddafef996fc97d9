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
        public const int Few = 16;

        readonly BrickGrid bricks;
        readonly CentredGrid grid;
        readonly SphereDifference difference = new SphereDifference();
        readonly List<ClipSphere> remasked = new List<ClipSphere>();
        Changed[] spheres = new Changed[8]; // first those of the earlier carving, then of the later, then of both with another mask
        int firstAdded, firstRemasked;
        CutMode cut;

        public ChangedSpheres(BrickGrid bricks, CentredGrid grid)
        {
            this.bricks = bricks;
            this.grid = grid;
            Reach = new SphereReach(grid);
        }

        /// <summary>What is visible before carving; null = anything may be.</summary>
        public VisibleContents Contents { get; set; }

        /// <summary>The later carving's spheres; null = where others hide what differs is not looked for.</summary>
        public SphereIndex Index { get; set; }

        public SphereReach Reach { get; }

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

        /// <summary>One of them.</summary>
        public ref readonly Changed this[int number] => ref spheres[number];

        /// <summary>Whether a sphere can make a difference to the opacities of a box of voxels within a brick.</summary>
        public bool Matters(int number, int x, int y, int z, in VoxelBox box)
        {
            ref readonly Changed sphere = ref spheres[number];
            ReadOnlySpan<ushort> segments = Contents == null ? default : Contents[bricks.IndexOf(x, y, z)];
            if (Contents != null && !sphere.Mask.HoldsAny(segments))
                return false;
            BoxCover cover = Reach.Cover(sphere.Place, box);
            if (cover == BoxCover.None)
                return false;
            (int first, int end) = OppositesOf(number);
            if (cover == BoxCover.Whole && end - first <= Few)
                for (int other = first; other < end; other++)
                    if ((Contents == null ? sphere.Mask.Equals(spheres[other].Mask) : sphere.Mask.IsWithin(spheres[other].Mask, segments))
                        && Reach.Cover(spheres[other].Place, box) == BoxCover.Whole)
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
            BoxCover cover = Reach.Cover(sphere.Surface, box);
            if (cover != BoxCover.Whole)
                return cover == BoxCover.Part;
            (int first, int end) = OppositesOf(number);
            for (int other = first; other < end; other++)
                if (Reach.Cover(spheres[other].Surface, box) == BoxCover.Part)
                    return true;
            return Index == null || Index.HasOtherSurfaceIn(x, y, z);
        }

        /// <summary>The first and the end of the spheres that only the other carving has; none for one that stands in both.</summary>
        public (int first, int end) OppositesOf(int number) => number < firstAdded ? (firstAdded, firstRemasked) : number < firstRemasked ? (0, firstAdded) : (0, 0);

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
            if (!Reach.TrySurfaceBox(place, out VoxelBox box))
                return;
            if (Count == spheres.Length)
                Array.Resize(ref spheres, 2 * Count);
            spheres[Count++] = new Changed(sphere.Mask, Reach.Of(place, cut), Reach.SurfaceOf(place), box);
        }

        /// <summary>A sphere, and where it matters.</summary>
        public readonly struct Changed
        {
            public Changed(SegmentMask mask, in SphereReach.Ready place, in SphereReach.Ready surface, in VoxelBox box)
            {
                Mask = mask;
                Place = place;
                Surface = surface;
                Box = box;
            }

            public SegmentMask Mask { get; }

            /// <summary>Where it clips.</summary>
            public SphereReach.Ready Place { get; }

            /// <summary>Where it can lend voxels its normal.</summary>
            public SphereReach.Ready Surface { get; }

            /// <summary>The voxels whose coverage or normal it can change.</summary>
            public VoxelBox Box { get; }
        }
    }
}
