using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// The bricks of a volume whose result can differ after an edit. An edit goes in (two carvings), bricks come out: never too few; how much
    /// too many is what later work makes smaller. Bricks come in the order of their numbers. Immutable.
    /// </summary>
    public sealed class DirtyBricks
    {
        readonly bool[] dirty;

        DirtyBricks(BrickGrid bricks, bool[] dirty, int count)
        {
            Bricks = bricks;
            this.dirty = dirty;
            Count = count;
        }

        /// <summary>The volume's bricks.</summary>
        public BrickGrid Bricks { get; }

        /// <summary>The number of dirty bricks.</summary>
        public int Count { get; }

        /// <summary>Whether every brick is dirty.</summary>
        public bool IsAll => Count == Bricks.Count;

        /// <summary>Whether no brick is dirty.</summary>
        public bool IsNone => Count == 0;

        /// <summary>Whether the brick of this number is dirty.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such brick.</exception>
        public bool this[int brickIndex]
        {
            get
            {
                if (brickIndex < 0 || brickIndex >= dirty.Length)
                    throw new ArgumentOutOfRangeException(nameof(brickIndex), brickIndex,
                        FormattableString.Invariant($"The bricks are 0 to {dirty.Length - 1}."));
                return dirty[brickIndex];
            }
        }

        /// <summary>Every brick: what a new volume, transfer function or quality makes dirty.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="bricks"/> is null.</exception>
        public static DirtyBricks All(BrickGrid bricks)
        {
            var all = new bool[(bricks ?? throw new ArgumentNullException(nameof(bricks))).Count];
            for (int b = 0; b < all.Length; b++)
                all[b] = true;
            return new DirtyBricks(bricks, all, all.Length);
        }

        /// <summary>No brick.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="bricks"/> is null.</exception>
        public static DirtyBricks None(BrickGrid bricks) =>
            new DirtyBricks(bricks ?? throw new ArgumentNullException(nameof(bricks)), new bool[bricks.Count], 0);

        /// <summary>What a change of a carving makes dirty: <see cref="Between"/> its two states.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="bricks"/>, <paramref name="grid"/> or a state of the change is null.</exception>
        public static DirtyBricks Of(CarvingChange change, BrickGrid bricks, CentredGrid grid, CutMode cut, int haloVoxels) =>
            Between(change.BeforeState, change.AfterState, bricks, grid, cut, haloVoxels);

        /// <summary>
        /// The bricks whose result can differ between two carvings of the same volume: those that hold a voxel of the box around a sphere which only
        /// one of the two has, widened by a halo. Spheres that both have, in whatever order, make nothing dirty.
        /// </summary>
        /// <param name="before">The carving that the results in store were made with.</param>
        /// <param name="after">The carving that is wanted.</param>
        /// <param name="bricks">The volume's bricks.</param>
        /// <param name="grid">The volume's grid.</param>
        /// <param name="cut">The cut mode of both.</param>
        /// <param name="haloVoxels">
        /// 0 for the opacity itself, <see cref="CarvingReach.AntiAliasVoxels"/> for the anti-aliased opacity, <see cref="CarvingReach.NormalsVoxels"/>
        /// for the normals.
        /// </param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The halo is negative.</exception>
        public static DirtyBricks Between(
            IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, BrickGrid bricks, CentredGrid grid, CutMode cut, int haloVoxels)
        {
            if (bricks == null)
                throw new ArgumentNullException(nameof(bricks));
            if (haloVoxels < 0)
                throw new ArgumentOutOfRangeException(nameof(haloVoxels), haloVoxels, "A halo is 0 voxels or more.");
            var dirty = new bool[bricks.Count];
            int count = 0;
            foreach (ClipSphere sphere in SphereDifference.Between(before, after))
            {
                if (sphere.CanClip && CarvingReach.TryVoxelBox(grid, grid.ToCentred(sphere), cut, haloVoxels, out VoxelBox box))
                    count += Mark(dirty, bricks, box);
            }
            return new DirtyBricks(bricks, dirty, count);
        }

        /// <summary>The bricks that are dirty in either.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="other"/> is null.</exception>
        /// <exception cref="ArgumentException">The other set is of a volume of another size.</exception>
        public DirtyBricks Union(DirtyBricks other)
        {
            if (other == null)
                throw new ArgumentNullException(nameof(other));
            if (other.Bricks.BricksX != Bricks.BricksX || other.Bricks.BricksY != Bricks.BricksY || other.Bricks.BricksZ != Bricks.BricksZ)
                throw new ArgumentException("The two sets are of volumes of different sizes.", nameof(other));
            if (IsAll || other.IsNone)
                return this;
            var either = new bool[dirty.Length];
            int count = 0;
            for (int b = 0; b < either.Length; b++)
            {
                either[b] = dirty[b] || other.dirty[b];
                count += either[b] ? 1 : 0;
            }
            return new DirtyBricks(Bricks, either, count);
        }

        /// <summary>The dirty bricks as the kernels take them, in the order of their numbers: <see cref="BrickGrid.Pack"/>.</summary>
        /// <param name="destination">Takes <see cref="Count"/> words from its beginning.</param>
        /// <exception cref="ArgumentNullException"><paramref name="destination"/> is null.</exception>
        /// <exception cref="ArgumentException">The bricks do not fit.</exception>
        public void PackInto(uint[] destination)
        {
            if (destination == null)
                throw new ArgumentNullException(nameof(destination));
            if (destination.Length < Count)
                throw new ArgumentException(FormattableString.Invariant($"{Count} bricks do not fit into {destination.Length}."), nameof(destination));
            int next = 0;
            int index = 0;
            for (int z = 0; z < Bricks.BricksZ; z++)
                for (int y = 0; y < Bricks.BricksY; y++)
                    for (int x = 0; x < Bricks.BricksX; x++)
                    {
                        if (dirty[index++])
                            destination[next++] = BrickGrid.Pack(x, y, z);
                    }
        }

        /// <summary>The dirty bricks, packed, as a new array.</summary>
        public uint[] Pack()
        {
            var packed = new uint[Count];
            PackInto(packed);
            return packed;
        }

        static int Mark(bool[] dirty, BrickGrid bricks, in VoxelBox box)
        {
            int added = 0;
            for (int z = box.MinK / BrickGrid.BrickSize; z <= box.MaxK / BrickGrid.BrickSize; z++)
                for (int y = box.MinJ / BrickGrid.BrickSize; y <= box.MaxJ / BrickGrid.BrickSize; y++)
                    for (int x = box.MinI / BrickGrid.BrickSize; x <= box.MaxI / BrickGrid.BrickSize; x++)
                    {
                        int index = bricks.IndexOf(x, y, z);
                        if (!dirty[index])
                        {
                            dirty[index] = true;
                            added++;
                        }
                    }
            return added;
        }
    }
}
