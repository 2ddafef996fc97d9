using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text.RegularExpressions;
using UnityEngine.Vulkan;

namespace UnityEngine.Experimental.Rendering
{
    /// <summary>How a format's channels are to be read.</summary>
    enum ChannelKind
    {
        UNorm,
        SNorm,
        UInt,
        SInt,
        SFloat,
        SRGB,
    }

    /// <summary>
    /// What is known of an uncompressed colour format whose channels all have the same size, or of a depth format (its depth); read from the format's name.
    /// </summary>
    sealed class FormatInfo
    {
        static readonly Dictionary<GraphicsFormat, FormatInfo> s_Known = new();

        FormatInfo(GraphicsFormat format, int channels, int bits, ChannelKind kind, bool blueFirst, uint vulkan, bool depth = false)
        {
            Format = format;
            Channels = channels;
            Bits = bits;
            Kind = kind;
            IsBlueFirst = blueFirst;
            Vulkan = vulkan;
            IsDepth = depth;
        }

        internal GraphicsFormat Format { get; }

        internal int Channels { get; }

        /// <summary>Bits per channel.</summary>
        internal int Bits { get; }

        internal ChannelKind Kind { get; }

        internal bool IsBlueFirst { get; }

        /// <summary>The VkFormat.</summary>
        internal uint Vulkan { get; }

        internal bool IsDepth { get; }

        /// <summary>24 bits of depth are copied as 32, the upper eight undefined.</summary>
        internal int BytesPerTexel => Bits == 24 ? 4 : Channels * Bits / 8;

        internal bool IsInteger => Kind is ChannelKind.UInt or ChannelKind.SInt;

        /// <summary>The format's row, or null if the host does not know the format.</summary>
        internal static FormatInfo Of(GraphicsFormat format)
        {
            lock (s_Known)
            {
                if (!s_Known.TryGetValue(format, out var info))
                {
                    info = Parse(format);
                    s_Known.Add(format, info);
                }
                return info;
            }
        }

        static FormatInfo Parse(GraphicsFormat format)
        {
            if (Depth(format) is { } depth)
                return depth;
            var match = Regex.Match(format.ToString(), @"^(?<channels>[RGBA]\d+(?:[RGBA]\d+)*)_(?<kind>UNorm|SNorm|UInt|SInt|SFloat|SRGB)$");
            if (!match.Success || !Enum.TryParse(match.Groups["kind"].Value, out ChannelKind kind))
                return null;
            var channels = Regex.Matches(match.Groups["channels"].Value, @"([RGBA])(\d+)");
            var order = "";
            var bits = int.Parse(channels[0].Groups[2].Value, CultureInfo.InvariantCulture);
            foreach (Match channel in channels)
            {
                if (int.Parse(channel.Groups[2].Value, CultureInfo.InvariantCulture) != bits)
                    return null;
                order += channel.Groups[1].Value;
            }
            var vulkan = VulkanFormat(order, bits, kind);
            return vulkan == 0 ? null : new FormatInfo(format, channels.Count, bits, kind, order[0] == 'B', vulkan);
        }

        static FormatInfo Depth(GraphicsFormat format)
        {
            var (bits, vulkan) = format switch
            {
                GraphicsFormat.D16_UNorm => (16, Vk.VK_FORMAT_D16_UNORM),
                GraphicsFormat.D16_UNorm_S8_UInt => (16, Vk.VK_FORMAT_D16_UNORM_S8_UINT),
                GraphicsFormat.D24_UNorm => (24, Vk.VK_FORMAT_X8_D24_UNORM_PACK32),
                GraphicsFormat.D24_UNorm_S8_UInt => (24, Vk.VK_FORMAT_D24_UNORM_S8_UINT),
                GraphicsFormat.D32_SFloat => (32, Vk.VK_FORMAT_D32_SFLOAT),
                GraphicsFormat.D32_SFloat_S8_UInt => (32, Vk.VK_FORMAT_D32_SFLOAT_S8_UINT),
                _ => (0, 0u),
            };
            return bits == 0 ? null : new FormatInfo(format, 1, bits, bits == 32 ? ChannelKind.SFloat : ChannelKind.UNorm, false, vulkan, depth: true);
        }

        static uint VulkanFormat(string order, int bits, ChannelKind kind)
        {
            // vulkan_core.h numbers the formats of one channel layout in a row: UNORM SNORM USCALED SSCALED UINT SINT (SRGB | SFLOAT).
            uint first = (order, bits) switch
            {
                ("R", 8) => 9, ("RG", 8) => 16, ("RGB", 8) => 23, ("BGR", 8) => 30, ("RGBA", 8) => 37, ("BGRA", 8) => 44,
                ("R", 16) => 70, ("RG", 16) => 77, ("RGB", 16) => 84, ("RGBA", 16) => 91,
                ("R", 32) => 98, ("RG", 32) => 101, ("RGB", 32) => 104, ("RGBA", 32) => 107,
                _ => 0,
            };
            if (first == 0)
                return 0;
            if (bits == 32)
                return kind switch { ChannelKind.UInt => first, ChannelKind.SInt => first + 1, ChannelKind.SFloat => first + 2, _ => 0 };
            return kind switch
            {
                ChannelKind.UNorm => first,
                ChannelKind.SNorm => first + 1,
                ChannelKind.UInt => first + 4,
                ChannelKind.SInt => first + 5,
                ChannelKind.SRGB when bits == 8 => first + 6,
                ChannelKind.SFloat when bits == 16 => first + 6,
                _ => 0,
            };
        }
    }
}
