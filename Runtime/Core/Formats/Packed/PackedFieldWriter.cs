using System;
using System.Buffers.Binary;
using System.Collections.Generic;

namespace AnatomyCarve.Formats
{
    /// <summary>Writes the fields of a packed volume's header: little-endian, without gaps.</summary>
    sealed class PackedFieldWriter
    {
        byte[] bytes = new byte[4096];

        /// <summary>How many bytes were written.</summary>
        internal int Length { get; private set; }

        /// <summary>What was written; the next field may move it.</summary>
        internal Span<byte> Written => bytes.AsSpan(0, Length);

        internal void Byte(byte value) => Take(1)[0] = value;

        internal void Int32(int value) => BinaryPrimitives.WriteInt32LittleEndian(Take(sizeof(int)), value);

        internal void Int64(long value) => BinaryPrimitives.WriteInt64LittleEndian(Take(sizeof(long)), value);

        internal void Double(double value) => Int64(BitConverter.DoubleToInt64Bits(value));

        internal void Float(float value) => Int32(BitConverter.SingleToInt32Bits(value));

        /// <summary>A number of 0 or more: seven bits per byte, the lowest first, the upper bit set in all bytes but the last.</summary>
        internal void Number(ulong value)
        {
            for (; value >= 0x80; value >>= 7)
                Byte((byte)(value | 0x80));
            Byte((byte)value);
        }

        /// <summary>A whole number: 0, -1, 1, -2 ... as the numbers 0, 1, 2, 3 ...</summary>
        internal void Signed(long value) => Number((ulong)((value << 1) ^ (value >> 63)));

        /// <summary>The number of UTF-16 code units, then each as a number: any string comes back exactly, and ASCII takes a byte per letter.</summary>
        internal void Text(string text)
        {
            Number((ulong)text.Length);
            foreach (char unit in text)
                Number(unit);
        }

        /// <summary>How many texts, then the texts.</summary>
        internal void Texts(IReadOnlyList<string> texts)
        {
            Number((ulong)texts.Count);
            foreach (string text in texts)
                Text(text ?? string.Empty);
        }

        Span<byte> Take(int count)
        {
            if (bytes.Length - Length < count)
                Array.Resize(ref bytes, bytes.Length * 2);
            Length += count;
            return bytes.AsSpan(Length - count, count);
        }
    }
}
