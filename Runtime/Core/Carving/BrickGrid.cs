using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// A volume cut into bricks of 8 x 8 x 8 voxels, the unit in which kernels and caches work. The last brick of an axis may be partly outside the
    /// volume. Bricks are counted with x fastest; for the kernels they are packed as x | y &lt;&lt; 10 | z &lt;&lt; 20.
    /// </summary>
    public sealed class BrickGrid
    {
        /// <summary>Voxels along a brick's edge.</summary>
        public const int BrickSize = BlockContents.BlockSize;

        /// <summary>Voxels in a brick.</summary>
        public const int VoxelsPerBrick = BrickSize * BrickSize * BrickSize;

        /// <summary>The largest number of bricks along an axis, which is what packing holds: 8,192 voxels.</summary>
        public const int MaxBricksPerAxis = 1 << AxisBits;

        const int AxisBits = 10;
        const uint AxisMask = MaxBricksPerAxis - 1;

        /// <summary>Cuts a volume into bricks.</summary>
        /// <param name="sizeI">Voxels along i, 1 to 8,192; likewise j and k.</param>
        /// <param name="sizeJ">Voxels along j.</param>
        /// <param name="sizeK">Voxels along k.</param>
        /// <exception cref="ArgumentOutOfRangeException">A size lies outside its range.</exception>
        public BrickGrid(int sizeI, int sizeJ, int sizeK)
        {
            BricksX = BricksAlong(sizeI, nameof(sizeI));
            BricksY = BricksAlong(sizeJ, nameof(sizeJ));
            BricksZ = BricksAlong(sizeK, nameof(sizeK));
            SizeI = sizeI;
            SizeJ = sizeJ;
            SizeK = sizeK;
            Count = BricksX * BricksY * BricksZ;
        }

        /// <summary>Cuts a volume into bricks.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="geometry"/> is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The volume is longer than 8,192 voxels.</exception>
        public BrickGrid(VolumeGeometry geometry)
            : this((geometry ?? throw new ArgumentNullException(nameof(geometry))).SizeI, geometry.SizeJ, geometry.SizeK)
        {
        }

        /// <summary>Voxels along i.</summary>
        public int SizeI { get; }

        /// <summary>Voxels along j.</summary>
        public int SizeJ { get; }

        /// <summary>Voxels along k.</summary>
        public int SizeK { get; }

        /// <summary>Bricks along i.</summary>
        public int BricksX { get; }

        /// <summary>Bricks along j.</summary>
        public int BricksY { get; }

        /// <summary>Bricks along k.</summary>
        public int BricksZ { get; }

        /// <summary>The number of bricks.</summary>
        public int Count { get; }

        /// <summary>The number of bricks of a volume, whatever its size.</summary>
        /// <param name="sizeI">Voxels along i; likewise j and k.</param>
        /// <param name="sizeJ">Voxels along j.</param>
        /// <param name="sizeK">Voxels along k.</param>
        public static long CountOf(int sizeI, int sizeJ, int sizeK) =>
            (sizeI + BrickSize - 1L) / BrickSize * ((sizeJ + BrickSize - 1L) / BrickSize) * ((sizeK + BrickSize - 1L) / BrickSize);

        /// <summary>A brick as the kernels take it: x | y &lt;&lt; 10 | z &lt;&lt; 20.</summary>
        public static uint Pack(int x, int y, int z) => (uint)x | ((uint)y << AxisBits) | ((uint)z << (2 * AxisBits));

        /// <summary>The opposite of <see cref="Pack"/>.</summary>
        public static void Unpack(uint packed, out int x, out int y, out int z)
        {
            x = (int)(packed & AxisMask);
            y = (int)((packed >> AxisBits) & AxisMask);
            z = (int)((packed >> (2 * AxisBits)) & AxisMask);
        }

        /// <summary>A brick's number, 0 to Count - 1, x fastest. The brick is not checked.</summary>
        public int IndexOf(int x, int y, int z) => x + BricksX * (y + BricksY * z);

        /// <summary>The number of the brick that holds a voxel. The voxel is not checked.</summary>
        public int IndexOfVoxel(int i, int j, int k) => IndexOf(i / BrickSize, j / BrickSize, k / BrickSize);

        /// <summary>The brick of a number.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such brick.</exception>
        public void BrickAt(int index, out int x, out int y, out int z)
        {
            if (index < 0 || index >= Count)
                throw new ArgumentOutOfRangeException(nameof(index), index, FormattableString.Invariant($"The bricks are 0 to {Count - 1}."));
            x = index % BricksX;
            int rest = index / BricksX;
            y = rest % BricksY;
            z = rest / BricksY;
        }

        /// <summary>Whether there is such a brick.</summary>
        public bool Contains(int x, int y, int z) => (uint)x < (uint)BricksX && (uint)y < (uint)BricksY && (uint)z < (uint)BricksZ;

        /// <summary>The voxels of a brick that lie in the volume. The brick is not checked.</summary>
        public VoxelBox VoxelsOf(int x, int y, int z) => new VoxelBox
        {
            MinI = x * BrickSize, MinJ = y * BrickSize, MinK = z * BrickSize,
            MaxI = Math.Min((x + 1) * BrickSize, SizeI) - 1, MaxJ = Math.Min((y + 1) * BrickSize, SizeJ) - 1, MaxK = Math.Min((z + 1) * BrickSize, SizeK) - 1,
        };

        /// <summary>Every brick, packed, in the order of their numbers.</summary>
        public uint[] PackAll()
        {
            var packed = new uint[Count];
            int next = 0;
            for (int z = 0; z < BricksZ; z++)
                for (int y = 0; y < BricksY; y++)
                    for (int x = 0; x < BricksX; x++)
                        packed[next++] = Pack(x, y, z);
            return packed;
        }

        static int BricksAlong(int size, string argument)
        {
            if (size < 1 || size > MaxBricksPerAxis * BrickSize)
                throw new ArgumentOutOfRangeException(argument, size,
                    FormattableString.Invariant($"A volume has 1 to {MaxBricksPerAxis * BrickSize} voxels along an axis."));
            return (size + BrickSize - 1) / BrickSize;
        }
    }
}
