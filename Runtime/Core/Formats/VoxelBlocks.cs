using System;
using System.Buffers.Binary;
using System.IO;
using System.Runtime.InteropServices;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Reads voxels from a stream straight into an array of their type, block by block. Memory is never taken on a header's word alone:
    /// where the data are compressed the array grows with what really comes out, in halves of the whole, so that the peak is 1.5 times
    /// the voxels.
    /// </summary>
    static class VoxelBlocks
    {
        /// <summary>The most elements that one .NET array holds, whatever their type.</summary>
        internal const long LargestCount = 0x7FEFFFFF;

        const int BlockBytes = 1 << 20;

        /// <summary>Arrays up to this size are taken at once: a file that lies can't do harm with them.</summary>
        const long UnprovenBytes = 32L << 20;

        /// <summary>Reads voxels, and refuses the file when they end too early.</summary>
        /// <param name="stream">At the first voxel.</param>
        /// <param name="count">How many values.</param>
        /// <param name="bigEndian">The file's byte order.</param>
        /// <param name="largestSize">The most bytes that the stream can give.</param>
        /// <param name="sizeIsProven">True when the stream surely gives so many.</param>
        internal static Array Read(
            Stream stream, VoxelType type, long count, bool bigEndian, long largestSize, bool sizeIsProven, ReadContext context)
        {
            int size = type.SizeOf();
            if (count > LargestCount)
                throw context.Refusal("the number of values", $"{count}", FormattableString.Invariant($"at most {LargestCount}"));
            if (count * size > largestSize)
                throw context.Refusal("the voxel data", $"too short (the file can hold {largestSize} bytes of them at most)", FormattableString.Invariant($"{count * size} bytes, as the header says"));
            long capacity = count;
            while (!sizeIsProven && capacity * size > UnprovenBytes)
                capacity = (capacity + 1) / 2;
            var job = new Job { Stream = stream, Count = (int)count, FirstCapacity = (int)capacity, Swap = bigEndian == BitConverter.IsLittleEndian, Context = context };
            switch (type)
            {
                case VoxelType.Int8:
                    return Read<sbyte>(job);
                case VoxelType.UInt8:
                    return Read<byte>(job);
                case VoxelType.Int16:
                    return Read<short>(job);
                case VoxelType.UInt16:
                    return Read<ushort>(job);
                case VoxelType.Int32:
                    return Read<int>(job);
                case VoxelType.UInt32:
                    return Read<uint>(job);
                case VoxelType.Int64:
                    return Read<long>(job);
                case VoxelType.UInt64:
                    return Read<ulong>(job);
                case VoxelType.Float32:
                    return Read<float>(job);
                default:
                    return Read<double>(job);
            }
        }

        static T[] Read<T>(Job job)
            where T : unmanaged
        {
            int size = Marshal.SizeOf<T>();
            int perBlock = BlockBytes / size;
            var voxels = new T[job.FirstCapacity];
            for (int filled = 0; filled < job.Count;)
            {
                job.Context.Cancellation.ThrowIfCancellationRequested();
                if (filled == voxels.Length)
                    Array.Resize(ref voxels, (int)Math.Min(job.Count, 2L * voxels.Length));
                int wanted = Math.Min(perBlock, voxels.Length - filled);
                Span<byte> bytes = MemoryMarshal.AsBytes(voxels.AsSpan(filled, wanted));
                int read = VolumeFile.ReadFully(job.Stream, bytes);
                if (read < bytes.Length)
                {
                    long present = ((long)filled * size) + read;
                    throw job.Context.Refusal("the voxel data", $"cut off after {present} bytes", FormattableString.Invariant($"{(long)job.Count * size} bytes, as the header says"));
                }

                if (job.Swap)
                    SwapBytes(bytes, size);
                filled += wanted;
                job.Context.Progress?.Report((float)filled / job.Count);
            }

            return voxels;
        }

        static void SwapBytes(Span<byte> bytes, int size)
        {
            switch (size)
            {
                case 2:
                    Span<ushort> words = MemoryMarshal.Cast<byte, ushort>(bytes);
                    for (int n = 0; n < words.Length; n++)
                        words[n] = BinaryPrimitives.ReverseEndianness(words[n]);
                    break;
                case 4:
                    Span<uint> doubleWords = MemoryMarshal.Cast<byte, uint>(bytes);
                    for (int n = 0; n < doubleWords.Length; n++)
                        doubleWords[n] = BinaryPrimitives.ReverseEndianness(doubleWords[n]);
                    break;
                case 8:
                    Span<ulong> quadWords = MemoryMarshal.Cast<byte, ulong>(bytes);
                    for (int n = 0; n < quadWords.Length; n++)
                        quadWords[n] = BinaryPrimitives.ReverseEndianness(quadWords[n]);
                    break;
            }
        }

        struct Job
        {
            internal Stream Stream;
            internal int Count;
            internal int FirstCapacity;
            internal bool Swap;
            internal ReadContext Context;
        }
    }
}
