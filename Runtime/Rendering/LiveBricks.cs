using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;

namespace AnatomyCarve
{
    /// <summary>The bricks that kernels work on when a whole volume is computed: those in which, or beside which, anything is visible before carving.</summary>
    sealed class LiveBricks
    {
        readonly BrickGrid bricks;
        readonly bool[] isNear, wasNear;
        readonly List<int> visible = new List<int>(), nearMatter = new List<int>(), emptied = new List<int>();
        VisibleContents contents;

        public LiveBricks(BrickGrid bricks)
        {
            this.bricks = bricks;
            isNear = new bool[bricks.Count];
            wasNear = new bool[bricks.Count];
        }

        /// <summary>Bricks with a visible segment: where opacity can be above 0.</summary>
        public IReadOnlyList<int> Visible => visible;

        /// <summary>Those and all around them: where anti-aliased opacity and normals can be.</summary>
        public IReadOnlyList<int> NearMatter => nearMatter;

        /// <summary>The box around these; one brick where there are none.</summary>
        public VoxelBox Box { get; private set; }

        /// <summary>Takes over what is visible now.</summary>
        public void Take(VisibleContents now)
        {
            contents = now;
            visible.Clear();
            nearMatter.Clear();
            Array.Copy(isNear, wasNear, isNear.Length);
            for (int brick = 0; brick < isNear.Length; brick++)
            {
                isNear[brick] = now.IsNearMatter(brick);
                if (isNear[brick])
                    nearMatter.Add(brick);
                if (now[brick].Length > 0)
                    visible.Add(brick);
            }
            Box = BoxAround(nearMatter);
        }

        /// <summary>
        /// The bricks that are to be emptied: those near which anything was visible, in which nothing is. They include those beside visible ones, whose opacity nobody
        /// else writes.
        /// </summary>
        /// <param name="all">Whether nothing has been computed or emptied yet.</param>
        public IReadOnlyList<int> Emptied(bool all)
        {
            emptied.Clear();
            for (int brick = 0; brick < wasNear.Length; brick++)
                if (contents[brick].Length == 0 && (all || wasNear[brick]))
                    emptied.Add(brick);
            return emptied;
        }

        VoxelBox BoxAround(List<int> list)
        {
            int minX = 0, minY = 0, minZ = 0, maxX = 0, maxY = 0, maxZ = 0;
            for (int n = 0; n < list.Count; n++)
            {
                bricks.BrickAt(list[n], out int x, out int y, out int z);
                (minX, maxX) = n == 0 ? (x, x) : (Math.Min(minX, x), Math.Max(maxX, x));
                (minY, maxY) = n == 0 ? (y, y) : (Math.Min(minY, y), Math.Max(maxY, y));
                (minZ, maxZ) = n == 0 ? (z, z) : (Math.Min(minZ, z), Math.Max(maxZ, z));
            }
            VoxelBox low = bricks.VoxelsOf(minX, minY, minZ), high = bricks.VoxelsOf(maxX, maxY, maxZ);
            return new VoxelBox { MinI = low.MinI, MinJ = low.MinJ, MinK = low.MinK, MaxI = high.MaxI, MaxJ = high.MaxJ, MaxK = high.MaxK };
        }
    }
}
