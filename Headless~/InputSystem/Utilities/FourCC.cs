using System;

namespace UnityEngine.InputSystem.Utilities
{
    /// <summary>Four characters in an int, the first one in the highest byte: the name of a memory format.</summary>
    public struct FourCC : IEquatable<FourCC>
    {
        readonly int m_Code;

        public FourCC(int code) => m_Code = code;

        public FourCC(char a, char b = ' ', char c = ' ', char d = ' ') => m_Code = (a << 24) | (b << 16) | (c << 8) | d;

        /// <exception cref="ArgumentException">The text has no or more than four characters.</exception>
        public FourCC(string str) : this()
        {
            if (str == null)
                throw new ArgumentNullException(nameof(str));
            if (str.Length is < 1 or > 4)
                throw new ArgumentException("FourCC string must be one to four characters long!", nameof(str));
            var padded = str.PadRight(4);
            m_Code = new FourCC(padded[0], padded[1], padded[2], padded[3]).m_Code;
        }

        public static implicit operator int(FourCC fourCC) => fourCC.m_Code;

        public static implicit operator FourCC(int i) => new(i);

        public static bool operator ==(FourCC left, FourCC right) => left.m_Code == right.m_Code;

        public static bool operator !=(FourCC left, FourCC right) => left.m_Code != right.m_Code;

        public static FourCC FromInt32(int i) => i;

        public static int ToInt32(FourCC fourCC) => fourCC.m_Code;

        public bool Equals(FourCC other) => m_Code == other.m_Code;

        public override bool Equals(object obj) => obj is FourCC other && Equals(other);

        public override int GetHashCode() => m_Code;

        public override string ToString() =>
            $"{(char)((m_Code >> 24) & 0xff)}{(char)((m_Code >> 16) & 0xff)}{(char)((m_Code >> 8) & 0xff)}{(char)(m_Code & 0xff)}";
    }
}
