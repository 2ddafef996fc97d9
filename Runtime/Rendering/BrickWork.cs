using System;
using System.Collections.Generic;
using AnatomyCarve.Carving;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// A list of bricks on the GPU, each with the spheres that meet it: what a kernel of the volume is dispatched over. A long list is dispatched in batches,
    /// so that memory does not follow the volume or the carving.
    /// </summary>
    sealed class BrickWork : IDisposable
    {
        /// <summary>The most bricks, and about the most spheres of bricks, in a batch.</summary>
        public const int BricksPerBatch = 16384, SpheresPerBatch = 1 << 14;

        /// <summary>Spheres of bricks that there is room for at first.</summary>
        const int FirstSlots = 64;

        readonly BrickGrid grid;
        readonly uint[] packed; // pairs: brick, part
        readonly uint[] ranges; // pairs: first, count
        readonly List<int> spheres = new List<int>();
        int[] slots = new int[FirstSlots];

        public BrickWork(BrickGrid grid)
        {
            this.grid = grid;
            int capacity = Math.Min(grid.Count, BricksPerBatch);
            packed = new uint[2 * capacity];
            ranges = new uint[2 * capacity];
        }

        /// <summary>The bytes of all lists while bricks have no more spheres than there is room for at first.</summary>
        public static long FirstBytesOf(long bricks) => 4 * sizeof(uint) * Math.Min(bricks, BricksPerBatch) + sizeof(int) * FirstSlots;

        /// <summary>Packed bricks, each with the part that is to be worked on.</summary>
        public GraphicsBuffer Bricks { get; private set; }

        /// <summary>For each brick which part of <see cref="Slots"/> is its own.</summary>
        public GraphicsBuffer Ranges { get; private set; }

        public GraphicsBuffer Slots { get; private set; }

        /// <summary>The number of bricks in the batch.</summary>
        public int Count { get; private set; }

        /// <summary>The voxels of these bricks that are worked on.</summary>
        public long Voxels { get; private set; }

        /// <summary>The spheres of these bricks; a caller adds a brick's, then the brick.</summary>
        public List<int> Spheres => spheres;

        /// <summary>Whether the batch should go: the next brick may have some thousand spheres, and the list is not to outgrow its memory.</summary>
        public bool IsFull => 2 * Count == packed.Length || spheres.Count >= SpheresPerBatch * 3 / 4;

        /// <summary>Whether the lists would be there for a dispatch; a lost device takes them away.</summary>
        public bool IsValid => IsThere(Bricks) && IsThere(Ranges) && IsThere(Slots);

        public long Bytes => BytesOf(Bricks) + BytesOf(Ranges) + BytesOf(Slots);

        public void Clear()
        {
            Count = 0;
            Voxels = 0;
            spheres.Clear();
        }

        /// <summary>Adds a brick, whose spheres are those that were added since the brick before.</summary>
        public void Add(int brick, BrickPart part)
        {
            grid.BrickAt(brick, out int x, out int y, out int z);
            packed[2 * Count] = BrickGrid.Pack(x, y, z);
            packed[2 * Count + 1] = part.Packed;
            uint first = Count == 0 ? 0 : ranges[2 * Count - 2] + ranges[2 * Count - 1];
            ranges[2 * Count] = first;
            ranges[2 * Count + 1] = (uint)spheres.Count - first;
            Voxels += part.VoxelsIn(grid.VoxelsOf(x, y, z));
            Count++;
        }

        /// <exception cref="Volumes.AnatomyCarveException">The device could not make the lists.</exception>
        public void Upload(bool withSpheres)
        {
            Reserve();
            Bricks.SetData(packed, 0, 0, 2 * Count);
            if (!withSpheres)
                return;
            Ranges.SetData(ranges, 0, 0, 2 * Count);
            if (spheres.Count == 0)
                return;
            if (slots.Length < spheres.Count)
                slots = new int[Slots.count];
            spheres.CopyTo(slots);
            Slots.SetData(slots, 0, 0, spheres.Count);
        }

        /// <summary>Makes what is missing on the GPU.</summary>
        /// <exception cref="Volumes.AnatomyCarveException">The device could not make the lists.</exception>
        public void Reserve()
        {
            if (!IsThere(Bricks))
                Bricks = GpuObjects.CreateBuffer("AnatomyCarve bricks", packed.Length / 2, 2 * sizeof(uint));
            if (!IsThere(Ranges))
                Ranges = GpuObjects.CreateBuffer("AnatomyCarve spheres of bricks", packed.Length / 2, 2 * sizeof(uint));
            int capacity = FirstSlots;
            while (capacity < spheres.Count)
                capacity *= 2;
            if (IsThere(Slots) && Slots.count >= capacity)
                return;
            Slots?.Release();
            Slots = GpuObjects.CreateBuffer("AnatomyCarve spheres in bricks", capacity, sizeof(int));
        }

        public void Dispose()
        {
            Bricks?.Release();
            Ranges?.Release();
            Slots?.Release();
            Bricks = Ranges = Slots = null;
        }

        static bool IsThere(GraphicsBuffer buffer) => buffer != null && buffer.IsValid();

        static long BytesOf(GraphicsBuffer buffer) => buffer == null ? 0 : (long)buffer.count * buffer.stride;
    }
}
