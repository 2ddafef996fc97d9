using System;
using System.Collections.Generic;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// A carving's spheres by place: which of them meet a brick is found without asking all of them, so that an edit costs the same in a stack of thousands
    /// as in a stack of one. Each sphere keeps a slot, a small number under which the kernels know it, for as long as the carving has it. What cannot clip
    /// anything (radius 0, empty mask) has none; equal spheres share one. Not thread safe.
    /// </summary>
    public sealed class SphereIndex
    {
        /// <summary>Bricks along the edge of a cell, the unit in which places are looked up.</summary>
        const int CellBricks = 4;

        readonly BrickGrid bricks;
        readonly CentredGrid grid;
        readonly SphereReach reach;
        readonly int cellsX, cellsY;
        readonly List<int>[] cells;
        readonly Dictionary<ClipSphere, int> slotOf = new Dictionary<ClipSphere, int>();
        Slot[] slots = new Slot[16];
        int slotCount;
        readonly Stack<int> free = new Stack<int>();
        readonly List<int> changed = new List<int>();
        readonly List<bool> isChanged = new List<bool>();
        readonly SphereDifference difference = new SphereDifference();
        IReadOnlyList<ClipSphere> present = Array.Empty<ClipSphere>();

        /// <summary>An index without spheres.</summary>
        /// <param name="bricks">The volume's bricks.</param>
        /// <param name="grid">The same volume's grid.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        public SphereIndex(BrickGrid bricks, CentredGrid grid)
        {
            this.bricks = bricks ?? throw new ArgumentNullException(nameof(bricks));
            this.grid = grid ?? throw new ArgumentNullException(nameof(grid));
            reach = new SphereReach(grid);
            cellsX = (bricks.BricksX + CellBricks - 1) / CellBricks;
            cellsY = (bricks.BricksY + CellBricks - 1) / CellBricks;
            cells = new List<int>[cellsX * cellsY * ((bricks.BricksZ + CellBricks - 1) / CellBricks)];
        }

        /// <summary>The number of different spheres that can clip.</summary>
        public int Count => slotOf.Count;

        /// <summary>One more than the largest slot that was ever in use.</summary>
        public int SlotCount => slotCount;

        /// <summary>The slots that the last <see cref="Update"/> filled.</summary>
        public IReadOnlyList<int> ChangedSlots => changed;

        /// <summary>How many spheres were tested against a brick so far, for those who count work.</summary>
        public long Tests { get; private set; }

        /// <summary>How many spheres were given to bricks so far.</summary>
        public long Gathered { get; private set; }

        /// <summary>The sphere of a slot in the kernels' space.</summary>
        public SphereF PlaceOf(int slot) => slots[slot].Place;

        /// <summary>The mask of a slot's sphere.</summary>
        public SegmentMask MaskOf(int slot) => slots[slot].Mask;

        /// <summary>Makes the index that of another carving; only spheres that differ cost anything.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="spheres"/> is null.</exception>
        public void Update(IReadOnlyList<ClipSphere> spheres)
        {
            if (spheres == null)
                throw new ArgumentNullException(nameof(spheres));
            foreach (int slot in changed)
                isChanged[slot] = false;
            changed.Clear();
            difference.Between(present, spheres);
            foreach (ClipSphere sphere in difference.Removed)
                Remove(sphere);
            foreach (ClipSphere sphere in difference.Added)
                Add(sphere);
            present = spheres as CarvingSnapshot ?? (IReadOnlyList<ClipSphere>)new List<ClipSphere>(spheres);
        }

        /// <summary>
        /// Lists the spheres that meet a brick and clip a segment in it, and perhaps a few that do not; where one of them clips all of the brick, only that one.
        /// </summary>
        /// <param name="brickX">The brick's place along i, in bricks; likewise <paramref name="brickY"/> and <paramref name="brickZ"/>.</param>
        /// <param name="brickY">Along j.</param>
        /// <param name="brickZ">Along k.</param>
        /// <param name="cut">The cut mode.</param>
        /// <param name="segments">The segments that matter in the brick.</param>
        /// <param name="found">Takes the slots, behind what it holds.</param>
        /// <exception cref="ArgumentNullException"><paramref name="found"/> is null.</exception>
        public void Gather(int brickX, int brickY, int brickZ, CutMode cut, ReadOnlySpan<ushort> segments, List<int> found)
        {
            if (found == null)
                throw new ArgumentNullException(nameof(found));
            List<int> cell = cells[CellOf(brickX, brickY, brickZ)];
            if (cell == null || segments.Length == 0)
                return;
            int first = found.Count;
            VoxelBox box = bricks.VoxelsOf(brickX, brickY, brickZ);
            foreach (int slot in cell)
            {
                ref readonly Slot sphere = ref slots[slot];
                if (!sphere.Mask.HoldsAny(segments))
                    continue;
                Tests++;
                BoxCover cover = reach.Cover(sphere.ReadyFor(cut), box);
                if (cover == BoxCover.None)
                    continue;
                if (cover == BoxCover.Whole && sphere.Mask.HoldsAll(segments))
                {
                    found.RemoveRange(first, found.Count - first);
                    found.Add(slot);
                    break;
                }
                found.Add(slot);
            }
            Gathered += found.Count - first;
        }

        /// <summary>
        /// Lists the spheres whose surface, or whose inside, comes so near to a brick that its voxels' normals may depend on it, and that clip a segment in it.
        /// </summary>
        /// <inheritdoc cref="Gather"/>
        public void GatherSurfaces(int brickX, int brickY, int brickZ, ReadOnlySpan<ushort> segments, List<int> found)
        {
            if (found == null)
                throw new ArgumentNullException(nameof(found));
            List<int> cell = cells[CellOf(brickX, brickY, brickZ)];
            if (cell == null || segments.Length == 0)
                return;
            VoxelBox box = bricks.VoxelsOf(brickX, brickY, brickZ);
            int first = found.Count;
            bool isNearSurface = false;
            foreach (int slot in cell)
            {
                if (!slots[slot].Mask.HoldsAny(segments))
                    continue;
                Tests++;
                BoxCover cover = reach.Cover(slots[slot].Surface, box);
                isNearSurface |= cover == BoxCover.Part;
                if (cover != BoxCover.None)
                    found.Add(slot);
            }
            if (!isNearSurface)
                found.RemoveRange(first, found.Count - first);
            Gathered += found.Count - first;
        }

        /// <summary>Whether a sphere that the last <see cref="Update"/> did not add has its surface near a brick.</summary>
        internal bool HasOtherSurfaceIn(int brickX, int brickY, int brickZ)
        {
            List<int> cell = cells[CellOf(brickX, brickY, brickZ)];
            if (cell == null)
                return false;
            VoxelBox box = bricks.VoxelsOf(brickX, brickY, brickZ);
            foreach (int slot in cell)
            {
                Tests++;
                if (!isChanged[slot] && reach.Cover(slots[slot].Surface, box) == BoxCover.Part)
                    return true;
            }
            return false;
        }

        /// <summary>Whether a sphere that the last <see cref="Update"/> did not add clips all that a mask clips of the segments in a box within a brick.</summary>
        internal bool IsHiddenByOthers(int brickX, int brickY, int brickZ, in VoxelBox box, CutMode cut, SegmentMask mask, ReadOnlySpan<ushort> segments)
        {
            List<int> cell = cells[CellOf(brickX, brickY, brickZ)];
            if (cell == null)
                return false;
            foreach (int slot in cell)
            {
                if (isChanged[slot] || !mask.IsWithin(slots[slot].Mask, segments))
                    continue;
                Tests++;
                if (reach.Cover(slots[slot].ReadyFor(cut), box) == BoxCover.Whole)
                    return true;
            }
            return false;
        }

        void Add(ClipSphere sphere)
        {
            if (slotOf.ContainsKey(sphere))
                return;
            int slot = free.Count > 0 ? free.Pop() : slotCount;
            SphereF place = grid.ToCentred(sphere);
            var filled = new Slot(place, sphere.Mask, reach.Of(place, CutMode.Binary), reach.Of(place, CutMode.Smooth), reach.SurfaceOf(place));
            if (slot == slotCount)
            {
                slotCount++;
                isChanged.Add(false);
                if (slot == slots.Length)
                    Array.Resize(ref slots, 2 * slots.Length);
            }
            slots[slot] = filled;
            slotOf.Add(sphere, slot);
            changed.Add(slot);
            isChanged[slot] = true;
            ForCells(filled, (list, index) => list.Add(index), slot);
        }

        void Remove(ClipSphere sphere)
        {
            if (!slotOf.TryGetValue(sphere, out int slot))
                return;
            ForCells(slots[slot], (list, index) =>
            {
                int at = list.IndexOf(index);
                list[at] = list[list.Count - 1];
                list.RemoveAt(list.Count - 1);
            }, slot);
            slotOf.Remove(sphere);
            free.Push(slot);
        }

        void ForCells(in Slot sphere, Action<List<int>, int> act, int slot)
        {
            if (!reach.TrySurfaceBox(sphere.Place, out VoxelBox box))
                return;
            const int voxels = CellBricks * BrickGrid.BrickSize;
            for (int z = box.MinK / voxels; z <= box.MaxK / voxels; z++)
                for (int y = box.MinJ / voxels; y <= box.MaxJ / voxels; y++)
                    for (int x = box.MinI / voxels; x <= box.MaxI / voxels; x++)
                    {
                        var cell = new VoxelBox
                        {
                            MinI = x * voxels, MinJ = y * voxels, MinK = z * voxels,
                            MaxI = (x + 1) * voxels - 1, MaxJ = (y + 1) * voxels - 1, MaxK = (z + 1) * voxels - 1,
                        };
                        if (reach.Cover(sphere.Surface, cell) != BoxCover.None)
                            act(cells[x + cellsX * (y + cellsY * z)] ??= new List<int>(), slot);
                    }
        }

        int CellOf(int brickX, int brickY, int brickZ) => brickX / CellBricks + cellsX * (brickY / CellBricks + cellsY * (brickZ / CellBricks));

        readonly struct Slot
        {
            readonly SphereReach.Ready binary, smooth;

            public Slot(in SphereF place, SegmentMask mask, in SphereReach.Ready binary, in SphereReach.Ready smooth, in SphereReach.Ready surface)
            {
                Place = place;
                Mask = mask;
                this.binary = binary;
                this.smooth = smooth;
                Surface = surface;
            }

            public SphereF Place { get; }

            public SegmentMask Mask { get; }

            public SphereReach.Ready Surface { get; }

            public SphereReach.Ready ReadyFor(CutMode cut) => cut == CutMode.Smooth ? smooth : binary;
        }
    }
}
