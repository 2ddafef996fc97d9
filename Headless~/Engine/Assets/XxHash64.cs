using System;
using System.Buffers.Binary;

namespace UnityEngine
{
    /// <summary>Yann Collet's hash of that name, 64 bits, seed 0, as its specification describes it.</summary>
    static class XxHash64
    {
        const ulong Prime1 = 0x9E3779B185EBCA87, Prime2 = 0xC2B2AE3D27D4EB4F, Prime3 = 0x165667B19E3779F9, Prime4 = 0x85EBCA77C2B2AE63,
            Prime5 = 0x27D4EB2F165667C5;

        const int Stripe = 32;

        internal static ulong Of(ReadOnlySpan<byte> data)
        {
            unchecked
            {
                var rest = data;
                var hash = data.Length < Stripe ? Prime5 : Stripes(ref rest);
                return Avalanche(Tail(hash + (ulong)data.Length, rest));
            }
        }

        /// <summary>Takes in whole stripes of four lanes; leaves what is shorter.</summary>
        static ulong Stripes(ref ReadOnlySpan<byte> data)
        {
            unchecked
            {
                ulong a = Prime1 + Prime2, b = Prime2, c = 0, d = 0 - Prime1;
                for (; data.Length >= Stripe; data = data[Stripe..])
                {
                    a = Round(a, Word(data, 0));
                    b = Round(b, Word(data, 8));
                    c = Round(c, Word(data, 16));
                    d = Round(d, Word(data, 24));
                }

                var hash = Turn(a, 1) + Turn(b, 7) + Turn(c, 12) + Turn(d, 18);
                foreach (var lane in new[] { a, b, c, d })
                    hash = (hash ^ Round(0, lane)) * Prime1 + Prime4;
                return hash;
            }
        }

        static ulong Tail(ulong hash, ReadOnlySpan<byte> data)
        {
            unchecked
            {
                for (; data.Length >= 8; data = data[8..])
                    hash = Turn(hash ^ Round(0, Word(data, 0)), 27) * Prime1 + Prime4;
                for (; data.Length >= 4; data = data[4..])
                    hash = Turn(hash ^ (BinaryPrimitives.ReadUInt32LittleEndian(data) * Prime1), 23) * Prime2 + Prime3;
                foreach (var b in data)
                    hash = Turn(hash ^ (b * Prime5), 11) * Prime1;
                return hash;
            }
        }

        static ulong Avalanche(ulong hash)
        {
            unchecked
            {
                hash = (hash ^ (hash >> 33)) * Prime2;
                hash = (hash ^ (hash >> 29)) * Prime3;
                return hash ^ (hash >> 32);
            }
        }

        static ulong Round(ulong lane, ulong word) => unchecked(Turn(lane + word * Prime2, 31) * Prime1);

        static ulong Turn(ulong value, int bits) => (value << bits) | (value >> (64 - bits));

        static ulong Word(ReadOnlySpan<byte> data, int at) => BinaryPrimitives.ReadUInt64LittleEndian(data[at..]);
    }
}
