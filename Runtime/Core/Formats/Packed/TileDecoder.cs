using System;
using System.Buffers.Binary;

namespace AnatomyCarve.Formats
{
    /// <summary>Decodes what <see cref="TileEncoder"/> makes, straight into the plane.</summary>
    static class TileDecoder
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
            Span<ushort> differences = stackalloc ushort[Tile.Voxels];
            int place = 0;
            int end = bytes.Length - Tile.PaddingBytes;
            for (int start = 0; start < block.Length; start += Tile.Voxels)
            {
                if (place >= end)
                    return false;
                byte head = bytes[place++];
                var predictor = (TilePredictor)(head & ~Tile.Exact);
                if (predictor > TilePredictor.Plane || start < Tile.Reach(predictor, row, slice))
                    return false;
                int count = Math.Min(Tile.Voxels, block.Length - start);
                if ((head & Tile.Exact) != 0)
                    differences.Clear();
                else if (!TryUnpack(bytes, ref place, differences.Slice(0, (count + Tile.GroupVoxels - 1) & -Tile.GroupVoxels)))
                    return false;
                Add(block, start, differences.Slice(0, count), predictor, row, slice);
            }

            return place == end && (largest == ushort.MaxValue || IsWithin(block, largest));
        }

        /// <summary>Reads the differences of a tile's groups.</summary>
        static bool TryUnpack(ReadOnlySpan<byte> bytes, ref int place, Span<ushort> differences)
        {
            int end = bytes.Length - Tile.PaddingBytes;
            if (end - place < Tile.WidthBytes)
                return false;
            ulong widths = BinaryPrimitives.ReadUInt64LittleEndian(bytes.Slice(place));
            place += Tile.WidthBytes;
            for (; differences.Length >= Tile.GroupVoxels; differences = differences.Slice(Tile.GroupVoxels), widths >>= 4)
            {
                int width = (int)widths & 15;
                width = width == Tile.FullWidth - 1 ? Tile.FullWidth : width;
                int size = width * Tile.GroupVoxels / 8;
                if (end - place < size)
                    return false;
                ReadOnlySpan<byte> group = bytes.Slice(place, size + Tile.PaddingBytes);
                place += size;
                if (width == 0)
                {
                    differences.Slice(0, Tile.GroupVoxels).Clear();
                }
                else if (width <= 8)
                {
                    UnpackEight(BinaryPrimitives.ReadUInt64LittleEndian(group), width, differences);
                    UnpackEight(BinaryPrimitives.ReadUInt64LittleEndian(group.Slice(width)), width, differences.Slice(8));
                }
                else
                {
                    // Four voxels of at most 16 bits; they start in the middle of a byte only where widths are odd, so at most 13.
                    for (int quarter = 0; quarter < 4; quarter++)
                    {
                        int bit = 4 * width * quarter;
                        UnpackFour(BinaryPrimitives.ReadUInt64LittleEndian(group.Slice(bit >> 3)) >> (bit & 7), width, differences.Slice(4 * quarter));
                    }
                }
            }

            return true;
        }

        static bool IsWithin(ReadOnlySpan<ushort> block, ushort largest)
        {
            ushort found = 0;
            foreach (ushort value in block)
                found = Math.Max(found, value);
            return found <= largest;
        }

        static void UnpackEight(ulong word, int width, Span<ushort> differences)
        {
            uint mask = (1u << width) - 1;
            uint bias = (1u << width) >> 1;
            differences[7] = (ushort)(((uint)(word >> (7 * width)) & mask) - bias);
            differences[6] = (ushort)(((uint)(word >> (6 * width)) & mask) - bias);
            differences[5] = (ushort)(((uint)(word >> (5 * width)) & mask) - bias);
            differences[4] = (ushort)(((uint)(word >> (4 * width)) & mask) - bias);
            differences[3] = (ushort)(((uint)(word >> (3 * width)) & mask) - bias);
            differences[2] = (ushort)(((uint)(word >> (2 * width)) & mask) - bias);
            differences[1] = (ushort)(((uint)(word >> width) & mask) - bias);
            differences[0] = (ushort)(((uint)word & mask) - bias);
        }

        static void UnpackFour(ulong word, int width, Span<ushort> differences)
        {
            uint mask = (1u << width) - 1;
            uint bias = (1u << width) >> 1;
            differences[3] = (ushort)(((uint)(word >> (3 * width)) & mask) - bias);
            differences[2] = (ushort)(((uint)(word >> (2 * width)) & mask) - bias);
            differences[1] = (ushort)(((uint)(word >> width) & mask) - bias);
            differences[0] = (ushort)(((uint)word & mask) - bias);
        }

        /// <summary>Adds the differences to what is predicted, voxel after voxel. The next voxel waits for as little as possible: one addition, or two and a shift.</summary>
        static void Add(Span<ushort> block, int start, ReadOnlySpan<ushort> differences, TilePredictor predictor, int row, long slice)
        {
            Span<ushort> voxels = block.Slice(start, differences.Length);
            int left = start == 0 ? 0 : block[start - 1];
            switch (predictor)
            {
                case TilePredictor.Left:
                    for (int n = 0; n < differences.Length && n < voxels.Length; n++)
                    {
                        left += differences[n];
                        voxels[n] = (ushort)left;
                    }

                    break;
                case TilePredictor.Mean:
                {
                    ReadOnlySpan<ushort> above = block.Slice(start - row, differences.Length);
                    for (int n = 0; n < differences.Length && n < voxels.Length && n < above.Length; n++)
                    {
                        left = (ushort)(((left + above[n]) >> 1) + differences[n]);
                        voxels[n] = (ushort)left;
                    }

                    break;
                }

                case TilePredictor.Plane:
                {
                    ReadOnlySpan<ushort> above = block.Slice(start - row, differences.Length);
                    int aboveLeft = block[start - row - 1];
                    for (int n = 0; n < differences.Length && n < voxels.Length && n < above.Length; n++)
                    {
                        int step = above[n] - aboveLeft + differences[n];
                        aboveLeft = above[n];
                        left += step;
                        voxels[n] = (ushort)left;
                    }

                    break;
                }

                default:
                {
                    ReadOnlySpan<ushort> earlier = block.Slice(start - (predictor == TilePredictor.Above ? row : (int)slice), differences.Length);
                    for (int n = 0; n < differences.Length && n < voxels.Length && n < earlier.Length; n++)
                        voxels[n] = (ushort)(earlier[n] + differences[n]);
                    break;
                }
            }
        }
    }
}
