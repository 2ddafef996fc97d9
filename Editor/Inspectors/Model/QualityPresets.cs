using System;
using System.Linq;

namespace AnatomyCarve.Editor
{
    /// <summary>The presets of <see cref="RenderQuality"/> as a menu shows them, and which one some values are.</summary>
    static class QualityPresets
    {
        /// <summary>The names of the presets, then "Custom".</summary>
        public static readonly string[] Menu = RenderQuality.Names.Select(Capitalised).Append("Custom").ToArray();

        static readonly RenderQuality[] Presets = RenderQuality.Names.Select(RenderQuality.Named).ToArray();

        /// <summary>The menu's last entry: values that are no preset's.</summary>
        public static int Custom => Presets.Length;

        /// <summary>A preset by its place in the menu.</summary>
        public static RenderQuality At(int index) => Presets[index];

        /// <summary>The menu's entry for a quality's values.</summary>
        public static int IndexOf(RenderQuality quality)
        {
            int index = Array.FindIndex(Presets, preset => Same(preset, quality));
            return index < 0 ? Custom : index;
        }

        static bool Same(RenderQuality a, RenderQuality b) => a.Step == b.Step && a.CutMode == b.CutMode && a.AntiAliasing == b.AntiAliasing
            && a.OpaqueAlpha == b.OpaqueAlpha && a.FirstVisibleAlpha == b.FirstVisibleAlpha && a.Filter == b.Filter;

        static string Capitalised(string name) => char.ToUpperInvariant(name[0]) + name.Substring(1);
    }
}
