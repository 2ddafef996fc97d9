using System;

namespace UnityEngine
{
    /// <summary>A rotation. Angles are in degrees, Euler angles are applied in the order z, x, y.</summary>
    [Serializable]
    public struct Quaternion : IEquatable<Quaternion>, IFormattable
    {
        public const float kEpsilon = 1E-06f;

        public float x;
        public float y;
        public float z;
        public float w;

        public Quaternion(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        public static Quaternion identity => new(0f, 0f, 0f, 1f);

        public Quaternion normalized => Normalize(this);

        /// <summary>Euler angles in degrees, each in [0, 360).</summary>
        public Vector3 eulerAngles
        {
            get => EulerAngle.FromRotation(Matrix4x4.Rotate(normalized));
            set => this = Euler(value);
        }

        public float this[int index]
        {
            get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new IndexOutOfRangeException("Invalid Quaternion index!") };
            set
            {
                switch (index)
                {
                    case 0: x = value; break;
                    case 1: y = value; break;
                    case 2: z = value; break;
                    case 3: w = value; break;
                    default: throw new IndexOutOfRangeException("Invalid Quaternion index!");
                }
            }
        }

        public void Set(float newX, float newY, float newZ, float newW) => this = new Quaternion(newX, newY, newZ, newW);

        public void Normalize() => this = Normalize(this);

        public void SetFromToRotation(Vector3 fromDirection, Vector3 toDirection) => this = FromToRotation(fromDirection, toDirection);

        public void SetLookRotation(Vector3 view) => this = LookRotation(view);

        public void SetLookRotation(Vector3 view, Vector3 up) => this = LookRotation(view, up);

        public void ToAngleAxis(out float angle, out Vector3 axis)
        {
            var q = normalized;
            angle = 2f * Mathf.Acos(Mathf.Clamp(q.w, -1f, 1f)) * Mathf.Rad2Deg;
            var v = new Vector3(q.x, q.y, q.z);
            axis = v.magnitude > kEpsilon ? v / v.magnitude : Vector3.right;
        }

        public static Quaternion Normalize(Quaternion q)
        {
            var length = Mathf.Sqrt(Dot(q, q));
            return length < Mathf.Epsilon ? identity : new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
        }

        public static float Dot(Quaternion a, Quaternion b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

        /// <summary>The angle in degrees between two rotations, 0..180.</summary>
        public static float Angle(Quaternion a, Quaternion b)
        {
            var dot = Mathf.Min(Mathf.Abs(Dot(a, b)), 1f);
            return dot > 1f - kEpsilon ? 0f : Mathf.Acos(dot) * 2f * Mathf.Rad2Deg;
        }

        /// <summary>The inverse of a unit quaternion.</summary>
        public static Quaternion Inverse(Quaternion rotation) => new(-rotation.x, -rotation.y, -rotation.z, rotation.w);

        public static Quaternion AngleAxis(float angle, Vector3 axis)
        {
            if (axis.magnitude < Vector3.kEpsilon)
                return identity;
            var half = angle * Mathf.Deg2Rad * 0.5f;
            var v = axis.normalized * Mathf.Sin(half);
            return new Quaternion(v.x, v.y, v.z, Mathf.Cos(half));
        }

        public static Quaternion Euler(Vector3 euler) => Euler(euler.x, euler.y, euler.z);

        /// <summary>Turns by z about z, then x about x, then y about y (degrees, fixed axes).</summary>
        public static Quaternion Euler(float x, float y, float z) =>
            AngleAxis(y, Vector3.up) * AngleAxis(x, Vector3.right) * AngleAxis(z, Vector3.forward);

        public static Quaternion LookRotation(Vector3 forward) => LookRotation(forward, Vector3.up);

        /// <summary>The rotation that takes +z to <paramref name="forward"/> and +y as near as possible to <paramref name="upwards"/>.</summary>
        public static Quaternion LookRotation(Vector3 forward, Vector3 upwards)
        {
            if (forward.magnitude < Vector3.kEpsilon)
            {
                Debug.Log("Look rotation viewing vector is zero");
                return identity;
            }

            var z = forward.normalized;
            var x = Vector3.Cross(upwards, z);
            if (x.magnitude < Vector3.kEpsilon)
                return FromToRotation(Vector3.forward, z);
            x.Normalize();
            return FromAxes(x, Vector3.Cross(z, x), z);
        }

        public static Quaternion FromToRotation(Vector3 fromDirection, Vector3 toDirection)
        {
            Vector3 from = fromDirection.normalized, to = toDirection.normalized;
            if (from == Vector3.zero || to == Vector3.zero)
                return identity;
            var dot = Vector3.Dot(from, to);
            if (dot < -1f + kEpsilon)
                return AngleAxis(180f, Vector3.Orthogonal(from));
            var axis = Vector3.Cross(from, to);
            return Normalize(new Quaternion(axis.x, axis.y, axis.z, 1f + dot));
        }

        public static Quaternion Lerp(Quaternion a, Quaternion b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Quaternion LerpUnclamped(Quaternion a, Quaternion b, float t)
        {
            var sign = Dot(a, b) < 0f ? -1f : 1f;
            return Normalize(Blend(a, 1f - t, b, sign * t));
        }

        public static Quaternion Slerp(Quaternion a, Quaternion b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Quaternion SlerpUnclamped(Quaternion a, Quaternion b, float t)
        {
            var dot = Dot(a, b);
            var sign = dot < 0f ? -1f : 1f;
            dot = Mathf.Abs(dot);
            if (dot > 0.9995f)
                return LerpUnclamped(a, b, t);
            var angle = Mathf.Acos(dot);
            var sine = Mathf.Sin(angle);
            return Blend(a, Mathf.Sin((1f - t) * angle) / sine, b, sign * Mathf.Sin(t * angle) / sine);
        }

        public static Quaternion RotateTowards(Quaternion from, Quaternion to, float maxDegreesDelta)
        {
            var angle = Angle(from, to);
            return angle == 0f ? to : SlerpUnclamped(from, to, Mathf.Min(1f, maxDegreesDelta / angle));
        }

        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);
        public string ToString(string format, IFormatProvider formatProvider) => Format.Tuple(format, formatProvider, "F5", x, y, z, w);
        public override int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2) ^ (z.GetHashCode() >> 2) ^ (w.GetHashCode() >> 1);
        public override bool Equals(object other) => other is Quaternion q && Equals(q);
        public bool Equals(Quaternion other) => x == other.x && y == other.y && z == other.z && w == other.w;

        /// <summary>First <paramref name="rhs"/>, then <paramref name="lhs"/>.</summary>
        public static Quaternion operator *(Quaternion lhs, Quaternion rhs) => new(
            lhs.w * rhs.x + lhs.x * rhs.w + lhs.y * rhs.z - lhs.z * rhs.y,
            lhs.w * rhs.y + lhs.y * rhs.w + lhs.z * rhs.x - lhs.x * rhs.z,
            lhs.w * rhs.z + lhs.z * rhs.w + lhs.x * rhs.y - lhs.y * rhs.x,
            lhs.w * rhs.w - lhs.x * rhs.x - lhs.y * rhs.y - lhs.z * rhs.z);

        public static Vector3 operator *(Quaternion rotation, Vector3 point)
        {
            var axis = new Vector3(rotation.x, rotation.y, rotation.z);
            var twice = 2f * Vector3.Cross(axis, point);
            return point + rotation.w * twice + Vector3.Cross(axis, twice);
        }

        public static bool operator ==(Quaternion lhs, Quaternion rhs) => Dot(lhs, rhs) > 1f - kEpsilon;

        public static bool operator !=(Quaternion lhs, Quaternion rhs) => !(lhs == rhs);

        /// <summary>The rotation whose matrix has these columns (orthonormal, right = up x forward).</summary>
        internal static Quaternion FromAxes(Vector3 right, Vector3 up, Vector3 forward)
        {
            float m00 = right.x, m11 = up.y, m22 = forward.z;
            var trace = m00 + m11 + m22;
            Quaternion q;
            if (trace > 0f)
            {
                var s = Mathf.Sqrt(trace + 1f) * 2f;
                q = new Quaternion((up.z - forward.y) / s, (forward.x - right.z) / s, (right.y - up.x) / s, s / 4f);
            }
            else if (m00 >= m11 && m00 >= m22)
            {
                var s = Mathf.Sqrt(1f + m00 - m11 - m22) * 2f;
                q = new Quaternion(s / 4f, (up.x + right.y) / s, (forward.x + right.z) / s, (up.z - forward.y) / s);
            }
            else if (m11 >= m22)
            {
                var s = Mathf.Sqrt(1f + m11 - m00 - m22) * 2f;
                q = new Quaternion((up.x + right.y) / s, s / 4f, (forward.y + up.z) / s, (forward.x - right.z) / s);
            }
            else
            {
                var s = Mathf.Sqrt(1f + m22 - m00 - m11) * 2f;
                q = new Quaternion((forward.x + right.z) / s, (forward.y + up.z) / s, s / 4f, (right.y - up.x) / s);
            }

            return Normalize(q);
        }

        static Quaternion Blend(Quaternion a, float s, Quaternion b, float t) =>
            new(a.x * s + b.x * t, a.y * s + b.y * t, a.z * s + b.z * t, a.w * s + b.w * t);
    }
}
