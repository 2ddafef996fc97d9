using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>The bricks that may be dirty after an edit: the part of <see cref="DirtyBrickSet"/> that goes through bricks, before each is looked into.</summary>
    sealed class DirtyCandidates
    {
        const int Size = BrickGrid.BrickSize;

        readonly BrickGrid bricks;
        readonly ChangedSpheres changed;
        readonly BrickSet candidates;
        readonly Func<int, int, int, int, bool> matters, lendsNormals; // a sphere's number and a brick
        IReadOnlyList<ClipSphere> lastBefore, lastAfter;
        CutMode lastCut;

        /// <param name="bricks">The volume's bricks.</param>
        /// <param name="changed">Takes the spheres in which two carvings differ.</param>
        public DirtyCandidates(BrickGrid bricks, ChangedSpheres changed)
        {
            this.bricks = bricks;
            this.changed = changed;
            Touched = new BrickSet(bricks.Count);
            candidates = new BrickSet(bricks.Count);
            matters = (number, x, y, z) => changed.Matters(number, x, y, z, bricks.VoxelsOf(x, y, z));
            lendsNormals = changed.LendsNormals;
        }

        /// <summary>The bricks in which opacities before anti-aliasing can differ.</summary>
        public BrickSet Touched { get; }

        /// <summary>The candidates' numbers, ascending.</summary>
        public IReadOnlyList<int> Indices => candidates.Indices;

        /// <summary>Forgets what was found for the last two carvings: something else that it follows from has changed.</summary>
        public void Forget() => lastBefore = null;

        /// <summary>Takes the candidates between two carvings, as <see cref="DirtyBrickSet"/> is asked for them.</summary>
        /// <param name="withSurfaces">Whether to add those in which a sphere could lend voxels its normal, or take it away.</param>
        public void Take(IReadOnlyList<ClipSphere> before, IReadOnlyList<ClipSphere> after, CutMode cut, int haloVoxels, bool withSurfaces)
        {
            bool isSame = before is CarvingSnapshot && after is CarvingSnapshot
                && ReferenceEquals(before, lastBefore) && ReferenceEquals(after, lastAfter) && cut == lastCut;
            if (!isSame)
            {
                changed.Take(before, after, cut);
                Touched.Clear();
                AddWhere(Touched, matters);
            }
            lastBefore = before;
            lastAfter = after;
            lastCut = cut;
            candidates.CopyFrom(Touched);
            if (haloVoxels > 0)
                Widen(haloVoxels);
            if (withSurfaces)
                AddWhere(candidates, lendsNormals);
            candidates.Sort();
        }

        /// <summary>Adds the bricks in a sphere's box for which something holds.</summary>
        void AddWhere(BrickSet to, Func<int, int, int, int, bool> holds)
        {
            for (int n = 0; n < changed.Count; n++)
            {
                VoxelBox box = changed[n].Box;
                for (int z = box.MinK / Size; z <= box.MaxK / Size; z++)
                    for (int y = box.MinJ / Size; y <= box.MaxJ / Size; y++)
                        for (int x = box.MinI / Size; x <= box.MaxI / Size; x++)
                        {
                            int brick = bricks.IndexOf(x, y, z);
                            if (!to[brick] && holds(n, x, y, z))
                                to.Add(brick);
                        }
            }
        }

        /// <summary>The bricks around a touched one are dirty where they are within the halo of a voxel that can differ.</summary>
        void Widen(int haloVoxels)
        {
            for (int n = 0; n < Touched.Indices.Count; n++)
            {
                bricks.BrickAt(Touched.Indices[n], out int x, out int y, out int z);
                for (int dz = -1; dz <= 1; dz++)
                    for (int dy = -1; dy <= 1; dy++)
                        for (int dx = -1; dx <= 1; dx++)
                        {
                            if (!bricks.Contains(x + dx, y + dy, z + dz))
                                continue;
                            int beside = bricks.IndexOf(x + dx, y + dy, z + dz);
                            if (!candidates[beside] && (!changed.AreFew || changed.AnyMatters(x, y, z, Side(x, y, z, dx, dy, dz, haloVoxels))))
                                candidates.Add(beside);
                        }
            }
        }

        /// <summary>The voxels of a brick that lie within a halo of its neighbour in a direction.</summary>
        VoxelBox Side(int x, int y, int z, int dx, int dy, int dz, int haloVoxels)
        {
            VoxelBox box = bricks.VoxelsOf(x, y, z);
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
    }
}
