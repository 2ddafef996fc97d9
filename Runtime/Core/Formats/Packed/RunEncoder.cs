using System;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Codes a block in runs. A run's first byte holds its kind in the upper two bits and its length less one in the lower six; 63 there means a length of
    /// 64 and more, and the number of voxels beyond 64 follows. A run of kind <see cref="RunKind.Value"/> ends with its value. Numbers have seven bits per
    /// byte, the lowest first, and the upper bit set in all bytes but the last. Not thread safe.
    /// </summary>
    sealed class RunEncoder
    {
        /// <summary>The length that the first byte can hold, and from which on a number follows.</summary>
        internal const int LongRun = 64;

        /// <summary>First byte, a length of at most three bytes, a value of at most three.</summary>
        const int LargestRunBytes = 7;

        readonly byte[] bytes = new byte[(PackedBlocks.Voxels * sizeof(ushort)) + LargestRunBytes];
        int length;

        /// <summary>Codes a block.</summary>
        /// <param name="row">Voxels from one row to the next.</param>
        /// <param name="slice">Voxels from one slice to the next.</param>
        /// <param name="limit">The most bytes that are worth it.</param>
        /// <param name="coded">The bytes, which the next call overwrites.</param>
        /// <returns>False where it would take more bytes.</returns>
        internal bool TryEncode(ReadOnlySpan<ushort> block, int row, long slice, int limit, out ReadOnlySpan<byte> coded)
        {
            limit = Math.Min(limit, bytes.Length - LargestRunBytes);
            coded = default;
            length = 0;
            for (int start = 0; start < block.Length;)
            {
                start += AppendLongest(block, start, row, slice);
                if (length > limit)
                    return false;
            }

            coded = bytes.AsSpan(0, length);
            return true;
        }

        /// <summary>Of equally long runs the one that needs no other memory to decode.</summary>
        int AppendLongest(ReadOnlySpan<ushort> block, int start, int row, long slice)
        {
            ushort value = block[start];
            int voxels = 1;
            while (start + voxels < block.Length && block[start + voxels] == value)
                voxels++;
            bool isSame = start > 0 && block[start - 1] == value;
            RunKind kind = isSame ? RunKind.Same : RunKind.Value;
            Compare(RunKind.Above, Repeated(block, start, row), ref kind, ref voxels);
            Compare(RunKind.Behind, Repeated(block, start, slice), ref kind, ref voxels);
            bytes[length++] = (byte)(((int)kind << 6) | (Math.Min(voxels, LongRun) - 1));
            if (voxels >= LongRun)
                AppendNumber(voxels - LongRun);
            if (kind == RunKind.Value)
                AppendNumber(value);
            return voxels;
        }

        /// <summary>Takes another kind where it reaches further, or as far without a value.</summary>
        static void Compare(RunKind other, int otherVoxels, ref RunKind kind, ref int voxels)
        {
            if (otherVoxels < voxels || (otherVoxels == voxels && kind != RunKind.Value))
                return;
            kind = other;
            voxels = otherVoxels;
        }

        /// <summary>How many voxels from the start on are as those a distance before.</summary>
        static int Repeated(ReadOnlySpan<ushort> block, int start, long distance)
        {
            if (start < distance)
                return 0;
            int count = 0;
            ReadOnlySpan<ushort> later = block.Slice(start);
            ReadOnlySpan<ushort> earlier = block.Slice(start - (int)distance);
            while (count < later.Length && later[count] == earlier[count])
                count++;
            return count;
        }

        void AppendNumber(int number)
        {
            for (; number >= 0x80; number >>= 7)
                bytes[length++] = (byte)(number | 0x80);
            bytes[length++] = (byte)number;
        }
    }
}
