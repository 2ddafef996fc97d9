using System;

namespace UnityEngine
{
    public partial struct Matrix4x4
    {
        public float determinant => (float)DeterminantOf(this);

        /// <summary>The inverse; the zero matrix if there is none.</summary>
        public Matrix4x4 inverse => InverseOf(this);

        /// <summary>The rotation of a matrix without skew and projection.</summary>
        public Quaternion rotation
        {
            get
            {
                Vector3 y = GetColumn(1), z = GetColumn(2);
                return Quaternion.LookRotation(z, y);
            }
        }

        /// <summary>The lengths of the columns; x is negative for a mirroring matrix.</summary>
        public Vector3 lossyScale
        {
            get
            {
                var x = ((Vector3)GetColumn(0)).magnitude;
                return new Vector3(determinant < 0f ? -x : x, ((Vector3)GetColumn(1)).magnitude, ((Vector3)GetColumn(2)).magnitude);
            }
        }

        public Vector3 GetPosition() => new(m03, m13, m23);

        public void SetTRS(Vector3 pos, Quaternion q, Vector3 s) => this = TRS(pos, q, s);

        /// <summary>True if this is a product of translation, rotation and scale: last row (0,0,0,1), columns at right angles.</summary>
        public bool ValidTRS()
        {
            if (m30 != 0f || m31 != 0f || m32 != 0f || m33 != 1f)
                return false;
            Vector3 x = ((Vector3)GetColumn(0)).normalized, y = ((Vector3)GetColumn(1)).normalized, z = ((Vector3)GetColumn(2)).normalized;
            const float tolerance = 1E-4f;
            return Math.Abs(Vector3.Dot(x, y)) < tolerance && Math.Abs(Vector3.Dot(y, z)) < tolerance && Math.Abs(Vector3.Dot(z, x)) < tolerance;
        }

        /// <summary>The plane carried along; its distance is right only for matrices without scale, as in Unity.</summary>
        public Plane TransformPlane(Plane plane)
        {
            var back = inverse;
            float x = plane.normal.x, y = plane.normal.y, z = plane.normal.z, w = plane.distance;
            return new Plane(
                new Vector3(
                    back.m00 * x + back.m10 * y + back.m20 * z + back.m30 * w,
                    back.m01 * x + back.m11 * y + back.m21 * z + back.m31 * w,
                    back.m02 * x + back.m12 * y + back.m22 * z + back.m32 * w),
                back.m03 * x + back.m13 * y + back.m23 * z + back.m33 * w);
        }

        public static float Determinant(Matrix4x4 m) => m.determinant;

        public static Matrix4x4 Inverse(Matrix4x4 m) => m.inverse;

        public static Matrix4x4 Transpose(Matrix4x4 m) => m.transpose;

        /// <summary>Inverts an affine matrix.</summary>
        /// <returns>False, with the zero matrix, if it is singular.</returns>
        public static bool Inverse3DAffine(Matrix4x4 input, ref Matrix4x4 result)
        {
            input.SetRow(3, new Vector4(0f, 0f, 0f, 1f));
            result = input.inverse;
            return result.m33 != 0f;
        }

        public static Matrix4x4 Scale(Vector3 vector) => TRS(Vector3.zero, Quaternion.identity, vector);

        public static Matrix4x4 Translate(Vector3 vector) => TRS(vector, Quaternion.identity, Vector3.one);

        public static Matrix4x4 Rotate(Quaternion q) => TRS(Vector3.zero, q, Vector3.one);

        /// <summary>Translation * rotation * scale.</summary>
        public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s)
        {
            float x = q.x * 2f, y = q.y * 2f, z = q.z * 2f;
            float xx = q.x * x, yy = q.y * y, zz = q.z * z;
            float xy = q.x * y, xz = q.x * z, yz = q.y * z;
            float wx = q.w * x, wy = q.w * y, wz = q.w * z;
            return new Matrix4x4(
                new Vector4(1f - (yy + zz), xy + wz, xz - wy, 0f) * s.x,
                new Vector4(xy - wz, 1f - (xx + zz), yz + wx, 0f) * s.y,
                new Vector4(xz + wy, yz - wx, 1f - (xx + yy), 0f) * s.z,
                new Vector4(pos.x, pos.y, pos.z, 1f));
        }

        /// <summary>The pose at <paramref name="from"/> whose +z points at <paramref name="to"/>.</summary>
        public static Matrix4x4 LookAt(Vector3 from, Vector3 to, Vector3 up) => TRS(from, Quaternion.LookRotation(to - from, up), Vector3.one);

        static double DeterminantOf(Matrix4x4 m)
        {
            Minors(m, out var s, out var c);
            return s[0] * c[5] - s[1] * c[4] + s[2] * c[3] + s[3] * c[2] - s[4] * c[1] + s[5] * c[0];
        }

        /// <summary>Laplace expansion over the 2x2 minors of the two upper (s) and the two lower rows (c), in double precision.</summary>
        static void Minors(Matrix4x4 m, out double[] s, out double[] c)
        {
            double Minor(int row, int i, int j) => (double)m[row, i] * m[row + 1, j] - (double)m[row + 1, i] * m[row, j];
            s = new[] { Minor(0, 0, 1), Minor(0, 0, 2), Minor(0, 0, 3), Minor(0, 1, 2), Minor(0, 1, 3), Minor(0, 2, 3) };
            c = new[] { Minor(2, 0, 1), Minor(2, 0, 2), Minor(2, 0, 3), Minor(2, 1, 2), Minor(2, 1, 3), Minor(2, 2, 3) };
        }

        static Matrix4x4 InverseOf(Matrix4x4 m)
        {
            Minors(m, out var s, out var c);
            var det = s[0] * c[5] - s[1] * c[4] + s[2] * c[3] + s[3] * c[2] - s[4] * c[1] + s[5] * c[0];
            if (Math.Abs(det) < 1E-30 || double.IsNaN(det))
                return zero;
            var d = 1.0 / det;
            float E(double a, double p, double b, double q, double e, double r) => (float)((a * p + b * q + e * r) * d);
            return new Matrix4x4
            {
                m00 = E(m.m11, c[5], -m.m12, c[4], m.m13, c[3]),
                m01 = E(-m.m01, c[5], m.m02, c[4], -m.m03, c[3]),
                m02 = E(m.m31, s[5], -m.m32, s[4], m.m33, s[3]),
                m03 = E(-m.m21, s[5], m.m22, s[4], -m.m23, s[3]),
                m10 = E(-m.m10, c[5], m.m12, c[2], -m.m13, c[1]),
                m11 = E(m.m00, c[5], -m.m02, c[2], m.m03, c[1]),
                m12 = E(-m.m30, s[5], m.m32, s[2], -m.m33, s[1]),
                m13 = E(m.m20, s[5], -m.m22, s[2], m.m23, s[1]),
                m20 = E(m.m10, c[4], -m.m11, c[2], m.m13, c[0]),
                m21 = E(-m.m00, c[4], m.m01, c[2], -m.m03, c[0]),
                m22 = E(m.m30, s[4], -m.m31, s[2], m.m33, s[0]),
                m23 = E(-m.m20, s[4], m.m21, s[2], -m.m23, s[0]),
                m30 = E(-m.m10, c[3], m.m11, c[1], -m.m12, c[0]),
                m31 = E(m.m00, c[3], -m.m01, c[1], m.m02, c[0]),
                m32 = E(-m.m30, s[3], m.m31, s[1], -m.m32, s[0]),
                m33 = E(m.m20, s[3], -m.m21, s[1], m.m22, s[0]),
            };
        }
    }
}
