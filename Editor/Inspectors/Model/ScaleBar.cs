using System;
using System.Globalization;

namespace AnatomyCarve.Editor
{
    /// <summary>The length of a picture's millimetre scale: 1, 2 or 5 times a power of ten, as long as its room allows.</summary>
    readonly struct ScaleBar
    {
        /// <param name="mmPerPixel">Millimetres in a pixel: above 0.</param>
        /// <param name="longestPixels">The room that there is, pixels: above 0.</param>
        public ScaleBar(double mmPerPixel, double longestPixels)
        {
            if (!(mmPerPixel > 0) || !(longestPixels > 0) || double.IsInfinity(mmPerPixel) || double.IsInfinity(longestPixels))
                throw new ArgumentException(FormattableString.Invariant($"A scale needs room: {longestPixels} pixels of {mmPerPixel} mm."), nameof(mmPerPixel));
            double room = mmPerPixel * longestPixels, power = Math.Pow(10, Math.Floor(Math.Log10(room)));
            LengthMm = room >= 5 * power ? 5 * power : room >= 2 * power ? 2 * power : power;
            Pixels = (float)(LengthMm / mmPerPixel);
            Text = LengthMm.ToString("0.######", CultureInfo.InvariantCulture) + " mm";
        }

        public double LengthMm { get; }

        /// <summary>The bar's length in the picture.</summary>
        public float Pixels { get; }

        /// <summary>What is written beside it, such as "50 mm".</summary>
        public string Text { get; }
    }
}
