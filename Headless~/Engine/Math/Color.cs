using System;

namespace UnityEngine
{
    /// <summary>Red, green, blue, alpha as floats, nominally 0..1.</summary>
    [Serializable]
    public struct Color : IEquatable<Color>, IFormattable
    {
        public float r;
        public float g;
        public float b;
        public float a;

        public Color(float r, float g, float b, float a)
        {
            this.r = r;
            this.g = g;
            this.b = b;
            this.a = a;
        }

        public Color(float r, float g, float b) : this(r, g, b, 1f)
        {
        }

        public static Color black => new(0f, 0f, 0f);
        public static Color white => new(1f, 1f, 1f);
        public static Color red => new(1f, 0f, 0f);
        public static Color green => new(0f, 1f, 0f);
        public static Color blue => new(0f, 0f, 1f);
        public static Color cyan => new(0f, 1f, 1f);
        public static Color magenta => new(1f, 0f, 1f);
        public static Color gray => new(0.5f, 0.5f, 0.5f);
        public static Color grey => gray;
        public static Color clear => new(0f, 0f, 0f, 0f);

        /// <summary>Unity's yellow, which is not quite (1, 1, 0).</summary>
        public static Color yellow => new(1f, 235f / 255f, 4f / 255f);

        public float grayscale => 0.299f * r + 0.587f * g + 0.114f * b;

        /// <summary>The colour if these components are sRGB; alpha stays.</summary>
        public Color linear => new(Mathf.GammaToLinearSpace(r), Mathf.GammaToLinearSpace(g), Mathf.GammaToLinearSpace(b), a);

        /// <summary>The sRGB components of this linear colour; alpha stays.</summary>
        public Color gamma => new(Mathf.LinearToGammaSpace(r), Mathf.LinearToGammaSpace(g), Mathf.LinearToGammaSpace(b), a);

        public float maxColorComponent => Mathf.Max(Mathf.Max(r, g), b);

        public float this[int index]
        {
            get => index switch { 0 => r, 1 => g, 2 => b, 3 => a, _ => throw new IndexOutOfRangeException($"Invalid Color index({index})!") };
            set
            {
                switch (index)
                {
                    case 0: r = value; break;
                    case 1: g = value; break;
                    case 2: b = value; break;
                    case 3: a = value; break;
                    default: throw new IndexOutOfRangeException($"Invalid Color index({index})!");
                }
            }
        }

        public static Color Lerp(Color a, Color b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));
        public static Color LerpUnclamped(Color a, Color b, float t) => a + (b - a) * t;

        /// <summary>Hue, saturation and value, each 0..1.</summary>
        public static void RGBToHSV(Color rgbColor, out float H, out float S, out float V)
        {
            V = rgbColor.maxColorComponent;
            var range = V - Mathf.Min(Mathf.Min(rgbColor.r, rgbColor.g), rgbColor.b);
            S = V == 0f ? 0f : range / V;
            H = 0f;
            if (range == 0f)
                return;
            if (rgbColor.r == V)
                H = (rgbColor.g - rgbColor.b) / range / 6f;
            else if (rgbColor.g == V)
                H = (2f + (rgbColor.b - rgbColor.r) / range) / 6f;
            else
                H = (4f + (rgbColor.r - rgbColor.g) / range) / 6f;
            if (H < 0f)
                H += 1f;
        }

        public static Color HSVToRGB(float H, float S, float V) => HSVToRGB(H, S, V, true);

        /// <summary>Colour from hue, saturation, value (0..1); without <paramref name="hdr"/> the result is clamped to 0..1.</summary>
        public static Color HSVToRGB(float H, float S, float V, bool hdr)
        {
            float Channel(float n)
            {
                var k = (n + H * 6f) % 6f;
                var c = V - V * S * Mathf.Max(0f, Mathf.Min(Mathf.Min(k, 4f - k), 1f));
                return hdr ? c : Mathf.Clamp01(c);
            }

            return new Color(Channel(5f), Channel(3f), Channel(1f));
        }

        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);
        public string ToString(string format, IFormatProvider formatProvider) => "RGBA" + Format.Tuple(format, formatProvider, "F3", r, g, b, a);
        public override int GetHashCode() => ((Vector4)this).GetHashCode();
        public override bool Equals(object other) => other is Color c && Equals(c);
        public bool Equals(Color other) => r == other.r && g == other.g && b == other.b && a == other.a;

        public static Color operator +(Color a, Color b) => new(a.r + b.r, a.g + b.g, a.b + b.b, a.a + b.a);
        public static Color operator -(Color a, Color b) => new(a.r - b.r, a.g - b.g, a.b - b.b, a.a - b.a);
        public static Color operator *(Color a, Color b) => new(a.r * b.r, a.g * b.g, a.b * b.b, a.a * b.a);
        public static Color operator *(Color a, float b) => new(a.r * b, a.g * b, a.b * b, a.a * b);
        public static Color operator *(float b, Color a) => a * b;
        public static Color operator /(Color a, float b) => new(a.r / b, a.g / b, a.b / b, a.a / b);
        public static bool operator ==(Color lhs, Color rhs) => (Vector4)lhs == (Vector4)rhs;
        public static bool operator !=(Color lhs, Color rhs) => !(lhs == rhs);
        public static implicit operator Vector4(Color c) => new(c.r, c.g, c.b, c.a);
        public static implicit operator Color(Vector4 v) => new(v.x, v.y, v.z, v.w);
    }
}
