using System;
using AnatomyCarve.Carving;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>A list of packed bricks on the GPU, as long as the array that it is filled from, so that edits do not make it anew.</summary>
    sealed class BrickBuffer : IDisposable
    {
        readonly string name;
        readonly BrickGrid grid;

        public BrickBuffer(string name, BrickGrid grid)
        {
            this.name = name;
            this.grid = grid;
        }

        /// <summary>The bytes of a list that holds so many bricks.</summary>
        public static long BytesOf(long bricks) => sizeof(uint) * Math.Max(bricks, 1);

        /// <summary>The list; null before the first upload.</summary>
        public GraphicsBuffer Buffer { get; private set; }

        /// <summary>The number of bricks in the list.</summary>
        public int Count { get; private set; }

        /// <summary>The voxels of these bricks that lie in the volume.</summary>
        public long Voxels { get; private set; }

        public long Bytes => Buffer == null ? 0 : (long)Buffer.count * Buffer.stride;

        /// <summary>Whether the list would be there for a dispatch; a lost device takes it away.</summary>
        public bool IsValid => Buffer != null && Buffer.IsValid();

        /// <exception cref="Volumes.AnatomyCarveException">The device could not make the list.</exception>
        public void Upload(uint[] packed, int count)
        {
            if (Buffer == null || !Buffer.IsValid() || Buffer.count < count)
            {
                Dispose();
                Buffer = GpuObjects.CreateBuffer(name, Mathf.Max(packed.Length, 1), sizeof(uint));
            }
            Buffer.SetData(packed, 0, 0, count);
            Count = count;
            Voxels = VoxelsOf(packed, count);
        }

        public void Dispose()
        {
            Buffer?.Release();
            Buffer = null;
        }

        long VoxelsOf(uint[] packed, int count)
        {
            long voxels = 0;
            for (int b = 0; b < count; b++)
            {
                BrickGrid.Unpack(packed[b], out int x, out int y, out int z);
                voxels += Inside(x, grid.SizeI) * Inside(y, grid.SizeJ) * Inside(z, grid.SizeK);
            }
            return voxels;
        }

        static int Inside(int brick, int size) => Math.Min(BrickGrid.BrickSize, size - brick * BrickGrid.BrickSize);
    }
}
