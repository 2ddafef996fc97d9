using System;
using System.Globalization;

namespace UnityEngine
{
    /// <summary>The points p with dot(normal, p) + distance = 0.</summary>
    [Serializable]
    public struct Plane : IFormattable
    {
        Vector3 m_Normal;
        float m_Distance;

        public Plane(Vector3 inNormal, Vector3 inPoint)
        {
            m_Normal = inNormal.normalized;
            m_Distance = -Vector3.Dot(m_Normal, inPoint);
        }

        public Plane(Vector3 inNormal, float d)
        {
            m_Normal = inNormal.normalized;
            m_Distance = d;
        }

        /// <summary>Through three points, clockwise as seen from the side that the normal points to.</summary>
        public Plane(Vector3 a, Vector3 b, Vector3 c)
        {
            m_Normal = Vector3.Cross(b - a, c - a).normalized;
            m_Distance = -Vector3.Dot(m_Normal, a);
        }

        public Vector3 normal { get => m_Normal; set => m_Normal = value; }

        public float distance { get => m_Distance; set => m_Distance = value; }

        public Plane flipped => new(-m_Normal, -m_Distance);

        public void SetNormalAndPosition(Vector3 inNormal, Vector3 inPoint) => this = new Plane(inNormal, inPoint);

        public void Set3Points(Vector3 a, Vector3 b, Vector3 c) => this = new Plane(a, b, c);

        public void Flip() => this = flipped;

        /// <summary>Moves the plane by MINUS the translation along its normal, as Unity does.</summary>
        public void Translate(Vector3 translation) => m_Distance += Vector3.Dot(m_Normal, translation);

        public static Plane Translate(Plane plane, Vector3 translation)
        {
            plane.Translate(translation);
            return plane;
        }

        public Vector3 ClosestPointOnPlane(Vector3 point) => point - m_Normal * GetDistanceToPoint(point);

        /// <summary>Signed distance, positive on the side of the normal.</summary>
        public float GetDistanceToPoint(Vector3 point) => Vector3.Dot(m_Normal, point) + m_Distance;

        public bool GetSide(Vector3 point) => GetDistanceToPoint(point) > 0f;

        public bool SameSide(Vector3 inPt0, Vector3 inPt1)
        {
            float a = GetDistanceToPoint(inPt0), b = GetDistanceToPoint(inPt1);
            return (a > 0f && b > 0f) || (a <= 0f && b <= 0f);
        }

        /// <summary>Where the ray's line meets the plane; negative and false behind the ray's origin, 0 and false for a parallel one.</summary>
        public bool Raycast(Ray ray, out float enter)
        {
            var slope = Vector3.Dot(ray.direction, m_Normal);
            if (Mathf.Approximately(slope, 0f))
            {
                enter = 0f;
                return false;
            }

            enter = -GetDistanceToPoint(ray.origin) / slope;
            return enter > 0f;
        }

        public override string ToString() => ToString(null, null);

        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F2" : format;
            formatProvider ??= CultureInfo.InvariantCulture.NumberFormat;
            return $"(normal:{m_Normal.ToString(format, formatProvider)}, distance:{m_Distance.ToString(format, formatProvider)})";
        }
    }
}
