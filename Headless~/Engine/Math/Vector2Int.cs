using System;

namespace UnityEngine
{
    /// <summary>Two integers.</summary>
    [Serializable]
    public struct Vector2Int : IEquatable<Vector2Int>, IFormattable
    {
        int m_X;
        int m_Y;

        public Vector2Int(int x, int y)
        {
            m_X = x;
            m_Y = y;
        }

        public int x { get => m_X; set => m_X = value; }
        public int y { get => m_Y; set => m_Y = value; }

        public static Vector2Int zero => new(0, 0);
        public static Vector2Int one => new(1, 1);
        public static Vector2Int up => new(0, 1);
        public static Vector2Int down => new(0, -1);
        public static Vector2Int left => new(-1, 0);
        public static Vector2Int right => new(1, 0);

        public float magnitude => MathF.Sqrt(sqrMagnitude);
        public int sqrMagnitude => m_X * m_X + m_Y * m_Y;

        public int this[int index]
        {
            get => index switch { 0 => m_X, 1 => m_Y, _ => throw new IndexOutOfRangeException($"Invalid Vector2Int index addressed: {index}!") };
            set
            {
                switch (index)
                {
                    case 0: m_X = value; break;
                    case 1: m_Y = value; break;
                    default: throw new IndexOutOfRangeException($"Invalid Vector2Int index addressed: {index}!");
                }
            }
        }

        public void Set(int x, int y) => this = new Vector2Int(x, y);

        public void Scale(Vector2Int scale) => this = Scale(this, scale);

        public void Clamp(Vector2Int min, Vector2Int max) => this = Max(min, Min(max, this));

        public static float Distance(Vector2Int a, Vector2Int b) => (a - b).magnitude;
        public static Vector2Int Min(Vector2Int lhs, Vector2Int rhs) => new(Math.Min(lhs.x, rhs.x), Math.Min(lhs.y, rhs.y));
        public static Vector2Int Max(Vector2Int lhs, Vector2Int rhs) => new(Math.Max(lhs.x, rhs.x), Math.Max(lhs.y, rhs.y));
        public static Vector2Int Scale(Vector2Int a, Vector2Int b) => new(a.x * b.x, a.y * b.y);
        public static Vector2Int FloorToInt(Vector2 v) => new(Mathf.FloorToInt(v.x), Mathf.FloorToInt(v.y));
        public static Vector2Int CeilToInt(Vector2 v) => new(Mathf.CeilToInt(v.x), Mathf.CeilToInt(v.y));
        public static Vector2Int RoundToInt(Vector2 v) => new(Mathf.RoundToInt(v.x), Mathf.RoundToInt(v.y));

        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);
        public string ToString(string format, IFormatProvider formatProvider) => Format.Tuple(format, formatProvider, m_X, m_Y);
        public override int GetHashCode() => HashCode.Combine(m_X, m_Y);
        public override bool Equals(object other) => other is Vector2Int v && Equals(v);
        public bool Equals(Vector2Int other) => this == other;

        public static Vector2Int operator +(Vector2Int a, Vector2Int b) => new(a.x + b.x, a.y + b.y);
        public static Vector2Int operator -(Vector2Int a, Vector2Int b) => new(a.x - b.x, a.y - b.y);
        public static Vector2Int operator -(Vector2Int v) => new(-v.x, -v.y);
        public static Vector2Int operator *(Vector2Int a, Vector2Int b) => Scale(a, b);
        public static Vector2Int operator *(Vector2Int a, int b) => new(a.x * b, a.y * b);
        public static Vector2Int operator *(int a, Vector2Int b) => b * a;
        public static Vector2Int operator /(Vector2Int a, int b) => new(a.x / b, a.y / b);
        public static bool operator ==(Vector2Int lhs, Vector2Int rhs) => lhs.m_X == rhs.m_X && lhs.m_Y == rhs.m_Y;
        public static bool operator !=(Vector2Int lhs, Vector2Int rhs) => !(lhs == rhs);
        public static implicit operator Vector2(Vector2Int v) => new(v.x, v.y);
        public static explicit operator Vector3Int(Vector2Int v) => new(v.x, v.y, 0);
    }
}
