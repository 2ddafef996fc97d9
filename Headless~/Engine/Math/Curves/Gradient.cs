using System;
using System.Linq;

namespace UnityEngine
{
    /// <summary>How a gradient passes from key to key.</summary>
    public enum GradientMode
    {
        Blend = 0,
        Fixed = 1,
        PerceptualBlend = 2,
    }

    /// <summary>A colour at a place of a gradient.</summary>
    public struct GradientColorKey
    {
        public Color color;
        public float time;

        public GradientColorKey(Color col, float time) => (color, this.time) = (col, time);
    }

    /// <summary>An opacity at a place of a gradient.</summary>
    public struct GradientAlphaKey
    {
        public float alpha;
        public float time;

        public GradientAlphaKey(float alpha, float time) => (this.alpha, this.time) = (alpha, time);
    }

    /// <summary>Colours along a line from 0 to 1, by up to eight keys of colour and of opacity each.</summary>
    public class Gradient : IEquatable<Gradient>
    {
        const int MaxKeys = 8;

        GradientColorKey[] m_Colors = { new(Color.white, 0f), new(Color.white, 1f) };
        GradientAlphaKey[] m_Alphas = { new(1f, 0f), new(1f, 1f) };

        public Gradient()
        {
        }

        /// <summary>In order; a copy.</summary>
        public GradientColorKey[] colorKeys
        {
            get => (GradientColorKey[])m_Colors.Clone();
            set => m_Colors = Checked(value, nameof(colorKeys)).OrderBy(k => k.time).ToArray();
        }

        /// <summary>In order; a copy.</summary>
        public GradientAlphaKey[] alphaKeys
        {
            get => (GradientAlphaKey[])m_Alphas.Clone();
            set => m_Alphas = Checked(value, nameof(alphaKeys)).OrderBy(k => k.time).ToArray();
        }

        public GradientMode mode { get; set; } = GradientMode.Blend;

        /// <summary>Data for the Editor: colours are blended as they are.</summary>
        public ColorSpace colorSpace { get; set; } = ColorSpace.Uninitialized;

        public void SetKeys(GradientColorKey[] colorKeys, GradientAlphaKey[] alphaKeys) => (this.colorKeys, this.alphaKeys) = (colorKeys, alphaKeys);

        public Color Evaluate(float time)
        {
            time = Mathf.Clamp01(time);
            var (left, right, part) = Find(m_Colors.Length, i => m_Colors[i].time, time);
            var color = mode == GradientMode.PerceptualBlend ? PerceptualColor.Lerp(m_Colors[left].color, m_Colors[right].color, part)
                : Color.Lerp(m_Colors[left].color, m_Colors[right].color, part);
            (left, right, part) = Find(m_Alphas.Length, i => m_Alphas[i].time, time);
            color.a = Mathf.Lerp(m_Alphas[left].alpha, m_Alphas[right].alpha, part);
            return color;
        }

        public bool Equals(Gradient other) => other is not null && mode == other.mode && m_Colors.SequenceEqual(other.m_Colors)
            && m_Alphas.SequenceEqual(other.m_Alphas);

        public override bool Equals(object o) => o is Gradient other && Equals(other);

        public override int GetHashCode() => m_Colors.Aggregate((int)mode, HashCode.Combine);

        // Between keys the fixed mode has the colour of the next one.
        (int Left, int Right, float Part) Find(int count, Func<int, float> timeOf, float time)
        {
            if (time <= timeOf(0))
                return (0, 0, 0f);
            for (var i = 1; i < count; i++)
                if (time <= timeOf(i))
                    return (i - 1, i, mode == GradientMode.Fixed ? 1f : (time - timeOf(i - 1)) / (timeOf(i) - timeOf(i - 1)));
            return (count - 1, count - 1, 0f);
        }

        static T[] Checked<T>(T[] keys, string name)
        {
            if (keys == null || keys.Length == 0)
                throw new ArgumentException("A gradient has at least one key", name);
            if (keys.Length > MaxKeys)
                throw new ArgumentException($"A gradient has at most {MaxKeys} keys, not {keys.Length}", name);
            return keys;
        }
    }

    /// <summary>Blends colours in Oklab, where equal steps look equal.</summary>
    static class PerceptualColor
    {
        internal static Color Lerp(Color a, Color b, float t) => FromOklab(Vector3.Lerp(ToOklab(a), ToOklab(b), t));

        static Vector3 ToOklab(Color color)
        {
            var c = color.linear;
            var l = Root(0.4122214708f * c.r + 0.5363325363f * c.g + 0.0514459929f * c.b);
            var m = Root(0.2119034982f * c.r + 0.6806995451f * c.g + 0.1073969566f * c.b);
            var s = Root(0.0883024619f * c.r + 0.2817188376f * c.g + 0.6299787005f * c.b);
            return new Vector3(0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s, 1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
                0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s);
        }

        static Color FromOklab(Vector3 lab)
        {
            var l = Cube(lab.x + 0.3963377774f * lab.y + 0.2158037573f * lab.z);
            var m = Cube(lab.x - 0.1055613458f * lab.y - 0.0638541728f * lab.z);
            var s = Cube(lab.x - 0.0894841775f * lab.y - 1.2914855480f * lab.z);
            return new Color(4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s, -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s,
                -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s).gamma;
        }

        static float Root(float value) => Mathf.Pow(value, 1f / 3f);

        static float Cube(float value) => value * value * value;
    }
}
