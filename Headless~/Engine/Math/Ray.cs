using System;
using System.Globalization;

namespace UnityEngine
{
    /// <summary>A half-line; its direction always has length 1.</summary>
    [Serializable]
    public struct Ray : IFormattable
    {
        Vector3 m_Origin;
        Vector3 m_Direction;

        public Ray(Vector3 origin, Vector3 direction)
        {
            m_Origin = origin;
            m_Direction = direction.normalized;
        }

        public Vector3 origin { get => m_Origin; set => m_Origin = value; }

        public Vector3 direction { get => m_Direction; set => m_Direction = value.normalized; }

        public Vector3 GetPoint(float distance) => m_Origin + m_Direction * distance;

        public override string ToString() => ToString(null, null);

        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F2" : format;
            formatProvider ??= CultureInfo.InvariantCulture.NumberFormat;
            return $"Origin: {m_Origin.ToString(format, formatProvider)}, Dir: {m_Direction.ToString(format, formatProvider)}";
        }
    }
}
