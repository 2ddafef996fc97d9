using System;
using System.Threading;
using AnatomyCarve.Carving;

namespace AnatomyCarve.Headless.Cli.Bench.Error.Reference
{
    /// <summary>
    /// A value per voxel, computed a brick at a time when first asked for, from any thread. Two threads that ask at once may compute the same brick twice.
    /// </summary>
    sealed class LazyBricks<T>(BrickGrid grid, Func<int, int, int, T> compute)
    {
        const int Size = BrickGrid.BrickSize;

        readonly T[][] bricks = new T[grid.Count][];

        public T this[int i, int j, int k]
        {
            get
            {
                var brick = grid.IndexOfVoxel(i, j, k);
                return (Volatile.Read(ref bricks[brick]) ?? Compute(brick))[i % Size + Size * (j % Size + Size * (k % Size))];
            }
        }

        /// <summary>The value of the voxel of the volume that is nearest to a place.</summary>
        public T Clamped(int i, int j, int k) =>
            this[Math.Clamp(i, 0, grid.SizeI - 1), Math.Clamp(j, 0, grid.SizeJ - 1), Math.Clamp(k, 0, grid.SizeK - 1)];

        T[] Compute(int brick)
        {
            grid.BrickAt(brick, out var x, out var y, out var z);
            var values = new T[BrickGrid.VoxelsPerBrick];
            for (var n = 0; n < values.Length; n++)
            {
                var (i, j, k) = (x * Size + n % Size, y * Size + n / Size % Size, z * Size + n / (Size * Size));
                if (i < grid.SizeI && j < grid.SizeJ && k < grid.SizeK) values[n] = compute(i, j, k);
            }

            Volatile.Write(ref bricks[brick], values);
            return values;
        }
    }
}
