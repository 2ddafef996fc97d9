using System;
using System.Threading;

namespace AnatomyCarve.Volumes
{
    /// <summary>Walks through one component of an image, block by block.</summary>
    static class ComponentBlocks
    {
        /// <summary>What is done with a block; the values are in the array's first elements.</summary>
        /// <param name="values">Values after slope and intercept; the array is used again for the next block.</param>
        /// <param name="start">The first value's voxel, i + SizeI * (j + SizeJ * k).</param>
        /// <param name="count">How many values.</param>
        internal delegate void BlockAction(double[] values, int start, int count);

        /// <summary>Calls an action for each block of a component, in the voxels' order.</summary>
        /// <exception cref="OperationCanceledException">The token was cancelled.</exception>
        internal static void ForEach(VolumeData data, int component, CancellationToken cancellation, BlockAction action)
        {
            int voxels = checked((int)data.Geometry.VoxelCount);
            int stride = data.ComponentOrder == ComponentOrder.Fastest ? data.Components : 1;
            int first = checked((int)data.IndexOf(0, component));
            int perBlock = Math.Min(voxels, Math.Max(1, VoxelConversion.BlockLength / stride));
            var values = new double[perBlock * stride];
            for (int start = 0; start < voxels; start += perBlock)
            {
                cancellation.ThrowIfCancellationRequested();
                int count = Math.Min(perBlock, voxels - start);

                // From the wanted component of the first voxel to that of the last one.
                VoxelConversion.CopyTo(data.Voxels, data.VoxelType, first + (start * stride), values, ((count - 1) * stride) + 1);
                for (int n = 0; n < count; n++)
                {
                    double stored = values[n * stride];
                    values[n] = data.HasScaling ? (data.Slope * stored) + data.Intercept : stored;
                }

                action(values, start, count);
                if (start > voxels - perBlock)
                    break;
            }
        }
    }
}
