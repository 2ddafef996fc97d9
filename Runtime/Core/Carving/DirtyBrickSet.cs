using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// The bricks of a volume whose result can differ after an edit. An edit goes in (two carvings), bricks come out: never too few; how much
    /// too many is what later work makes smaller. Owned by one caller, who computes again and again: after the first use, work and memory
    /// follow the bricks that are dirty and not the volume. Not thread safe.
    /// <code>
    /// var dirty = new DirtyBrickSet(bricks, grid);                                     // once
    /// dirty.Compute(before, after, cut, CarvingReach.AntiAliasVoxels);                 // per edit and stage
    /// dirty.PackInto(words);                                                           // words.Length >= dirty.Count
    /// </code>
    /// </summary>
    public sealed class DirtyBrickSet
    {
        readonly CentredGrid grid;
        readonly bool[] isDirty;
        readonly List<int> indices = new List<int>();

        /// <summary>Makes a set without bricks.</summary>
        /// <param name="bricks">The volume's bricks.</param>
        /// <param name="grid">The same volume's grid.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        public DirtyBrickSet(BrickGrid bricks, CentredGrid grid)
        {
            Bricks = bricks ?? throw new ArgumentNullException(nameof(bricks));
            this.grid = grid ?? throw new ArgumentNullException(nameof(grid));
            isDirty = new bool[bricks.Count];
        }

        /// <summary>The volume's bricks.</summary>
        public BrickGrid Bricks { get; }

        /// <summary>The numbers of the dirty bricks, ascending; another list after the next <see cref="Compute"/>.</summary>
        public IReadOnlyList<int> Indices => indices;

        /// <summary>The number of dirty bricks.</summary>
        public int Count => indices.Count;

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
                if (brickIndex < 0 || brickIndex >= isDirty.Length)
                    throw new ArgumentOutOfRangeException(nameof(brickIndex), brickIndex,
                        FormattableString.Invariant($"The bricks are 0 to {isDirty.Length - 1}."));
                return isDirty[brickIndex];
            }
        }

        /// <summary>
        /// Takes the bricks whose result can differ between two carvings of the volume, and no others: those that hold a voxel of the box around a
        /// sphere which only one of the two has, widened by a halo. Spheres that both have, in whatever order, make nothing dirty.
        /// </summary>
        /// <param name="before">The carving that the results in store were made with.</param>
        /// <param name="after">The carving that is wanted.</param>
        /// <param name="cut">The cut mode of both.</param>
        /// <param name="haloVoxels">
        /// 0 for the opacity itself, <see cref="CarvingReach.AntiAliasVoxels"/> for the anti-aliased opacity, <see cref="CarvingReach.NormalsVoxels"/>
        /// for the normals.
        /// </param>
        /// <exception cref="ArgumentNullException">A carving is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The halo is negative.</exception>
        public void Compute(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, CutMode cut, int haloVoxels)
        {
            if (haloVoxels < 0)
                throw new ArgumentOutOfRangeException(nameof(haloVoxels), haloVoxels, "A halo is 0 voxels or more.");
            IReadOnlyList<ClipSphere> different = SphereDifference.Between(before, after);
            Clear();
            foreach (ClipSphere sphere in different)
            {
                if (sphere.CanClip && CarvingReach.TryVoxelBox(grid, grid.ToCentred(sphere), cut, haloVoxels, out VoxelBox box))
                    Mark(box);
            }
            if (different.Count > 1)
                indices.Sort();
        }

        /// <summary>Writes the dirty bricks as the kernels take them, in the order of their numbers: <see cref="BrickGrid.Pack"/>.</summary>
        /// <param name="destination">Takes <see cref="Count"/> words from its beginning.</param>
        /// <exception cref="ArgumentNullException"><paramref name="destination"/> is null.</exception>
        /// <exception cref="ArgumentException">The bricks do not fit.</exception>
        public void PackInto(uint[] destination)
        {
            if (destination == null)
                throw new ArgumentNullException(nameof(destination));
            if (destination.Length < Count)
                throw new ArgumentException(FormattableString.Invariant($"{Count} bricks do not fit into {destination.Length}."), nameof(destination));
            for (int n = 0; n < indices.Count; n++)
            {
                Bricks.BrickAt(indices[n], out int x, out int y, out int z);
                destination[n] = BrickGrid.Pack(x, y, z);
            }
        }

        void Clear()
        {
            foreach (int index in indices)
                isDirty[index] = false;
            indices.Clear();
        }

        void Mark(in VoxelBox box)
        {
            for (int z = box.MinK / BrickGrid.BrickSize; z <= box.MaxK / BrickGrid.BrickSize; z++)
                for (int y = box.MinJ / BrickGrid.BrickSize; y <= box.MaxJ / BrickGrid.BrickSize; y++)
                    for (int x = box.MinI / BrickGrid.BrickSize; x <= box.MaxI / BrickGrid.BrickSize; x++)
                    {
                        int index = Bricks.IndexOf(x, y, z);
                        if (!isDirty[index])
                        {
                            isDirty[index] = true;
                            indices.Add(index);
                        }
                    }
        }
    }
}
