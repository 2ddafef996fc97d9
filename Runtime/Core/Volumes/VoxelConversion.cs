using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>Turns runs of stored values of any type into doubles, block by block and without boxing.</summary>
    static class VoxelConversion
    {
        /// <summary>Values per block where a whole volume is walked through: 256 KiB of doubles.</summary>
        internal const int BlockLength = 32768;

        /// <summary>Copies stored values, converted to double, into a buffer.</summary>
        /// <param name="voxels">An array of one of the ten voxel types.</param>
        /// <param name="start">The first value's place in it.</param>
        /// <param name="target">Takes the values from its start.</param>
        /// <param name="count">How many.</param>
        internal static void CopyTo(Array voxels, VoxelType type, int start, double[] target, int count)
        {
            switch (type)
            {
                case VoxelType.Int8:
                    Copy((sbyte[])voxels, start, target, count);
                    break;
                case VoxelType.UInt8:
                    Copy((byte[])voxels, start, target, count);
                    break;
                case VoxelType.Int16:
                    Copy((short[])voxels, start, target, count);
                    break;
                case VoxelType.UInt16:
                    Copy((ushort[])voxels, start, target, count);
                    break;
                case VoxelType.Int32:
                    Copy((int[])voxels, start, target, count);
                    break;
                case VoxelType.UInt32:
                    Copy((uint[])voxels, start, target, count);
                    break;
                case VoxelType.Int64:
                    Copy((long[])voxels, start, target, count);
                    break;
                case VoxelType.UInt64:
                    Copy((ulong[])voxels, start, target, count);
                    break;
                case VoxelType.Float32:
                    Copy((float[])voxels, start, target, count);
                    break;
                default:
                    Array.Copy((double[])voxels, start, target, 0, count);
                    break;
            }
        }

        /// <summary>One stored value as a double.</summary>
        internal static double At(Array voxels, VoxelType type, long index)
        {
            switch (type)
            {
                case VoxelType.Int8:
                    return ((sbyte[])voxels)[index];
                case VoxelType.UInt8:
                    return ((byte[])voxels)[index];
                case VoxelType.Int16:
                    return ((short[])voxels)[index];
                case VoxelType.UInt16:
                    return ((ushort[])voxels)[index];
                case VoxelType.Int32:
                    return ((int[])voxels)[index];
                case VoxelType.UInt32:
                    return ((uint[])voxels)[index];
                case VoxelType.Int64:
                    return ((long[])voxels)[index];
                case VoxelType.UInt64:
                    return ((ulong[])voxels)[index];
                case VoxelType.Float32:
                    return ((float[])voxels)[index];
                default:
                    return ((double[])voxels)[index];
            }
        }

        static void Copy(sbyte[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }

        static void Copy(byte[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }

        static void Copy(short[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }

        static void Copy(ushort[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }

        static void Copy(int[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }

        static void Copy(uint[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }

        static void Copy(long[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }

        static void Copy(ulong[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }

        static void Copy(float[] source, int start, double[] target, int count)
        {
            for (int n = 0; n < count; n++)
                target[n] = source[start + n];
        }
    }
}
