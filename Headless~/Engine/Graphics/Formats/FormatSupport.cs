using UnityEngine.Vulkan;

namespace UnityEngine.Experimental.Rendering
{
    /// <summary>From Vulkan's format features to Unity's usages.</summary>
    static class FormatSupport
    {
        static readonly (GraphicsFormatUsage Usage, uint Features)[] s_Needs =
        {
            (GraphicsFormatUsage.Sample, Vk.VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT),
            (GraphicsFormatUsage.Linear, Vk.VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT),
            (GraphicsFormatUsage.Render, Vk.VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT),
            (GraphicsFormatUsage.Blend, Vk.VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT),
            (GraphicsFormatUsage.LoadStore, Vk.VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT),
            (GraphicsFormatUsage.GetPixels, Vk.VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT),
            (GraphicsFormatUsage.SetPixels, Vk.VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT),
            (GraphicsFormatUsage.SetPixels32, Vk.VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT),
            (GraphicsFormatUsage.ReadPixels, Vk.VK_FORMAT_FEATURE_TRANSFER_SRC_BIT),
        };

        static readonly (GraphicsFormatUsage Usage, uint Samples)[] s_Multisampling =
        {
            (GraphicsFormatUsage.MSAA2x, 2), (GraphicsFormatUsage.MSAA4x, 4), (GraphicsFormatUsage.MSAA8x, 8),
        };

        /// <param name="features">What Vulkan says of the format.</param>
        /// <param name="info">The format.</param>
        /// <param name="usage">What it is to be used for.</param>
        /// <param name="sampleCounts">One bit per number of samples that a target of this kind can have.</param>
        internal static bool Covers(uint features, FormatInfo info, GraphicsFormatUsage usage, uint sampleCounts)
        {
            if (info.IsDepth && (usage & (GraphicsFormatUsage.Blend | GraphicsFormatUsage.LoadStore)) != 0)
                return false;
            if (info.Kind == ChannelKind.SRGB && (usage & GraphicsFormatUsage.LoadStore) != 0)
                return false;
            var left = usage;
            foreach (var (known, needed) in s_Needs)
            {
                if ((usage & known) == 0)
                    continue;
                var feature = info.IsDepth && known == GraphicsFormatUsage.Render ? Vk.VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT : needed;
                if ((features & feature) != feature)
                    return false;
                left &= ~known;
            }
            foreach (var (known, samples) in s_Multisampling)
            {
                if ((usage & known) == 0)
                    continue;
                if ((sampleCounts & samples) == 0)
                    return false;
                left &= ~known;
            }
            // Sparse and stencil use do not exist in this host.
            return left == 0 && features != 0;
        }

        /// <summary>The next format that holds the same values: more channels, then more bits. None at the end.</summary>
        internal static GraphicsFormat Wider(GraphicsFormat format) => format switch
        {
            GraphicsFormat.R8_UNorm or GraphicsFormat.R8G8_UNorm => GraphicsFormat.R8G8B8A8_UNorm,
            GraphicsFormat.R8_SNorm or GraphicsFormat.R8G8_SNorm => GraphicsFormat.R8G8B8A8_SNorm,
            GraphicsFormat.R8_UInt or GraphicsFormat.R16_UInt => GraphicsFormat.R32_UInt,
            GraphicsFormat.R8_SInt or GraphicsFormat.R16_SInt => GraphicsFormat.R32_SInt,
            GraphicsFormat.R16_UNorm or GraphicsFormat.R16_SNorm => GraphicsFormat.R32_SFloat,
            GraphicsFormat.R16_SFloat => GraphicsFormat.R32_SFloat,
            GraphicsFormat.R16G16_SFloat => GraphicsFormat.R16G16B16A16_SFloat,
            GraphicsFormat.R32_SFloat or GraphicsFormat.R32G32_SFloat => GraphicsFormat.R32G32B32A32_SFloat,
            _ => GraphicsFormat.None,
        };
    }
}
