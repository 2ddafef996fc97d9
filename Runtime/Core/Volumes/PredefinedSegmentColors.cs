using System;
using System.Collections.Generic;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Colours for segments whose file gives none: those of 3D Slicer's table of generic anatomy colours, by label or by name, and
    /// beyond the table generated ones that are easily told apart. The same label always has the same colour.
    /// </summary>
    public static class PredefinedSegmentColors
    {
        /// <summary>Successive hues are this share of the circle apart (the golden section), so that no two come near each other soon.</summary>
        const double HueStep = 0.6180339887498949;

        static readonly Dictionary<string, int> LabelOfName = IndexNames();

        /// <summary>The colour of label 0, tissue that no segment claims: the table's entry for it is black, which no light would show.</summary>
        public static SegmentColor Unlabelled { get; } = new SegmentColor(224, 205, 184);

        /// <summary>The colour of a label: <see cref="Unlabelled"/> for 0, 3D Slicer's for 1 to 309, a generated one for any other.</summary>
        public static SegmentColor ForLabel(long label)
        {
            if (label == 0)
                return Unlabelled;
            return label > 0 && label < GenericAnatomyColors.Rows.Length
                ? FromRgb(GenericAnatomyColors.Rows[label].Rgb)
                : Generated(label);
        }

        /// <summary>3D Slicer's colour for a structure's name; upper and lower case, blanks, underscores and hyphens are the same.</summary>
        /// <param name="name">Such as "liver" or "left kidney"; may be null.</param>
        /// <param name="color">Its colour, where the table has the name.</param>
        /// <returns>True when the table has the name.</returns>
        public static bool TryForName(string name, out SegmentColor color)
        {
            bool found = LabelOfName.TryGetValue(Normalised(name), out int label);
            color = found ? ForLabel(label) : default;
            return found;
        }

        static SegmentColor Generated(long label)
        {
            ulong number = unchecked((ulong)label);

            // In two parts, so that labels beyond 2^53 still have different hues.
            double turns = ((number & 0xFFFFFF) * HueStep) + ((number >> 24) * (HueStep * HueStep));
            double hue = turns - Math.Floor(turns);
            double saturation = number % 3 == 0 ? 0.55 : number % 3 == 1 ? 0.75 : 0.4;
            double brightness = number % 2 == 0 ? 0.95 : 0.8;
            return SegmentColor.FromFloats(
                Channel(hue, 5, saturation, brightness), Channel(hue, 3, saturation, brightness), Channel(hue, 1, saturation, brightness));
        }

        /// <summary>One channel of a colour given by hue, saturation and brightness (the usual HSV formula).</summary>
        static double Channel(double hue, int shift, double saturation, double brightness)
        {
            double position = (shift + (hue * 6)) % 6;
            return brightness - (brightness * saturation * Math.Max(0, Math.Min(1, Math.Min(position, 4 - position))));
        }

        static SegmentColor FromRgb(int rgb) => new SegmentColor((byte)(rgb >> 16), (byte)(rgb >> 8), (byte)rgb);

        static Dictionary<string, int> IndexNames()
        {
            var labels = new Dictionary<string, int>(StringComparer.OrdinalIgnoreCase);
            for (int label = 1; label < GenericAnatomyColors.Rows.Length; label++)
                labels.TryAdd(Normalised(GenericAnatomyColors.Rows[label].Name), label);
            return labels;
        }

        static string Normalised(string name) => (name ?? string.Empty).Trim().Replace('_', ' ').Replace('-', ' ');
    }
}
