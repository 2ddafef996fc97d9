namespace UnityEngine
{
    /// <summary>The checksums of PNG and zlib.</summary>
    static class Checksums
    {
        static readonly uint[] s_Table = Table();

        internal static uint Crc32(byte[] data, int start, int length)
        {
            var crc = uint.MaxValue;
            for (var i = start; i < start + length; i++)
                crc = s_Table[(crc ^ data[i]) & 0xFF] ^ (crc >> 8);
            return ~crc;
        }

        internal static uint Adler32(byte[] data)
        {
            const uint modulus = 65521;
            const int run = 5552; // as long as the sums cannot overflow
            uint a = 1, b = 0;
            for (var start = 0; start < data.Length; start += run)
            {
                var end = System.Math.Min(start + run, data.Length);
                for (var i = start; i < end; i++)
                {
                    a += data[i];
                    b += a;
                }
                a %= modulus;
                b %= modulus;
            }
            return (b << 16) | a;
        }

        static uint[] Table()
        {
            var table = new uint[256];
            for (uint n = 0; n < 256; n++)
            {
                var c = n;
                for (var k = 0; k < 8; k++)
                    c = (c & 1) != 0 ? 0xEDB88320 ^ (c >> 1) : c >> 1;
                table[n] = c;
            }
            return table;
        }
    }
}
