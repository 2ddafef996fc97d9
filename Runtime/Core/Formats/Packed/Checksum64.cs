using System;
using System.Buffers.Binary;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// XXH64 with seed 0 (Collet, xxHash's specification 0.1.1): a checksum against damage, several gigabytes per second on one core. It is no protection
    /// against people who forge files.
    /// </summary>
    static class Checksum64
    {
        const ulong Prime1 = 11400714785074694791;
        const ulong Prime2 = 14029467366897019727;
        const ulong Prime3 = 1609587929392839161;
        const ulong Prime4 = 9650029242287828579;
        const ulong Prime5 = 2870177450012600261;

        const int StripeBytes = 32;

        internal static ulong Of(ReadOnlySpan<byte> bytes)
        {
            ulong length = (ulong)bytes.Length;
            ulong hash = Prime5;
            if (bytes.Length >= StripeBytes)
                hash = Stripes(ref bytes);
            hash += length;
            for (; bytes.Length >= 8; bytes = bytes.Slice(8))
                hash = (RotateLeft(hash ^ Round(0, BinaryPrimitives.ReadUInt64LittleEndian(bytes)), 27) * Prime1) + Prime4;
            for (; bytes.Length >= 4; bytes = bytes.Slice(4))
                hash = (RotateLeft(hash ^ (BinaryPrimitives.ReadUInt32LittleEndian(bytes) * Prime1), 23) * Prime2) + Prime3;
            foreach (byte value in bytes)
                hash = RotateLeft(hash ^ (value * Prime5), 11) * Prime1;
            hash = (hash ^ (hash >> 33)) * Prime2;
            hash = (hash ^ (hash >> 29)) * Prime3;
            return hash ^ (hash >> 32);
        }

        /// <summary>Takes all whole stripes from the start of the bytes.</summary>
        static ulong Stripes(ref ReadOnlySpan<byte> bytes)
        {
            ulong a = unchecked(Prime1 + Prime2), b = Prime2, c = 0, d = unchecked(0 - Prime1);
            for (; bytes.Length >= StripeBytes; bytes = bytes.Slice(StripeBytes))
            {
                a = Round(a, BinaryPrimitives.ReadUInt64LittleEndian(bytes));
                b = Round(b, BinaryPrimitives.ReadUInt64LittleEndian(bytes.Slice(8)));
                c = Round(c, BinaryPrimitives.ReadUInt64LittleEndian(bytes.Slice(16)));
                d = Round(d, BinaryPrimitives.ReadUInt64LittleEndian(bytes.Slice(24)));
            }

            ulong hash = RotateLeft(a, 1) + RotateLeft(b, 7) + RotateLeft(c, 12) + RotateLeft(d, 18);
            return Merge(Merge(Merge(Merge(hash, a), b), c), d);
        }

        static ulong Merge(ulong hash, ulong lane) => ((hash ^ Round(0, lane)) * Prime1) + Prime4;

        static ulong Round(ulong lane, ulong input) => RotateLeft(lane + (input * Prime2), 31) * Prime1;

        static ulong RotateLeft(ulong value, int bits) => (value << bits) | (value >> (64 - bits));
    }
}
