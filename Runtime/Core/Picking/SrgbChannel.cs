using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Picking
{
    /// <summary>sRGB's transfer curve (IEC 61966-2-1), 8 bits.</summary>
    static class SrgbChannel
    {
        /// <summary>A colour's red, green and blue as light, 0 to 1 each, in X, Y and Z.</summary>
        internal static VectorMm ToLinear(SegmentColor color) =>
            new VectorMm(ToLinear(color.RedFloat), ToLinear(color.GreenFloat), ToLinear(color.BlueFloat));

        /// <summary>Light as 8 bits; below 0 and above 1 is clamped.</summary>
        internal static byte FromLinear(double linear)
        {
            double clamped = Math.Max(0, Math.Min(1, linear));
            double channel = clamped <= 0.0031308 ? 12.92 * clamped : (1.055 * Math.Pow(clamped, 1 / 2.4)) - 0.055;
            return (byte)Math.Round(channel * 255);
        }

        static double ToLinear(double channel) => channel <= 0.04045 ? channel / 12.92 : Math.Pow((channel + 0.055) / 1.055, 2.4);
    }
}
