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
    /// foreach (int brick in dirty.Indices) ...                                         // and what of each, in the same order: dirty.Parts
    /// </code>
    /// </summary>
    public sealed class DirtyBrickSet
    {
        const int Size = BrickGrid.BrickSize;

        readonly ChangedSpheres changed;
        readonly DirtyCandidates candidates;
        readonly DirtyParts dirtyParts;
        readonly BrickSet dirty;
        readonly List<BrickPart> parts = new List<BrickPart>();

        /// <summary>Makes a set without bricks.</summary>
        /// <param name="bricks">The volume's bricks.</param>
        /// <param name="grid">The same volume's grid.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        public DirtyBrickSet(BrickGrid bricks, CentredGrid grid)
        {
            Bricks = bricks ?? throw new ArgumentNullException(nameof(bricks));
            changed = new ChangedSpheres(bricks, grid ?? throw new ArgumentNullException(nameof(grid)));
            candidates = new DirtyCandidates(bricks, changed);
            dirtyParts = new DirtyParts(bricks, changed, candidates.Touched);
            dirty = new BrickSet(bricks.Count);
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
                candidates.Forget();
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
                candidates.Forget();
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
            candidates.Take(before, after, cut, haloVoxels, false);
            TakeParts(haloVoxels, false);
        }

        /// <summary>
        /// Takes the bricks whose normals can differ: those of <see cref="Compute"/> with the halo of the normals, and those in which a sphere that only one of
        /// the two has could lend voxels its own normal, or take away the surface of another.
        /// </summary>
        /// <inheritdoc cref="Compute"/>
        public void ComputeNormals(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, CutMode cut)
        {
            candidates.Take(before, after, cut, CarvingReach.NormalsVoxels, true);
            TakeParts(CarvingReach.NormalsVoxels, true);
        }

        /// <summary>Finds what of the candidates is dirty, and drops those of which nothing is.</summary>
        void TakeParts(int haloVoxels, bool withSurfaces)
        {
            dirty.Clear();
            parts.Clear();
            for (int n = 0; n < candidates.Indices.Count; n++)
            {
                int brick = candidates.Indices[n];
                BrickPart part = dirtyParts.Of(brick, haloVoxels, withSurfaces);
                if (part.IsNone)
                    continue;
                dirty.Add(brick);
                parts.Add(part);
            }
        }
    }
}
