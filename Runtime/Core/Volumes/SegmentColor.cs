using System;
using System.Globalization;

namespace AnatomyCarve.Volumes
{
    /// <summary>A segment's colour: sRGB, 8 bits per channel, as files and tables give it.</summary>
    public readonly struct SegmentColor : IEquatable<SegmentColor>
    {
        /// <summary>Red, 0 to 255, sRGB.</summary>
        public readonly byte R;

        /// <summary>Green, 0 to 255, sRGB.</summary>
        public readonly byte G;

        /// <summary>Blue, 0 to 255, sRGB.</summary>
        public readonly byte B;

        /// <summary>Makes a colour from its three sRGB channels.</summary>
        public SegmentColor(byte r, byte g, byte b)
        {
            R = r;
            G = g;
            B = b;
        }

        /// <summary>Red, 0 to 1, sRGB.</summary>
        public float RedFloat => R / 255f;

        /// <summary>Green, 0 to 1, sRGB.</summary>
        public float GreenFloat => G / 255f;

        /// <summary>Blue, 0 to 1, sRGB.</summary>
        public float BlueFloat => B / 255f;

        /// <summary>Equal in every channel.</summary>
        public static bool operator ==(SegmentColor a, SegmentColor b) => a.Equals(b);

        /// <summary>Different in at least one channel.</summary>
        public static bool operator !=(SegmentColor a, SegmentColor b) => !a.Equals(b);

        /// <summary>The nearest 8-bit colour to three sRGB channels of 0 to 1; values outside are clamped.</summary>
        /// <exception cref="ArgumentException">A channel is NaN.</exception>
        public static SegmentColor FromFloats(double red, double green, double blue) =>
            new SegmentColor(ToByte(red, nameof(red)), ToByte(green, nameof(green)), ToByte(blue, nameof(blue)));

        /// <inheritdoc/>
        public bool Equals(SegmentColor other) => R == other.R && G == other.G && B == other.B;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is SegmentColor other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => (R << 16) | (G << 8) | B;

        /// <summary>"#RRGGBB".</summary>
        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "#{0:X2}{1:X2}{2:X2}", R, G, B);

        static byte ToByte(double channel, string name)
        {
            if (double.IsNaN(channel))
                throw new ArgumentException("A colour's channel is a number of 0 to 1, not NaN.", name);
            return (byte)Math.Round(Math.Max(0, Math.Min(1, channel)) * 255, MidpointRounding.AwayFromZero);
        }
    }
}
