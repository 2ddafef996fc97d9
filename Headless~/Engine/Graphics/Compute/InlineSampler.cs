using System;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>Samplers whose name says what they do, such as sampler_LinearClamp or sampler_PointClampU_RepeatV.</summary>
    static class InlineSampler
    {
        static readonly (string Word, TextureWrapMode Mode)[] s_Wraps =
        {
            ("mirroronce", TextureWrapMode.MirrorOnce), ("mirror", TextureWrapMode.Mirror), ("clamp", TextureWrapMode.Clamp), ("repeat",
                TextureWrapMode.Repeat),
        };

        /// <summary>False if the name lacks a filter or a wrap mode.</summary>
        internal static bool TryParse(string name, out SamplerState state)
        {
            state = default;
            var text = name.ToLowerInvariant();
            FilterMode filter;
            if (text.Contains("trilinear"))
                filter = FilterMode.Trilinear;
            else if (text.Contains("linear"))
                filter = FilterMode.Bilinear;
            else if (text.Contains("point"))
                filter = FilterMode.Point;
            else
                return false;
            var all = Wrap(text, "");
            var u = Wrap(text, "u") ?? all;
            var v = Wrap(text, "v") ?? all;
            var w = Wrap(text, "w") ?? all;
            if (u == null && v == null && w == null)
                return false;
            var rest = u ?? v ?? w ?? TextureWrapMode.Repeat;
            state = new SamplerState(filter, u ?? rest, v ?? rest, w ?? rest);
            return true;
        }

        static TextureWrapMode? Wrap(string text, string axis)
        {
            foreach (var (word, mode) in s_Wraps)
            {
                for (var at = text.IndexOf(word, StringComparison.Ordinal); at >= 0; at = text.IndexOf(word, at + 1, StringComparison.Ordinal))
                {
                    var end = at + word.Length;
                    var hasAxis = end < text.Length && "uvw".IndexOf(text[end]) >= 0 && (end + 1 == text.Length || text[end + 1] == '_');
                    // "mirror" is also the start of "mirroronce".
                    if (word == "mirror" && string.CompareOrdinal(text, end, "once", 0, 4) == 0)
                        continue;
                    if (axis.Length == 0 ? !hasAxis : hasAxis && text[end] == axis[0])
                        return mode;
                }
            }
            return null;
        }
    }
}
