using System;

namespace AnatomyCarve.Formats
{
    /// <summary>Decodes what <see cref="RunEncoder"/> makes, straight into the plane.</summary>
    static class RunDecoder
    {
        /// <summary>Decodes a block.</summary>
        /// <param name="bytes">Its bytes.</param>
        /// <param name="block">Where its voxels go.</param>
        /// <param name="row">Voxels from one row to the next.</param>
        /// <param name="slice">Voxels from one slice to the next.</param>
        /// <param name="largest">The largest value that a voxel may have.</param>
        /// <returns>False where the bytes are no such block.</returns>
        internal static bool TryDecode(ReadOnlySpan<byte> bytes, Span<ushort> block, int row, long slice, ushort largest)
        {
            int place = 0;
            int start = 0;
            while (start < block.Length)
            {
                if (place >= bytes.Length)
                    return false;
                byte head = bytes[place++];
                int voxels = (head & (RunEncoder.LongRun - 1)) + 1;
                if (voxels == RunEncoder.LongRun)
                {
                    if (!TryNumber(bytes, ref place, PackedBlocks.Voxels, out int further))
                        return false;
                    voxels += further;
                }

                if (voxels > block.Length - start)
                    return false;
                var kind = (RunKind)(head >> 6);
                if (kind == RunKind.Above || kind == RunKind.Behind)
                {
                    long distance = kind == RunKind.Above ? row : slice;
                    if (start < distance)
                        return false;
                    Repeat(block, start, (int)distance, voxels);
                }
                else
                {
                    int value = start == 0 ? 0 : block[start - 1];
                    if (kind == RunKind.Value && !TryNumber(bytes, ref place, largest, out value))
                        return false;
                    block.Slice(start, voxels).Fill((ushort)value);
                }

                start += voxels;
            }

            return place == bytes.Length;
        }

        /// <summary>Copies voxels from a distance before; where that is less than their number, what was copied is copied again.</summary>
        static void Repeat(Span<ushort> block, int start, int distance, int voxels)
        {
            while (voxels > 0)
            {
                int count = Math.Min(distance, voxels);
                block.Slice(start - distance, count).CopyTo(block.Slice(start, count));
                start += count;
                voxels -= count;
            }
        }

        static bool TryNumber(ReadOnlySpan<byte> bytes, ref int place, int largest, out int number)
        {
            number = 0;
            for (int shift = 0; shift <= 14; shift += 7)
            {
                if (place >= bytes.Length)
                    return false;
                byte part = bytes[place++];
                number |= (part & 0x7F) << shift;
                if (part < 0x80)
                    return number <= largest;
            }

            return false;
        }
    }
}
