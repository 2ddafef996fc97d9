using System;

namespace UnityEngine.Experimental.Rendering
{
    /// <summary>Questions about formats. Works on any thread, but for the depth formats of a device. Formats that the host does not know (compressed,
    /// packed) answer 0 or false.</summary>
    public class GraphicsFormatUtility
    {
        static readonly (int Bits, GraphicsFormat Plain, GraphicsFormat Stencil)[] s_DepthFormats =
        {
            (16, GraphicsFormat.D16_UNorm, GraphicsFormat.D16_UNorm_S8_UInt), (24, GraphicsFormat.D24_UNorm, GraphicsFormat.D24_UNorm_S8_UInt),
            (32, GraphicsFormat.D32_SFloat, GraphicsFormat.D32_SFloat_S8_UInt),
        };

        /// <summary>Bytes of one texel.</summary>
        public static uint GetBlockSize(GraphicsFormat format) => (uint)(FormatInfo.Of(format)?.BytesPerTexel ?? 0);

        /// <summary>Bytes of one texel.</summary>
        public static uint GetBlockSize(TextureFormat format) => GetBlockSize(FormatTables.Of(format, false));

        public static uint GetComponentCount(GraphicsFormat format) => (uint)(FormatInfo.Of(format)?.Channels ?? 0);

        public static GraphicsFormat GetGraphicsFormat(TextureFormat format, bool isSRGB) => FormatTables.Of(format, isSRGB);

        public static GraphicsFormat GetGraphicsFormat(RenderTextureFormat format, bool isSRGB) => FormatTables.Of(format, isSRGB);

        public static GraphicsFormat GetGraphicsFormat(RenderTextureFormat format, RenderTextureReadWrite readWrite) =>
            FormatTables.Of(format, readWrite == RenderTextureReadWrite.sRGB || (readWrite == RenderTextureReadWrite.Default && ColorSpaces.IsLinear));

        /// <summary>Bits of depth; 0 for a format without.</summary>
        public static int GetDepthBits(GraphicsFormat format) => FormatInfo.Of(format) is { IsDepth: true } info ? info.Bits : 0;

        /// <summary>The device's depth format of at least so many bits, with stencil above 16.</summary>
        public static GraphicsFormat GetDepthStencilFormat(int depthBits) => GetDepthStencilFormat(depthBits, depthBits > 16 ? 8 : 0);

        /// <summary>The device's smallest format of at least so many bits of depth and stencil; None if both are 0, or there is none.</summary>
        public static GraphicsFormat GetDepthStencilFormat(int minimumDepthBits, int minimumStencilBits)
        {
            if (minimumDepthBits <= 0 && minimumStencilBits <= 0)
                return GraphicsFormat.None;
            foreach (var (bits, plain, stencil) in s_DepthFormats)
            {
                var format = minimumStencilBits > 0 ? stencil : plain;
                if (bits >= minimumDepthBits && SystemInfo.IsFormatSupported(format, GraphicsFormatUsage.Render))
                    return format;
            }
            return GraphicsFormat.None;
        }

        public static bool IsDepthFormat(GraphicsFormat format) => FormatInfo.Of(format) is { IsDepth: true };

        public static bool IsStencilFormat(GraphicsFormat format) => format is GraphicsFormat.S8_UInt || IsDepthStencilFormat(format);

        /// <summary>Whether it has both depth and stencil.</summary>
        public static bool IsDepthStencilFormat(GraphicsFormat format) =>
            format is GraphicsFormat.D16_UNorm_S8_UInt or GraphicsFormat.D24_UNorm_S8_UInt or GraphicsFormat.D32_SFloat_S8_UInt;

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
