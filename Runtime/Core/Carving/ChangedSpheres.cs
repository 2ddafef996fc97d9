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
        readonly List<Changed> removed = new List<Changed>(), added = new List<Changed>(), remasked = new List<Changed>();
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

        public int Count => removed.Count + added.Count + remasked.Count;

        /// <summary>Whether they are so few that the surroundings of single bricks are worth a look.</summary>
        public bool AreFew => Count <= Few;

        /// <summary>Takes the spheres in which two carvings differ.</summary>
        public void Take(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, CutMode cutMode)
        {
            cut = cutMode;
            difference.Between(before, after);
            remasked.Clear();
            TakeRemasked();
            Ready(difference.Removed, removed);
            Ready(difference.Added, added);
        }

        /// <summary>The voxels whose coverage or normal a sphere can change.</summary>
        public VoxelBox BoxOf(int number) => At(number).Box;

        /// <summary>Whether a sphere can make a difference to the opacities of a box of voxels within a brick.</summary>
        public bool Matters(int number, int x, int y, int z, in VoxelBox box)
        {
            Changed sphere = At(number);
            ReadOnlySpan<ushort> segments = Contents == null ? default : Contents[bricks.IndexOf(x, y, z)];
            if (Contents != null && !sphere.Mask.HoldsAny(segments))
                return false;
            BoxCover cover = reach.Cover(sphere.Place, box);
            if (cover == BoxCover.None)
                return false;
            if (cover == BoxCover.Whole && OppositeOf(number) is List<Changed> opposite && opposite.Count <= Few)
                foreach (Changed other in opposite)
                    if ((Contents == null ? sphere.Mask.Equals(other.Mask) : sphere.Mask.IsWithin(other.Mask, segments))
                        && reach.Cover(other.Place, box) == BoxCover.Whole)
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
            Changed sphere = At(number);
            if (Contents != null && !Contents.AnyIsIn(sphere.Mask, bricks.IndexOf(x, y, z)))
                return false;
            VoxelBox box = bricks.VoxelsOf(x, y, z);
            BoxCover cover = reach.Cover(sphere.Surface, box);
            if (cover != BoxCover.Whole)
                return cover == BoxCover.Part;
            if (OppositeOf(number) is List<Changed> opposite)
                foreach (Changed other in opposite)
                    if (reach.Cover(other.Surface, box) == BoxCover.Part)
                        return true;
            return Index == null || Index.HasOtherSurfaceIn(x, y, z);
        }

        Changed At(int number) => number < removed.Count ? removed[number]
            : number < removed.Count + added.Count ? added[number - removed.Count] : remasked[number - removed.Count - added.Count];

        /// <summary>The spheres that only the other carving has; null for one that stands in both.</summary>
        List<Changed> OppositeOf(int number) => number < removed.Count ? added : number < removed.Count + added.Count ? removed : null;

        /// <summary>Takes the spheres that stand in both carvings in the same place out of both lists.</summary>
        void TakeRemasked()
        {
            if (difference.Count > Few)
                return;
            for (int r = difference.Removed.Count - 1; r >= 0; r--)
            {
                ClipSphere before = difference.Removed[r];
                int a = difference.Added.FindIndex(sphere =>
                    sphere.CentreLps.Equals(before.CentreLps) && sphere.RadiusMm.Equals(before.RadiusMm) && sphere.Mask.SegmentCount == before.Mask.SegmentCount);
                if (a < 0)
                    continue;
                Ready(before, before.Mask.DifferenceFrom(difference.Added[a].Mask), remasked);
                difference.Removed.RemoveAt(r);
                difference.Added.RemoveAt(a);
            }
        }

        void Ready(List<ClipSphere> spheres, List<Changed> changed)
        {
            changed.Clear();
            foreach (ClipSphere sphere in spheres)
                Ready(sphere, sphere.Mask, changed);
        }

        void Ready(ClipSphere sphere, SegmentMask mask, List<Changed> changed)
        {
            SphereF place = grid.ToCentred(sphere);
            if (reach.TrySurfaceBox(place, out VoxelBox box))
                changed.Add(new Changed(mask, reach.Of(place, cut), reach.SurfaceOf(place), box));
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
