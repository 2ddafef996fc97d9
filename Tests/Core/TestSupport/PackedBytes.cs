using System;

namespace AnatomyCarve.Tests.TestSupport
{
    /// <summary>Makes the checksums of a packed volume fit whatever else it holds: what somebody does who forges one.</summary>
    public static class PackedBytes
    {
        const int HeaderLengthPlace = 12;
        const int SummaryBytes = 12 + (12 * 8) + 1;

        /// <summary>Writes the header's checksum anew.</summary>
        public static void SealHeader(byte[] packed)
        {
            int end = BitConverter.ToInt32(packed, HeaderLengthPlace) - 8;
            BitConverter.GetBytes(Xxh64(packed, 0, end)).CopyTo(packed, end);
        }

        /// <summary>
        /// Writes the blocks' checksums anew, of a volume with one block per plane, then the header's. An entry of the directory ends the header, in front
        /// of its checksum.
        /// </summary>
        public static void SealBlocks(byte[] packed)
        {
            int headerBytes = BitConverter.ToInt32(packed, HeaderLengthPlace);
            int labelBytes = (int)BitConverter.ToInt64(packed, 24 + SummaryBytes + (3 * 8) + 4 + 8);
            int intensityBytes = packed.Length - headerBytes - labelBytes;
            int labelEntry = headerBytes - 8 - 8;
            int intensityEntry = labelEntry - LengthBytes(labelBytes) - 1 - 8;
            BitConverter.GetBytes(Xxh64(packed, headerBytes, intensityBytes)).CopyTo(packed, intensityEntry);
            BitConverter.GetBytes(Xxh64(packed, headerBytes + intensityBytes, labelBytes)).CopyTo(packed, labelEntry);
            SealHeader(packed);
        }

        /// <summary>XXH64 with seed 0, as its specification has it.</summary>
        public static ulong Xxh64(byte[] bytes, int start, int count)
        {
            const ulong prime1 = 0x9E3779B185EBCA87, prime2 = 0xC2B2AE3D27D4EB4F, prime3 = 0x165667B19E3779F9, prime4 = 0x85EBCA77C2B2AE63, prime5 = 0x27D4EB2F165667C5;
            int place = start, end = start + count;
            ulong hash;
            unchecked
            {
                if (count >= 32)
                {
                    ulong[] lanes = { prime1 + prime2, prime2, 0, 0 - prime1 };
                    for (; place <= end - 32; place += 32)
                        for (int lane = 0; lane < 4; lane++)
                            lanes[lane] = Turn(lanes[lane] + (BitConverter.ToUInt64(bytes, place + (8 * lane)) * prime2), 31) * prime1;
                    hash = Turn(lanes[0], 1) + Turn(lanes[1], 7) + Turn(lanes[2], 12) + Turn(lanes[3], 18);
                    foreach (ulong lane in lanes)
                        hash = ((hash ^ (Turn(lane * prime2, 31) * prime1)) * prime1) + prime4;
                }
                else
                {
                    hash = prime5;
                }

                hash += (ulong)count;
                for (; place <= end - 8; place += 8)
                    hash = (Turn(hash ^ (Turn(BitConverter.ToUInt64(bytes, place) * prime2, 31) * prime1), 27) * prime1) + prime4;
                for (; place <= end - 4; place += 4)
                    hash = (Turn(hash ^ (BitConverter.ToUInt32(bytes, place) * prime1), 23) * prime2) + prime3;
                for (; place < end; place++)
                    hash = Turn(hash ^ (bytes[place] * prime5), 11) * prime1;
                hash = (hash ^ (hash >> 33)) * prime2;
                hash = (hash ^ (hash >> 29)) * prime3;
                return hash ^ (hash >> 32);
            }
        }

        static ulong Turn(ulong value, int bits) => (value << bits) | (value >> (64 - bits));

        static int LengthBytes(int number) => number < 1 << 7 ? 1 : number < 1 << 14 ? 2 : number < 1 << 21 ? 3 : 4;
    }
}
