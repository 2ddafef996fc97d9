using System;
using System.Buffers.Binary;

namespace AnatomyCarve.Formats
{
    /// <summary>Reads what <see cref="PackedFieldWriter"/> writes, field after field; one that is cut off or out of range is refused by name.</summary>
    sealed class PackedFieldReader
    {
        readonly ReadOnlyMemory<byte> bytes;
        readonly ReadContext context;
        int place;

        /// <param name="bytes">The fields, nothing behind them.</param>
        internal PackedFieldReader(ReadOnlyMemory<byte> bytes, ReadContext context)
        {
            this.bytes = bytes;
            this.context = context;
        }

        /// <summary>Bytes that were not read yet.</summary>
        internal int Left => bytes.Length - place;

        internal byte Byte(string field) => Take(1, field)[0];

        internal int Int32(string field) => BinaryPrimitives.ReadInt32LittleEndian(Take(sizeof(int), field));

        internal long Int64(string field) => BinaryPrimitives.ReadInt64LittleEndian(Take(sizeof(long), field));

        internal double Double(string field) => BitConverter.Int64BitsToDouble(Int64(field));

        internal float Float(string field) => BitConverter.Int32BitsToSingle(Int32(field));

        /// <summary>A number of 0 or more.</summary>
        internal ulong Number(string field)
        {
            ulong number = 0;
            for (int shift = 0; shift < 64; shift += 7)
            {
                byte part = Byte(field);
                if (shift == 63 && part > 1)
                    break;
                number |= (ulong)(part & 0x7F) << shift;
                if (part < 0x80)
                    return number;
            }

            throw context.Refusal(field, $"longer than 64 bits", "a number of at most 64 bits");
        }

        /// <summary>A whole number.</summary>
        internal long Signed(string field)
        {
            ulong number = Number(field);
            return (long)(number >> 1) ^ -(long)(number & 1);
        }

        /// <summary>How many voxels.</summary>
        /// <param name="all">As many as there are.</param>
        internal long Voxels(string field, long all)
        {
            ulong number = Number(field);
            return number <= (ulong)all ? (long)number : throw context.Refusal(field, $"{number}", FormattableString.Invariant($"at most the volume's {all} voxels"));
        }

        /// <summary>How many entries follow; more than the bytes that are left can hold are refused.</summary>
        /// <param name="smallestBytes">The fewest bytes that an entry takes.</param>
        internal int Count(string field, int smallestBytes)
        {
            ulong number = Number(field);
            int most = Left / smallestBytes;
            return number <= (ulong)most ? (int)number : throw context.Refusal(field, $"{number}", FormattableString.Invariant($"at most {most}, which the header has room for"));
        }

        internal string Text(string field)
        {
            var units = new char[Count("the length of " + field, 1)];
            for (int n = 0; n < units.Length; n++)
            {
                ulong unit = Number(field);
                units[n] = unit <= char.MaxValue ? (char)unit : throw context.Refusal(field, $"a letter {unit}", "UTF-16 code units");
            }

            return new string(units);
        }

        internal string[] Texts(string field)
        {
            var texts = new string[Count("the number of " + field, 1)];
            for (int n = 0; n < texts.Length; n++)
                texts[n] = Text(field);
            return texts;
        }

        ReadOnlySpan<byte> Take(int count, string field)
        {
            if (Left < count)
                throw context.Refusal(field, $"cut off", FormattableString.Invariant($"a header that holds all of it (it ends after {bytes.Length} bytes)"));
            place += count;
            return bytes.Span.Slice(place - count, count);
        }
    }
}
