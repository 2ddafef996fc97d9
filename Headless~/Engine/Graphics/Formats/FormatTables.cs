using System.Collections.Generic;

namespace UnityEngine.Experimental.Rendering
{
    /// <summary>Which formats the older enums stand for.</summary>
    static class FormatTables
    {
        static readonly Dictionary<TextureFormat, GraphicsFormat> s_Textures = new()
        {
            [TextureFormat.Alpha8] = GraphicsFormat.R8_UNorm,
            [TextureFormat.R8] = GraphicsFormat.R8_UNorm,
            [TextureFormat.RG16] = GraphicsFormat.R8G8_UNorm,
            [TextureFormat.RGB24] = GraphicsFormat.R8G8B8_UNorm,
            [TextureFormat.RGBA32] = GraphicsFormat.R8G8B8A8_UNorm,
            [TextureFormat.BGRA32] = GraphicsFormat.B8G8R8A8_UNorm,
            [TextureFormat.R16] = GraphicsFormat.R16_UNorm,
            [TextureFormat.RG32] = GraphicsFormat.R16G16_UNorm,
            [TextureFormat.RGB48] = GraphicsFormat.R16G16B16_UNorm,
            [TextureFormat.RGBA64] = GraphicsFormat.R16G16B16A16_UNorm,
            [TextureFormat.RHalf] = GraphicsFormat.R16_SFloat,
            [TextureFormat.RGHalf] = GraphicsFormat.R16G16_SFloat,
            [TextureFormat.RGBAHalf] = GraphicsFormat.R16G16B16A16_SFloat,
            [TextureFormat.RFloat] = GraphicsFormat.R32_SFloat,
            [TextureFormat.RGFloat] = GraphicsFormat.R32G32_SFloat,
            [TextureFormat.RGBAFloat] = GraphicsFormat.R32G32B32A32_SFloat,
        };

        static readonly Dictionary<RenderTextureFormat, GraphicsFormat> s_RenderTextures = new()
        {
            [RenderTextureFormat.Default] = GraphicsFormat.R8G8B8A8_UNorm,
            [RenderTextureFormat.ARGB32] = GraphicsFormat.R8G8B8A8_UNorm,
            [RenderTextureFormat.BGRA32] = GraphicsFormat.B8G8R8A8_UNorm,
            [RenderTextureFormat.DefaultHDR] = GraphicsFormat.R16G16B16A16_SFloat,
            [RenderTextureFormat.ARGBHalf] = GraphicsFormat.R16G16B16A16_SFloat,
            [RenderTextureFormat.ARGBFloat] = GraphicsFormat.R32G32B32A32_SFloat,
            [RenderTextureFormat.ARGB64] = GraphicsFormat.R16G16B16A16_UNorm,
            [RenderTextureFormat.ARGBInt] = GraphicsFormat.R32G32B32A32_SInt,
            [RenderTextureFormat.RFloat] = GraphicsFormat.R32_SFloat,
            [RenderTextureFormat.RGFloat] = GraphicsFormat.R32G32_SFloat,
            [RenderTextureFormat.RHalf] = GraphicsFormat.R16_SFloat,
            [RenderTextureFormat.RGHalf] = GraphicsFormat.R16G16_SFloat,
            [RenderTextureFormat.RInt] = GraphicsFormat.R32_SInt,
            [RenderTextureFormat.RGInt] = GraphicsFormat.R32G32_SInt,
            [RenderTextureFormat.R8] = GraphicsFormat.R8_UNorm,
            [RenderTextureFormat.RG16] = GraphicsFormat.R8G8_UNorm,
            [RenderTextureFormat.R16] = GraphicsFormat.R16_UNorm,
            [RenderTextureFormat.RG32] = GraphicsFormat.R16G16_UNorm,
        };

        internal static GraphicsFormat Of(TextureFormat format, bool srgb) =>
            s_Textures.TryGetValue(format, out var found) ? srgb ? ToSRGB(found) : found : GraphicsFormat.None;

        internal static GraphicsFormat Of(RenderTextureFormat format, bool srgb) =>
            s_RenderTextures.TryGetValue(format, out var found) ? srgb ? ToSRGB(found) : found : GraphicsFormat.None;

        /// <summary>The older enum's value; 0, which is none, if it has no such format.</summary>
        internal static TextureFormat ToTextureFormat(GraphicsFormat format)
        {
            format = ToLinear(format);
            foreach (var (key, value) in s_Textures)
                if (value == format && key != TextureFormat.Alpha8)
                    return key;
            return default;
        }

        internal static RenderTextureFormat ToRenderTextureFormat(GraphicsFormat format)
        {
            format = ToLinear(format);
            foreach (var (key, value) in s_RenderTextures)
                if (value == format && key is not (RenderTextureFormat.Default or RenderTextureFormat.DefaultHDR))
                    return key;
            return RenderTextureFormat.ARGB32;
        }

        internal static GraphicsFormat ToSRGB(GraphicsFormat format) => format switch
        {
            GraphicsFormat.R8_UNorm => GraphicsFormat.R8_SRGB,
            GraphicsFormat.R8G8_UNorm => GraphicsFormat.R8G8_SRGB,
            GraphicsFormat.R8G8B8_UNorm => GraphicsFormat.R8G8B8_SRGB,
            GraphicsFormat.R8G8B8A8_UNorm => GraphicsFormat.R8G8B8A8_SRGB,
            GraphicsFormat.B8G8R8_UNorm => GraphicsFormat.B8G8R8_SRGB,
            GraphicsFormat.B8G8R8A8_UNorm => GraphicsFormat.B8G8R8A8_SRGB,
            _ => format,
        };

        internal static GraphicsFormat ToLinear(GraphicsFormat format) => format switch
        {
            GraphicsFormat.R8_SRGB => GraphicsFormat.R8_UNorm,
            GraphicsFormat.R8G8_SRGB => GraphicsFormat.R8G8_UNorm,
            GraphicsFormat.R8G8B8_SRGB => GraphicsFormat.R8G8B8_UNorm,
            GraphicsFormat.R8G8B8A8_SRGB => GraphicsFormat.R8G8B8A8_UNorm,
            GraphicsFormat.B8G8R8_SRGB => GraphicsFormat.B8G8R8_UNorm,
            GraphicsFormat.B8G8R8A8_SRGB => GraphicsFormat.B8G8R8A8_UNorm,
            _ => format,
        };
    }
}
