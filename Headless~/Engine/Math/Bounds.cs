using System;
using System.Globalization;

namespace UnityEngine
{
    /// <summary>An axis-aligned box.</summary>
    [Serializable]
    public struct Bounds : IEquatable<Bounds>, IFormattable
    {
        Vector3 m_Center;
        Vector3 m_Extents;

        public Bounds(Vector3 center, Vector3 size)
        {
            m_Center = center;
            m_Extents = size * 0.5f;
        }

        public Vector3 center { get => m_Center; set => m_Center = value; }

        public Vector3 size { get => m_Extents * 2f; set => m_Extents = value * 0.5f; }

        /// <summary>Half the size.</summary>
        public Vector3 extents { get => m_Extents; set => m_Extents = value; }

        public Vector3 min { get => m_Center - m_Extents; set => SetMinMax(value, max); }

        public Vector3 max { get => m_Center + m_Extents; set => SetMinMax(min, value); }

        public void SetMinMax(Vector3 min, Vector3 max)
        {
            m_Extents = (max - min) * 0.5f;
            m_Center = min + m_Extents;
        }

        public void Encapsulate(Vector3 point) => SetMinMax(Vector3.Min(min, point), Vector3.Max(max, point));

        public void Encapsulate(Bounds bounds)
        {
            Encapsulate(bounds.min);
            Encapsulate(bounds.max);
        }

        /// <summary>Makes the size larger by the amount.</summary>
        public void Expand(float amount) => m_Extents += Vector3.one * (amount * 0.5f);

        public void Expand(Vector3 amount) => m_Extents += amount * 0.5f;

        public bool Intersects(Bounds bounds)
        {
            Vector3 a = min, b = max, c = bounds.min, d = bounds.max;
            return a.x <= d.x && b.x >= c.x && a.y <= d.y && b.y >= c.y && a.z <= d.z && b.z >= c.z;
        }

        public bool Contains(Vector3 point)
        {
            Vector3 a = min, b = max;
            return point.x >= a.x && point.x <= b.x && point.y >= a.y && point.y <= b.y && point.z >= a.z && point.z <= b.z;
        }

        public Vector3 ClosestPoint(Vector3 point) => Vector3.Max(min, Vector3.Min(max, point));

        public float SqrDistance(Vector3 point) => (ClosestPoint(point) - point).sqrMagnitude;

        public bool IntersectRay(Ray ray) => IntersectRay(ray, out _);

        /// <summary>The distance at which the ray enters; negative if it starts inside.</summary>
        public bool IntersectRay(Ray ray, out float distance)
        {
            float near = float.NegativeInfinity, far = float.PositiveInfinity;
            distance = 0f;
            for (var axis = 0; axis < 3; axis++)
            {
                float a = min[axis] - ray.origin[axis], b = max[axis] - ray.origin[axis], d = ray.direction[axis];
                if (d == 0f)
                {
                    if (a > 0f || b < 0f)
                        return false;
                    continue;
                }

                near = Math.Max(near, Math.Min(a / d, b / d));
                far = Math.Min(far, Math.Max(a / d, b / d));
            }

            if (near > far || far < 0f)
                return false;
            distance = near;
            return true;
        }

        public override string ToString() => ToString(null, null);

        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F2" : format;
            formatProvider ??= CultureInfo.InvariantCulture.NumberFormat;
            return $"Center: {m_Center.ToString(format, formatProvider)}, Extents: {m_Extents.ToString(format, formatProvider)}";
        }

        public override int GetHashCode() => m_Center.GetHashCode() ^ (m_Extents.GetHashCode() << 2);

        public override bool Equals(object other) => other is Bounds b && Equals(b);

        public bool Equals(Bounds other) => m_Center.Equals(other.m_Center) && m_Extents.Equals(other.m_Extents);

        public static bool operator ==(Bounds lhs, Bounds rhs) => lhs.m_Center == rhs.m_Center && lhs.m_Extents == rhs.m_Extents;

        public static bool operator !=(Bounds lhs, Bounds rhs) => !(lhs == rhs);
    }
}
