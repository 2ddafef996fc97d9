using System;

namespace UnityEngine.Experimental.Rendering
{
    /// <summary>One texel to and from a colour, by the rules of GPUs: no conversion between sRGB and linear, since stored values are what scripts
    /// see.</summary>
    static unsafe class TexelCodec
    {
        internal static Color Read(FormatInfo format, byte* texel)
        {
            var color = new Color(0, 0, 0, 1);
            for (var c = 0; c < format.Channels; c++)
                color[Channel(format, c)] = Read(format, texel, c);
            return color;
        }

        internal static void Write(FormatInfo format, byte* texel, Color color)
        {
            for (var c = 0; c < format.Channels; c++)
                Write(format, texel, c, color[Channel(format, c)]);
        }

        /// <summary>Converts tightly packed texels.</summary>
        internal static void Convert(FormatInfo from, byte* source, FormatInfo to, byte* target, long texels)
        {
            for (long i = 0; i < texels; i++)
                Write(to, target + i * to.BytesPerTexel, Read(from, source + i * from.BytesPerTexel));
        }

        static int Channel(FormatInfo format, int c) => format.IsBlueFirst && c < 3 ? 2 - c : c;

        static float Read(FormatInfo format, byte* texel, int c)
        {
            switch (format.Kind, format.Bits)
            {
                case (ChannelKind.UNorm or ChannelKind.SRGB, 8): return texel[c] / 255f;
                case (ChannelKind.UNorm, 16): return ((ushort*)texel)[c] / 65535f;
                case (ChannelKind.UNorm, 24): return (*(uint*)texel & 0xFFFFFF) / 16777215f;
                case (ChannelKind.SNorm, 8): return Math.Max(((sbyte*)texel)[c] / 127f, -1f);
                case (ChannelKind.SNorm, 16): return Math.Max(((short*)texel)[c] / 32767f, -1f);
                case (ChannelKind.SFloat, 16): return Mathf.HalfToFloat(((ushort*)texel)[c]);
                case (ChannelKind.SFloat, 32): return ((float*)texel)[c];
                case (ChannelKind.UInt, 8): return texel[c];
                case (ChannelKind.UInt, 16): return ((ushort*)texel)[c];
                case (ChannelKind.UInt, 32): return ((uint*)texel)[c];
                case (ChannelKind.SInt, 8): return ((sbyte*)texel)[c];
                case (ChannelKind.SInt, 16): return ((short*)texel)[c];
                case (ChannelKind.SInt, 32): return ((int*)texel)[c];
                default: throw new NotSupportedException(format.Format.ToString());
            }
        }

        static void Write(FormatInfo format, byte* texel, int c, float value)
        {
            switch (format.Kind, format.Bits)
            {
                case (ChannelKind.UNorm or ChannelKind.SRGB, 8): texel[c] = (byte)Round(value, 0, 1, 255); break;
                case (ChannelKind.UNorm, 16): ((ushort*)texel)[c] = (ushort)Round(value, 0, 1, 65535); break;
                case (ChannelKind.UNorm, 24): *(uint*)texel = (uint)Round(value, 0, 1, 16777215); break;
                case (ChannelKind.SNorm, 8): ((sbyte*)texel)[c] = (sbyte)Round(value, -1, 1, 127); break;
                case (ChannelKind.SNorm, 16): ((short*)texel)[c] = (short)Round(value, -1, 1, 32767); break;
                case (ChannelKind.SFloat, 16): ((ushort*)texel)[c] = Mathf.FloatToHalf(value); break;
                case (ChannelKind.SFloat, 32): ((float*)texel)[c] = value; break;
                case (ChannelKind.UInt, 8): texel[c] = (byte)Round(value, 0, byte.MaxValue, 1); break;
                case (ChannelKind.UInt, 16): ((ushort*)texel)[c] = (ushort)Round(value, 0, ushort.MaxValue, 1); break;
                case (ChannelKind.UInt, 32): ((uint*)texel)[c] = (uint)Round(value, 0, uint.MaxValue, 1); break;
                case (ChannelKind.SInt, 8): ((sbyte*)texel)[c] = (sbyte)Round(value, sbyte.MinValue, sbyte.MaxValue, 1); break;
                case (ChannelKind.SInt, 16): ((short*)texel)[c] = (short)Round(value, short.MinValue, short.MaxValue, 1); break;
                case (ChannelKind.SInt, 32): ((int*)texel)[c] = (int)Round(value, int.MinValue, int.MaxValue, 1); break;
                default: throw new NotSupportedException(format.Format.ToString());
            }
        }

        static double Round(double value, double min, double max, double scale) =>
            Math.Round((double.IsNaN(value) ? 0 : Math.Min(Math.Max(value, min), max)) * scale, MidpointRounding.ToEven);
    }
}
