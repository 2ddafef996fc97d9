using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Headless.DemoData
{
    /// <summary>
    /// Colours by anatomy: a range of hues for each lobe, a hue of its own for each deep grey nucleus, left and right alike but the
    /// right a little darker.
    /// </summary>
    sealed class Palette
    {
        sealed record Family(string Name, double FirstHue, double LastHue, double Saturation, double Value, params string[] Prefixes);

        // The first family whose prefix fits takes a region; the last one takes the rest.
        static readonly Family[] Families =
        [
            new("cerebellum", 192, 224, .45, .86, "Cerebelum", "Vermis"),
            new("hippocampus", 92, 92, .70, .86, "Hippocampus"),
            new("amygdala", 350, 350, .62, .86, "Amygdala"),
            new("caudate", 208, 208, .66, .95, "Caudate"),
            new("putamen", 262, 262, .45, .88, "Putamen"),
            new("pallidum", 318, 318, .40, .90, "Pallidum"),
            new("thalamus", 45, 45, .75, .98, "Thalamus"),
            new("insula", 178, 178, .50, .86, "Insula"),
            new("limbic", 308, 334, .45, .84, "Cingulum", "ParaHippocampal"),
            new("occipital", 236, 282, .42, .84, "Calcarine", "Cuneus", "Lingual", "Occipital", "Fusiform"),
            new("temporal", 96, 148, .44, .82, "Temporal", "Heschl"),
            new("parietal", 40, 64, .50, .90, "Postcentral", "Parietal", "SupraMarginal", "Angular", "Precuneus", "Paracentral"),
            new("frontal", 2, 32, .48, .90, ""),
        ];

        readonly Dictionary<string, List<string>> regionsOfFamily = [];

        public Palette(IEnumerable<string> names)
        {
            foreach (var name in names.Where(IsRegion))
            {
                var family = FamilyOf(name).Name;
                if (!regionsOfFamily.TryGetValue(family, out var regions)) regionsOfFamily[family] = regions = [];
                if (!regions.Contains(WithoutSide(name))) regions.Add(WithoutSide(name));
            }
        }

        /// <summary>The sRGB colour of the segment of this name.</summary>
        public SegmentColor ColorOf(string name)
        {
            switch (name)
            {
                case "head": return new SegmentColor(222, 174, 141);
                case "brain, other": return new SegmentColor(238, 226, 200);
            }

            var family = FamilyOf(name);
            var regions = regionsOfFamily[family.Name];
            var place = regions.IndexOf(WithoutSide(name));
            var share = regions.Count == 1 ? 0 : (double)place / (regions.Count - 1);
            // Neighbours in the list are often neighbours in the brain: they differ in brightness and strength too.
            var strength = regions.Count == 1 ? 1 : (place % 2 == 0 ? .88 : 1.12);
            var brightness = regions.Count == 1 ? 1 : 1.05 - .11 * (place % 3);
            var side = name.EndsWith("_R", StringComparison.Ordinal) ? .94 : 1;
            return FromHsv(
                family.FirstHue + share * (family.LastHue - family.FirstHue),
                family.Saturation * strength,
                Math.Min(family.Value * brightness * side, 1));
        }

        static bool IsRegion(string name) => name is not ("head" or "brain, other");

        static Family FamilyOf(string name) =>
            Families.First(family => family.Prefixes.Any(prefix => name.StartsWith(prefix, StringComparison.Ordinal)));

        static string WithoutSide(string name) => name.EndsWith("_L", StringComparison.Ordinal)
            || name.EndsWith("_R", StringComparison.Ordinal) ? name[..^2] : name;

        static SegmentColor FromHsv(double hueDegrees, double saturation, double value)
        {
            byte Channel(double shift)
            {
                var sector = (shift + hueDegrees / 60) % 6;
                var level = value - value * saturation * Math.Clamp(Math.Min(sector, 4 - sector), 0, 1);
                return (byte)Math.Round(level * 255);
            }

            return new SegmentColor(Channel(5), Channel(3), Channel(1));
        }
    }
}
