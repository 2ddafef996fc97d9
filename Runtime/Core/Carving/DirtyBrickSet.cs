using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// The bricks of a volume whose result can differ after an edit. An edit goes in (two carvings), bricks come out, never too few: those in which the
    /// coverage of a visible voxel can change. Owned by one caller, who computes again and again: after the first use, work and memory follow the bricks
    /// that are dirty and not the volume. Not thread safe.
    /// <code>
    /// var dirty = new DirtyBrickSet(bricks, grid);                                     // once
    /// dirty.Compute(before, after, cut, CarvingReach.AntiAliasVoxels);                 // per edit and stage
    /// dirty.PackInto(words);                                                           // words.Length >= dirty.Count
    /// </code>
    /// </summary>
    public sealed class DirtyBrickSet
    {
        const int Size = BrickGrid.BrickSize;

        readonly ChangedSpheres changed;
        readonly BrickSet touched, dirty; // touched: without a halo
        readonly DirtyParts dirtyParts;
        readonly List<BrickPart> parts = new List<BrickPart>();
        IReadOnlyList<ClipSphere> lastBefore, lastAfter;
        CutMode lastCut;

        /// <summary>Makes a set without bricks.</summary>
        /// <param name="bricks">The volume's bricks.</param>
        /// <param name="grid">The same volume's grid.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        public DirtyBrickSet(BrickGrid bricks, CentredGrid grid)
        {
            Bricks = bricks ?? throw new ArgumentNullException(nameof(bricks));
            changed = new ChangedSpheres(bricks, grid ?? throw new ArgumentNullException(nameof(grid)));
            touched = new BrickSet(bricks.Count);
            dirty = new BrickSet(bricks.Count);
            dirtyParts = new DirtyParts(bricks, changed, touched);
        }

        /// <summary>The volume's bricks.</summary>
        public BrickGrid Bricks { get; }

        /// <summary>The numbers of the dirty bricks, ascending; another list after the next <see cref="Compute"/>.</summary>
        public IReadOnlyList<int> Indices => dirty.Indices;

        /// <summary>What of each of these bricks is dirty, in the same order; another list after the next <see cref="Compute"/>.</summary>
        public IReadOnlyList<BrickPart> Parts => parts;

        /// <summary>The number of dirty bricks.</summary>
        public int Count => dirty.Indices.Count;

        /// <summary>Whether every brick is dirty.</summary>
        public bool IsAll => Count == Bricks.Count;

        /// <summary>Whether no brick is dirty.</summary>
        public bool IsNone => Count == 0;

        /// <summary>What is visible before carving: bricks in which no sphere's mask holds a visible segment stay clean. Null = anything may be visible.</summary>
        /// <exception cref="ArgumentException">It is another volume's.</exception>
        public VisibleContents Contents
        {
            get => changed.Contents;
            set
            {
                if (value != null && value.Count != Bricks.Count)
                    throw new ArgumentException(FormattableString.Invariant($"There are contents of {value.Count} bricks for {Bricks.Count}."), nameof(value));
                changed.Contents = value;
                lastBefore = null;
            }
        }

        /// <summary>
        /// The later carving's spheres, updated to it from the earlier one: where one that both have hides all that an edit could change, nothing is dirty.
        /// Null = that is not looked for.
        /// </summary>
        public SphereIndex Index
        {
            get => changed.Index;
            set
            {
                changed.Index = value;
                lastBefore = null;
            }
        }

        /// <summary>Whether the brick of this number is dirty.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such brick.</exception>
        public bool this[int brickIndex]
        {
            get
            {
                if (brickIndex < 0 || brickIndex >= Bricks.Count)
                    throw new ArgumentOutOfRangeException(nameof(brickIndex), brickIndex,
                        FormattableString.Invariant($"The bricks are 0 to {Bricks.Count - 1}."));
                return dirty[brickIndex];
            }
        }

        /// <summary>
        /// Takes the bricks whose result can differ between two carvings of the volume: those with a voxel, or one within the halo of it, that a sphere which
        /// only one of the two has covers in part, or covers wholly while no sphere of the other does (with that voxel's visible segment in both masks).
        /// Spheres that both have, in whatever order, make nothing dirty.
        /// </summary>
        /// <param name="before">The carving that the results in store were made with.</param>
        /// <param name="after">The carving that is wanted.</param>
        /// <param name="cut">The cut mode of both.</param>
        /// <param name="haloVoxels">
        /// 0 for the opacity itself, <see cref="CarvingReach.AntiAliasVoxels"/> for the anti-aliased opacity, <see cref="CarvingReach.NormalsVoxels"/>
        /// for the normals: at most a brick's size.
        /// </param>
        /// <exception cref="ArgumentNullException">A carving is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The halo is negative, or wider than a brick.</exception>
        public void Compute(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, CutMode cut, int haloVoxels)
        {
            if (haloVoxels < 0 || haloVoxels > Size)
                throw new ArgumentOutOfRangeException(nameof(haloVoxels), haloVoxels, FormattableString.Invariant($"A halo is 0 to {Size} voxels."));
            Take(before, after, cut, haloVoxels);
            TakeParts(haloVoxels, false);
        }

        void Take(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, CutMode cut, int haloVoxels)
        {
            bool isSame = before is CarvingSnapshot && after is CarvingSnapshot
                && ReferenceEquals(before, lastBefore) && ReferenceEquals(after, lastAfter) && cut == lastCut;
            if (!isSame)
            {
                changed.Take(before, after, cut);
                Touch();
            }
            lastBefore = before;
            lastAfter = after;
            lastCut = cut;
            dirty.CopyFrom(touched);
            if (haloVoxels > 0)
                Widen(haloVoxels);
        }

        /// <summary>
        /// Takes the bricks whose normals can differ: those of <see cref="Compute"/> with the halo of the normals, and those in which a sphere that only one of
        /// the two has could lend voxels its own normal, or take away the surface of another.
        /// </summary>
        /// <inheritdoc cref="Compute"/>
        public void ComputeNormals(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, CutMode cut)
        {
            Take(before, after, cut, CarvingReach.NormalsVoxels);
            AddSurfaces();
            TakeParts(CarvingReach.NormalsVoxels, true);
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
            for (int n = 0; n < Count; n++)
            {
                Bricks.BrickAt(dirty.Indices[n], out int x, out int y, out int z);
                destination[n] = BrickGrid.Pack(x, y, z);
            }
        }

        /// <summary>Finds what of the bricks is dirty, and drops those of which nothing is.</summary>
        void TakeParts(int haloVoxels, bool withSurfaces)
        {
            dirty.Sort();
            parts.Clear();
            for (int n = 0; n < dirty.Indices.Count; n++)
                parts.Add(dirtyParts.Of(dirty.Indices[n], haloVoxels, withSurfaces));
            dirty.Keep(number => !parts[number].IsNone);
            parts.RemoveAll(part => part.IsNone);
        }

        void Touch()
        {
            touched.Clear();
            for (int n = 0; n < changed.Count; n++)
            {
                VoxelBox box = changed.BoxOf(n);
                for (int z = box.MinK / Size; z <= box.MaxK / Size; z++)
                    for (int y = box.MinJ / Size; y <= box.MaxJ / Size; y++)
                        for (int x = box.MinI / Size; x <= box.MaxI / Size; x++)
                        {
                            int brick = Bricks.IndexOf(x, y, z);
                            if (!touched[brick] && changed.Matters(n, x, y, z, Bricks.VoxelsOf(x, y, z)))
                                touched.Add(brick);
                        }
            }
        }

        /// <summary>The bricks around a touched one are dirty where they are within the halo of a voxel that can differ.</summary>
        void Widen(int haloVoxels)
        {
            for (int n = 0; n < touched.Indices.Count; n++)
            {
                Bricks.BrickAt(touched.Indices[n], out int x, out int y, out int z);
                for (int dz = -1; dz <= 1; dz++)
                    for (int dy = -1; dy <= 1; dy++)
                        for (int dx = -1; dx <= 1; dx++)
                        {
                            if (!Bricks.Contains(x + dx, y + dy, z + dz))
                                continue;
                            int beside = Bricks.IndexOf(x + dx, y + dy, z + dz);
                            if (!dirty[beside] && (!changed.AreFew || changed.AnyMatters(x, y, z, Side(x, y, z, dx, dy, dz, haloVoxels))))
                                dirty.Add(beside);
                        }
            }
        }

        /// <summary>The voxels of a brick that lie within a halo of its neighbour in a direction.</summary>
        VoxelBox Side(int x, int y, int z, int dx, int dy, int dz, int haloVoxels)
        {
            VoxelBox box = Bricks.VoxelsOf(x, y, z);
            Narrow(dx, haloVoxels, ref box.MinI, ref box.MaxI);
            Narrow(dy, haloVoxels, ref box.MinJ, ref box.MaxJ);
            Narrow(dz, haloVoxels, ref box.MinK, ref box.MaxK);
            return box;
        }

        static void Narrow(int direction, int haloVoxels, ref int min, ref int max)
        {
            if (direction < 0)
                max = Math.Min(max, min + haloVoxels - 1);
            else if (direction > 0)
                min = Math.Max(min, max - haloVoxels + 1);
        }

        void AddSurfaces()
        {
            for (int n = 0; n < changed.Count; n++)
            {
                VoxelBox box = changed.BoxOf(n);
                for (int z = box.MinK / Size; z <= box.MaxK / Size; z++)
                    for (int y = box.MinJ / Size; y <= box.MaxJ / Size; y++)
                        for (int x = box.MinI / Size; x <= box.MaxI / Size; x++)
                        {
                            int brick = Bricks.IndexOf(x, y, z);
                            if (!dirty[brick] && changed.LendsNormals(n, x, y, z))
                                dirty.Add(brick);
                        }
            }
        }
    }
}
