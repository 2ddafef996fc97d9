using System;

namespace UnityEngine
{
    /// <summary>Three floats; Unity's space is left-handed, y up, z forward.</summary>
    [Serializable]
    public struct Vector3 : IEquatable<Vector3>, IFormattable
    {
        public const float kEpsilon = 1E-05f;
        public const float kEpsilonNormalSqrt = 1E-15f;

        public float x;
        public float y;
        public float z;

        public Vector3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        public Vector3(float x, float y) : this(x, y, 0f)
        {
        }

        public static Vector3 zero => new(0f, 0f, 0f);
        public static Vector3 one => new(1f, 1f, 1f);
        public static Vector3 forward => new(0f, 0f, 1f);
        public static Vector3 back => new(0f, 0f, -1f);
        public static Vector3 up => new(0f, 1f, 0f);
        public static Vector3 down => new(0f, -1f, 0f);
        public static Vector3 left => new(-1f, 0f, 0f);
        public static Vector3 right => new(1f, 0f, 0f);
        public static Vector3 positiveInfinity => new(float.PositiveInfinity, float.PositiveInfinity, float.PositiveInfinity);
        public static Vector3 negativeInfinity => new(float.NegativeInfinity, float.NegativeInfinity, float.NegativeInfinity);

        public float magnitude => MathF.Sqrt(x * x + y * y + z * z);
        public float sqrMagnitude => x * x + y * y + z * z;

        /// <summary>The vector at length 1; zero if it is shorter than <see cref="kEpsilon"/>.</summary>
        public Vector3 normalized => Normalize(this);

        public float this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new IndexOutOfRangeException("Invalid Vector3 index!") };
            set
            {
                switch (index)
                {
                    case 0: x = value; break;
                    case 1: y = value; break;
                    case 2: z = value; break;
                    default: throw new IndexOutOfRangeException("Invalid Vector3 index!");
                }
            }
        }

        public void Set(float newX, float newY, float newZ) => this = new Vector3(newX, newY, newZ);

        public void Scale(Vector3 scale) => this = Scale(this, scale);

        public void Normalize() => this = Normalize(this);

        public static Vector3 Normalize(Vector3 value)
        {
            var length = value.magnitude;
            return length > kEpsilon ? value / length : zero;
        }

        public static float Magnitude(Vector3 vector) => vector.magnitude;
        public static float SqrMagnitude(Vector3 vector) => vector.sqrMagnitude;
        public static float Dot(Vector3 lhs, Vector3 rhs) => lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z;
        public static float Distance(Vector3 a, Vector3 b) => (a - b).magnitude;
        public static Vector3 Scale(Vector3 a, Vector3 b) => new(a.x * b.x, a.y * b.y, a.z * b.z);
        public static Vector3 Min(Vector3 lhs, Vector3 rhs) => new(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y), Mathf.Min(lhs.z, rhs.z));
        public static Vector3 Max(Vector3 lhs, Vector3 rhs) => new(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y), Mathf.Max(lhs.z, rhs.z));
        public static Vector3 Lerp(Vector3 a, Vector3 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Vector3 LerpUnclamped(Vector3 a, Vector3 b, float t) =>
            new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t);

        public static Vector3 Cross(Vector3 lhs, Vector3 rhs) =>
            new(lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);

        public static Vector3 Reflect(Vector3 inDirection, Vector3 inNormal) => inDirection - 2f * Dot(inNormal, inDirection) * inNormal;

        public static Vector3 Project(Vector3 vector, Vector3 onNormal)
        {
            var square = onNormal.sqrMagnitude;
            return square < Mathf.Epsilon ? zero : onNormal * (Dot(vector, onNormal) / square);
        }

        public static Vector3 ProjectOnPlane(Vector3 vector, Vector3 planeNormal) => vector - Project(vector, planeNormal);

        public static Vector3 ClampMagnitude(Vector3 vector, float maxLength) =>
            vector.sqrMagnitude > maxLength * maxLength ? vector / vector.magnitude * maxLength : vector;

        public static Vector3 MoveTowards(Vector3 current, Vector3 target, float maxDistanceDelta)
        {
            var way = target - current;
            var distance = way.magnitude;
            return distance == 0f || (maxDistanceDelta >= 0f && distance <= maxDistanceDelta) ? target : current + way / distance * maxDistanceDelta;
        }

        /// <summary>Unsigned angle in degrees, 0..180; 0 if a vector is too short to have a direction.</summary>
        public static float Angle(Vector3 from, Vector3 to)
        {
            var scale = MathF.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
            return scale < kEpsilonNormalSqrt ? 0f : MathF.Acos(Mathf.Clamp(Dot(from, to) / scale, -1f, 1f)) * Mathf.Rad2Deg;
        }

        /// <summary>Angle in degrees; its sign is that of the turn about <paramref name="axis"/>.</summary>
        public static float SignedAngle(Vector3 from, Vector3 to, Vector3 axis) => Angle(from, to) * Mathf.Sign(Dot(axis, Cross(from, to)));

        /// <summary>Interpolates direction on the sphere and length linearly.</summary>
        public static Vector3 Slerp(Vector3 a, Vector3 b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Vector3 SlerpUnclamped(Vector3 a, Vector3 b, float t)
        {
            float lengthA = a.magnitude, lengthB = b.magnitude;
            if (lengthA < kEpsilon || lengthB < kEpsilon)
                return LerpUnclamped(a, b, t);
            Vector3 from = a / lengthA, to = b / lengthB;
            var angle = MathF.Acos(Mathf.Clamp(Dot(from, to), -1f, 1f));
            var side = to - from * Dot(from, to);
            // Opposite or equal directions span no plane: any perpendicular one serves.
            side = side.magnitude > kEpsilon ? side.normalized : Orthogonal(from);
            return (from * MathF.Cos(angle * t) + side * MathF.Sin(angle * t)) * Mathf.LerpUnclamped(lengthA, lengthB, t);
        }

        public static Vector3 RotateTowards(Vector3 current, Vector3 target, float maxRadiansDelta, float maxMagnitudeDelta)
        {
            float from = current.magnitude, to = target.magnitude;
            if (from < kEpsilon || to < kEpsilon)
                return MoveTowards(current, target, maxMagnitudeDelta);
            var angle = Angle(current, target) * Mathf.Deg2Rad;
            var share = angle < kEpsilon ? 1f : Mathf.Min(1f, maxRadiansDelta / angle);
            return SlerpUnclamped(current / from, target / to, share) * Mathf.MoveTowards(from, to, maxMagnitudeDelta);
        }

        public static void OrthoNormalize(ref Vector3 normal, ref Vector3 tangent)
        {
            normal = normal.magnitude > kEpsilon ? normal.normalized : right;
            tangent -= normal * Dot(normal, tangent);
            tangent = tangent.magnitude > kEpsilon ? tangent.normalized : Orthogonal(normal);
        }

        public static void OrthoNormalize(ref Vector3 normal, ref Vector3 tangent, ref Vector3 binormal)
        {
            OrthoNormalize(ref normal, ref tangent);
            binormal -= normal * Dot(normal, binormal) + tangent * Dot(tangent, binormal);
            binormal = binormal.magnitude > kEpsilon ? binormal.normalized : Cross(normal, tangent);
        }

        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);
        public string ToString(string format, IFormatProvider formatProvider) => Format.Tuple(format, formatProvider, "F2", x, y, z);
        public override int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2) ^ (z.GetHashCode() >> 2);
        public override bool Equals(object other) => other is Vector3 v && Equals(v);
        public bool Equals(Vector3 other) => x == other.x && y == other.y && z == other.z;

        public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.x - b.x, a.y - b.y, a.z - b.z);
        public static Vector3 operator -(Vector3 a) => new(-a.x, -a.y, -a.z);
        public static Vector3 operator *(Vector3 a, float d) => new(a.x * d, a.y * d, a.z * d);
        public static Vector3 operator *(float d, Vector3 a) => new(a.x * d, a.y * d, a.z * d);
        public static Vector3 operator /(Vector3 a, float d) => new(a.x / d, a.y / d, a.z / d);
        public static bool operator ==(Vector3 lhs, Vector3 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
        public static bool operator !=(Vector3 lhs, Vector3 rhs) => !(lhs == rhs);

        /// <summary>Some unit vector at right angles to the unit vector <paramref name="v"/>.</summary>
        internal static Vector3 Orthogonal(Vector3 v) => (MathF.Abs(v.z) > 0.7f ? new Vector3(0f, -v.z, v.y) : new Vector3(-v.y, v.x, 0f)).normalized;
    }
}
