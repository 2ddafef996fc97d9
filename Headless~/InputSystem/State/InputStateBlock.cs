using System;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem.LowLevel
{
    /// <summary>Where a control's state lies in that of its device, and in which form.</summary>
    public unsafe struct InputStateBlock
    {
        public const uint InvalidOffset = 0xffffffff;

        public const uint AutomaticOffset = 0xfffffffe;

        public static readonly FourCC FormatInvalid = new(0);
        public static readonly FourCC FormatInt = new('I', 'N', 'T', ' ');
        public static readonly FourCC FormatUInt = new('U', 'I', 'N', 'T');
        public static readonly FourCC FormatShort = new('S', 'H', 'R', 'T');
        public static readonly FourCC FormatUShort = new('U', 'S', 'H', 'T');
        public static readonly FourCC FormatByte = new('B', 'Y', 'T', 'E');
        public static readonly FourCC FormatFloat = new('F', 'L', 'T', ' ');
        public static readonly FourCC FormatVector2 = new('V', 'E', 'C', '2');
        public static readonly FourCC FormatVector3 = new('V', 'E', 'C', '3');
        public static readonly FourCC FormatQuaternion = new('Q', 'U', 'A', 'T');
        public static readonly FourCC FormatBit = new('B', 'I', 'T');

        /// <summary>Kind of the memory.</summary>
        public FourCC format { get; set; }

        /// <summary>From the beginning of the device's state.</summary>
        public uint byteOffset { get; set; }

        /// <summary>Within the byte at <see cref="byteOffset"/>.</summary>
        public uint bitOffset { get; set; }

        public uint sizeInBits { get; set; }

        internal readonly uint SizeInBytes => (bitOffset + sizeInBits + 7) / 8;

        /// <summary>Integers are taken to 0..1, signed ones to -1..1; bits to 0..1.</summary>
        public float ReadFloat(void* statePtr)
        {
            var at = (byte*)statePtr + byteOffset;
            if (format == FormatFloat)
                return *(float*)at;
            if (format == FormatBit)
                return sizeInBits == 1 ? ReadBits(statePtr) : ReadBits(statePtr) / (float)((1u << (int)sizeInBits) - 1);
            if (format == FormatByte)
                return *at / (float)byte.MaxValue;
            if (format == FormatUShort)
                return *(ushort*)at / (float)ushort.MaxValue;
            if (format == FormatUInt)
                return *(uint*)at / (float)uint.MaxValue;
            if (format == FormatShort)
                return Mathf.Max(*(short*)at / (float)short.MaxValue, -1f);
            if (format == FormatInt)
                return Mathf.Max(*(int*)at / (float)int.MaxValue, -1f);
            throw Unknown();
        }

        public void WriteFloat(void* statePtr, float value)
        {
            var at = (byte*)statePtr + byteOffset;
            if (format == FormatFloat)
                *(float*)at = value;
            else if (format == FormatBit)
                WriteBits(statePtr, sizeInBits == 1 ? value >= 0.5f ? 1u : 0u : (uint)Mathf.RoundToInt(value * ((1u << (int)sizeInBits) - 1)));
            else if (format == FormatByte)
                *at = (byte)Mathf.RoundToInt(value * byte.MaxValue);
            else if (format == FormatUShort)
                *(ushort*)at = (ushort)Mathf.RoundToInt(value * ushort.MaxValue);
            else if (format == FormatShort)
                *(short*)at = (short)Mathf.RoundToInt(value * short.MaxValue);
            else
                throw Unknown();
        }

        public int ReadInt(void* statePtr)
        {
            var at = (byte*)statePtr + byteOffset;
            if (format == FormatBit)
                return (int)ReadBits(statePtr);
            if (format == FormatByte)
                return *at;
            if (format == FormatUShort)
                return *(ushort*)at;
            if (format == FormatShort)
                return *(short*)at;
            if (format == FormatInt || format == FormatUInt)
                return *(int*)at;
            throw Unknown();
        }

        public void WriteInt(void* statePtr, int value)
        {
            var at = (byte*)statePtr + byteOffset;
            if (format == FormatBit)
                WriteBits(statePtr, (uint)value);
            else if (format == FormatByte)
                *at = (byte)value;
            else if (format == FormatUShort)
                *(ushort*)at = (ushort)value;
            else if (format == FormatShort)
                *(short*)at = (short)value;
            else if (format == FormatInt || format == FormatUInt)
                *(int*)at = value;
            else
                throw Unknown();
        }

        /// <summary>0 for formats without a size of their own.</summary>
        internal static uint SizeOf(FourCC format) =>
            format == FormatBit ? 1u
            : format == FormatByte ? 8u
            : format == FormatShort || format == FormatUShort ? 16u
            : format == FormatInt || format == FormatUInt || format == FormatFloat ? 32u
            : format == FormatVector2 ? 64u
            : format == FormatVector3 ? 96u
            : format == FormatQuaternion ? 128u
            : 0u;

        /// <summary><see cref="FormatInvalid"/> for other types.</summary>
        internal static FourCC FormatOf(Type type) =>
            type == typeof(float) ? FormatFloat
            : type == typeof(int) ? FormatInt
            : type == typeof(uint) ? FormatUInt
            : type == typeof(short) ? FormatShort
            : type == typeof(ushort) ? FormatUShort
            : type == typeof(byte) || type == typeof(bool) ? FormatByte
            : type == typeof(Vector2) ? FormatVector2
            : type == typeof(Vector3) ? FormatVector3
            : type == typeof(Quaternion) ? FormatQuaternion
            : FormatInvalid;

        /// <summary>Whether this part of two states is the same, bit by bit.</summary>
        internal readonly bool SameIn(byte* a, byte* b)
        {
            if (bitOffset == 0 && sizeInBits % 8 == 0)
                return new ReadOnlySpan<byte>(a + byteOffset, (int)(sizeInBits / 8)).SequenceEqual(new ReadOnlySpan<byte>(b + byteOffset, (int)(sizeInBits / 8)));
            for (uint bit = bitOffset; bit < bitOffset + sizeInBits; bit++)
                if (((a[byteOffset + bit / 8] ^ b[byteOffset + bit / 8]) & (1 << (int)(bit % 8))) != 0)
                    return false;
            return true;
        }

        readonly uint ReadBits(void* statePtr)
        {
            var at = (byte*)statePtr + byteOffset;
            var value = 0u;
            for (uint bit = 0; bit < sizeInBits; bit++)
                if ((at[(bitOffset + bit) / 8] & (1 << (int)((bitOffset + bit) % 8))) != 0)
                    value |= 1u << (int)bit;
            return value;
        }

        readonly void WriteBits(void* statePtr, uint value)
        {
            var at = (byte*)statePtr + byteOffset;
            for (uint bit = 0; bit < sizeInBits; bit++)
            {
                var mask = (byte)(1 << (int)((bitOffset + bit) % 8));
                if ((value & (1u << (int)bit)) != 0)
                    at[(bitOffset + bit) / 8] |= mask;
                else
                    at[(bitOffset + bit) / 8] &= (byte)~mask;
            }
        }

        readonly NotSupportedException Unknown() => new($"State of format '{format}' cannot be read or written as a number");
    }
}
