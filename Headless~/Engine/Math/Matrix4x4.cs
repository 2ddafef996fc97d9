using System;
using System.Globalization;

namespace UnityEngine
{
    /// <summary>A matrix for column vectors: A * B applies B first. In memory the columns are contiguous.</summary>
    [Serializable]
    public partial struct Matrix4x4 : IEquatable<Matrix4x4>, IFormattable
    {
        public float m00;
        public float m10;
        public float m20;
        public float m30;
        public float m01;
        public float m11;
        public float m21;
        public float m31;
        public float m02;
        public float m12;
        public float m22;
        public float m32;
        public float m03;
        public float m13;
        public float m23;
        public float m33;

        public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
        {
            m00 = column0.x; m10 = column0.y; m20 = column0.z; m30 = column0.w;
            m01 = column1.x; m11 = column1.y; m21 = column1.z; m31 = column1.w;
            m02 = column2.x; m12 = column2.y; m22 = column2.z; m32 = column2.w;
            m03 = column3.x; m13 = column3.y; m23 = column3.z; m33 = column3.w;
        }

        public static Matrix4x4 zero => default;

        public static Matrix4x4 identity =>
            new(new Vector4(1f, 0f, 0f, 0f), new Vector4(0f, 1f, 0f, 0f), new Vector4(0f, 0f, 1f, 0f), new Vector4(0f, 0f, 0f, 1f));

        public bool isIdentity => Equals(identity);

        public Matrix4x4 transpose => new(GetRow(0), GetRow(1), GetRow(2), GetRow(3));

        public float this[int row, int column]
        {
            get => this[row + column * 4];
            set => this[row + column * 4] = value;
        }

        public unsafe float this[int index]
        {
            get
            {
                if ((uint)index > 15)
                    throw new IndexOutOfRangeException("Invalid matrix index!");
                fixed (float* p = &m00)
                    return p[index];
            }
            set
            {
                if ((uint)index > 15)
                    throw new IndexOutOfRangeException("Invalid matrix index!");
                fixed (float* p = &m00)
                    p[index] = value;
            }
        }

        public Vector4 GetColumn(int index) => index switch
        {
            0 => new Vector4(m00, m10, m20, m30),
            1 => new Vector4(m01, m11, m21, m31),
            2 => new Vector4(m02, m12, m22, m32),
            3 => new Vector4(m03, m13, m23, m33),
            _ => throw new IndexOutOfRangeException("Invalid column index!"),
        };

        public Vector4 GetRow(int index) => index switch
        {
            0 => new Vector4(m00, m01, m02, m03),
            1 => new Vector4(m10, m11, m12, m13),
            2 => new Vector4(m20, m21, m22, m23),
            3 => new Vector4(m30, m31, m32, m33),
            _ => throw new IndexOutOfRangeException("Invalid row index!"),
        };

        public void SetColumn(int index, Vector4 column)
        {
            for (var row = 0; row < 4; row++)
                this[row, index] = column[row];
        }

        public void SetRow(int index, Vector4 row)
        {
            for (var column = 0; column < 4; column++)
                this[index, column] = row[column];
        }

        /// <summary>The point, divided by the resulting w.</summary>
        public Vector3 MultiplyPoint(Vector3 point) => MultiplyPoint3x4(point) / (m30 * point.x + m31 * point.y + m32 * point.z + m33);

        /// <summary>The point, as if the last row were (0, 0, 0, 1).</summary>
        public Vector3 MultiplyPoint3x4(Vector3 point) => new(
            m00 * point.x + m01 * point.y + m02 * point.z + m03,
            m10 * point.x + m11 * point.y + m12 * point.z + m13,
            m20 * point.x + m21 * point.y + m22 * point.z + m23);

        /// <summary>The direction: without translation.</summary>
        public Vector3 MultiplyVector(Vector3 vector) => new(
            m00 * vector.x + m01 * vector.y + m02 * vector.z,
            m10 * vector.x + m11 * vector.y + m12 * vector.z,
            m20 * vector.x + m21 * vector.y + m22 * vector.z);

        public override string ToString() => ToString(null, null);

        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F5" : format;
            formatProvider ??= CultureInfo.InvariantCulture.NumberFormat;
            var text = "";
            for (var row = 0; row < 4; row++)
                for (var column = 0; column < 4; column++)
                    text += this[row, column].ToString(format, formatProvider) + (column < 3 ? "\t" : "\n");
            return text;
        }

        public override int GetHashCode() =>
            GetColumn(0).GetHashCode() ^ (GetColumn(1).GetHashCode() << 2) ^ (GetColumn(2).GetHashCode() >> 2) ^ (GetColumn(3).GetHashCode() >> 1);

        public override bool Equals(object other) => other is Matrix4x4 m && Equals(m);

        public bool Equals(Matrix4x4 other) =>
            GetColumn(0).Equals(other.GetColumn(0)) && GetColumn(1).Equals(other.GetColumn(1)) &&
            GetColumn(2).Equals(other.GetColumn(2)) && GetColumn(3).Equals(other.GetColumn(3));

        public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs) =>
            new(lhs * rhs.GetColumn(0), lhs * rhs.GetColumn(1), lhs * rhs.GetColumn(2), lhs * rhs.GetColumn(3));

        public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) => new(
            lhs.m00 * vector.x + lhs.m01 * vector.y + lhs.m02 * vector.z + lhs.m03 * vector.w,
            lhs.m10 * vector.x + lhs.m11 * vector.y + lhs.m12 * vector.z + lhs.m13 * vector.w,
            lhs.m20 * vector.x + lhs.m21 * vector.y + lhs.m22 * vector.z + lhs.m23 * vector.w,
            lhs.m30 * vector.x + lhs.m31 * vector.y + lhs.m32 * vector.z + lhs.m33 * vector.w);

        public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs) =>
            lhs.GetColumn(0) == rhs.GetColumn(0) && lhs.GetColumn(1) == rhs.GetColumn(1) &&
            lhs.GetColumn(2) == rhs.GetColumn(2) && lhs.GetColumn(3) == rhs.GetColumn(3);

        public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);
    }
}
