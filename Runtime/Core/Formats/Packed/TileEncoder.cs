using System;
using System.Buffers.Binary;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Codes a block in tiles of 256 voxels. A tile is one byte: its predictor, and a mark where every prediction is right. Otherwise there follow the
    /// widths of its 16 groups of 16 voxels, four bits each, the first in the lowest (15 stands for 16), then each group's differences from the
    /// prediction, modulo 2^16, in so many bits each: two bytes per bit of width, the first voxel in the lowest bits, with half of 2^width added, so that none is
    /// negative. A block's last tile may be shorter; what is missing counts as 0. Eight zeros end the block. Not thread safe.
    /// </summary>
    sealed class TileEncoder
    {
        readonly ushort[] differences = new ushort[Tile.Voxels];
        readonly ushort[] best = new ushort[Tile.Voxels];
        readonly byte[] bytes = new byte[LargestBlockBytes];
        int length;

        /// <summary>Every tile at full width.</summary>
        static int LargestBlockBytes =>
            (PackedBlocks.Voxels / Tile.Voxels * (1 + Tile.WidthBytes + (Tile.Voxels * sizeof(ushort)))) + Tile.PaddingBytes;

        /// <summary>Codes a block.</summary>
        /// <param name="row">Voxels from one row to the next.</param>
        /// <param name="slice">Voxels from one slice to the next.</param>
        /// <returns>The bytes, which the next call overwrites.</returns>
        internal ReadOnlySpan<byte> Encode(ReadOnlySpan<ushort> block, int row, long slice)
        {
            length = 0;
            for (int start = 0; start < block.Length; start += Tile.Voxels)
                EncodeTile(block, start, row, slice);
            bytes.AsSpan(length, Tile.PaddingBytes).Clear();
            return bytes.AsSpan(0, length + Tile.PaddingBytes);
        }

        void EncodeTile(ReadOnlySpan<ushort> block, int start, int row, long slice)
        {
            int smallest = int.MaxValue;
            ulong bestWidths = 0;
            TilePredictor bestPredictor = default;
            foreach (TilePredictor predictor in Tile.Predictors)
            {
                if (start < Tile.Reach(predictor, row, slice))
                    continue;
                Predict(block, start, predictor, row, (int)Math.Min(slice, int.MaxValue));
                ulong widths = Widths(out int size);
                if (size >= smallest)
                    continue;
                smallest = size;
                bestWidths = widths;
                bestPredictor = predictor;
                if (size == 0)
                    break;
                differences.CopyTo(best, 0);
            }

            if (smallest == 0)
                bytes[length++] = (byte)((byte)bestPredictor | Tile.Exact);
            else
                Append(bestPredictor, bestWidths, (Math.Min(Tile.Voxels, block.Length - start) + Tile.GroupVoxels - 1) / Tile.GroupVoxels);
        }

        /// <summary>Fills <see cref="differences"/>.</summary>
        void Predict(ReadOnlySpan<ushort> block, int start, TilePredictor predictor, int row, int slice)
        {
            int count = Math.Min(Tile.Voxels, block.Length - start);
            ReadOnlySpan<ushort> actual = block.Slice(start, count);
            int left = start == 0 ? 0 : block[start - 1];
            switch (predictor)
            {
                case TilePredictor.Left:
                    for (int n = 0; n < actual.Length; n++)
                    {
                        differences[n] = (ushort)(actual[n] - left);
                        left = actual[n];
                    }

                    break;
                case TilePredictor.Mean:
                    for (int n = 0; n < actual.Length; n++)
                    {
                        differences[n] = (ushort)(actual[n] - ((left + block[start + n - row]) >> 1));
                        left = actual[n];
                    }

                    break;
                case TilePredictor.Plane:
                    for (int n = 0; n < actual.Length; n++)
                    {
                        differences[n] = (ushort)(actual[n] - (left + block[start + n - row] - block[start + n - row - 1]));
                        left = actual[n];
                    }

                    break;
                default:
                    int distance = predictor == TilePredictor.Above ? row : slice;
                    for (int n = 0; n < actual.Length; n++)
                        differences[n] = (ushort)(actual[n] - block[start + n - distance]);
                    break;
            }

            differences.AsSpan(count).Clear();
        }

        /// <summary>The widths of the groups of <see cref="differences"/>, four bits each.</summary>
        /// <param name="size">The bytes that the differences take; 0 where all are 0.</param>
        ulong Widths(out int size)
        {
            ulong widths = 0;
            size = 0;
            for (int group = 0; group < Tile.Voxels / Tile.GroupVoxels; group++)
            {
                int any = 0;
                int magnitude = 0;
                foreach (ushort difference in differences.AsSpan(group * Tile.GroupVoxels, Tile.GroupVoxels))
                {
                    any |= difference;
                    magnitude |= (short)difference ^ ((short)difference >> 15);
                }

                int width = any == 0 ? 0 : 1;
                for (; magnitude != 0; magnitude >>= 1)
                    width++;
                width = width == Tile.FullWidth - 1 ? Tile.FullWidth : width;
                size += width * Tile.GroupVoxels / 8;
                widths |= (ulong)Math.Min(width, Tile.FullWidth - 1) << (4 * group);
            }

            return widths;
        }

        void Append(TilePredictor predictor, ulong widths, int groups)
        {
            bytes[length] = (byte)predictor;
            BinaryPrimitives.WriteUInt64LittleEndian(bytes.AsSpan(length + 1), widths);
            length += 1 + Tile.WidthBytes;
            for (int group = 0; group < groups; group++)
            {
                int width = (int)(widths >> (4 * group)) & 15;
                width = width == Tile.FullWidth - 1 ? Tile.FullWidth : width;
                int bias = (1 << width) >> 1;
                ulong mask = (1UL << width) - 1;
                ulong word = 0;
                int bits = 0;
                foreach (ushort difference in best.AsSpan(group * Tile.GroupVoxels, Tile.GroupVoxels))
                {
                    word |= ((ulong)(difference + bias) & mask) << bits;
                    for (bits += width; bits >= 8; bits -= 8)
                    {
                        bytes[length++] = (byte)word;
                        word >>= 8;
                    }
                }
            }
        }
    }
}
