using System;

namespace UnityEngine.Experimental.Rendering
{
    /// <summary>Questions about formats. Works on any thread. Formats that the host does not know (compressed, packed, depth) answer 0 or false.</summary>
    public class GraphicsFormatUtility
    {
        /// <summary>Bytes of one texel.</summary>
        public static uint GetBlockSize(GraphicsFormat format) => (uint)(FormatInfo.Of(format)?.BytesPerTexel ?? 0);

        /// <summary>Bytes of one texel.</summary>
        public static uint GetBlockSize(TextureFormat format) => GetBlockSize(FormatTables.Of(format, false));

        public static uint GetComponentCount(GraphicsFormat format) => (uint)(FormatInfo.Of(format)?.Channels ?? 0);

        public static GraphicsFormat GetGraphicsFormat(TextureFormat format, bool isSRGB) => FormatTables.Of(format, isSRGB);

        public static GraphicsFormat GetGraphicsFormat(RenderTextureFormat format, bool isSRGB) => FormatTables.Of(format, isSRGB);

        public static GraphicsFormat GetGraphicsFormat(RenderTextureFormat format, RenderTextureReadWrite readWrite) =>
            FormatTables.Of(format, readWrite is RenderTextureReadWrite.sRGB or RenderTextureReadWrite.Default);

        public static TextureFormat GetTextureFormat(GraphicsFormat format) => FormatTables.ToTextureFormat(format);

        public static RenderTextureFormat GetRenderTextureFormat(GraphicsFormat format) => FormatTables.ToRenderTextureFormat(format);

        public static GraphicsFormat GetLinearFormat(GraphicsFormat format) => FormatTables.ToLinear(format);

        public static GraphicsFormat GetSRGBFormat(GraphicsFormat format) => FormatTables.ToSRGB(format);

        public static string GetFormatString(GraphicsFormat format) => format.ToString();

        public static bool IsSRGBFormat(GraphicsFormat format) => Is(format, ChannelKind.SRGB);

        public static bool IsUNormFormat(GraphicsFormat format) => Is(format, ChannelKind.UNorm);

        public static bool IsSNormFormat(GraphicsFormat format) => Is(format, ChannelKind.SNorm);

        public static bool IsUIntFormat(GraphicsFormat format) => Is(format, ChannelKind.UInt);

        public static bool IsSIntFormat(GraphicsFormat format) => Is(format, ChannelKind.SInt);

        public static bool IsIntegerFormat(GraphicsFormat format) => FormatInfo.Of(format)?.IsInteger ?? false;

        public static bool IsHalfFormat(GraphicsFormat format) => FormatInfo.Of(format) is { Kind: ChannelKind.SFloat, Bits: 16 };

        public static bool IsFloatFormat(GraphicsFormat format) => FormatInfo.Of(format) is { Kind: ChannelKind.SFloat, Bits: 32 };

        public static bool HasAlphaChannel(GraphicsFormat format) => FormatInfo.Of(format) is { Channels: 4 };

        /// <summary>Bytes of one mip level.</summary>
        public static uint ComputeMipmapSize(int width, int height, GraphicsFormat format) => ComputeMipmapSize(width, height, 1, format);

        /// <summary>Bytes of one mip level.</summary>
        /// <exception cref="OverflowException">More than 4 GiB.</exception>
        public static uint ComputeMipmapSize(int width, int height, int depth, GraphicsFormat format) =>
            checked((uint)((long)width * height * depth * GetBlockSize(format)));

        static bool Is(GraphicsFormat format, ChannelKind kind) => FormatInfo.Of(format)?.Kind == kind;
    }
}
