using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// An affine map in double precision: a 3x3 matrix and a translation, written as the upper three rows of a 4x4 matrix.
    /// The default value maps everything to the origin; start from <see cref="Identity"/>.
    /// </summary>
    public readonly struct Affine : IEquatable<Affine>
    {
        readonly double m00, m01, m02, m03;
        readonly double m10, m11, m12, m13;
        readonly double m20, m21, m22, m23;

        /// <summary>Makes a map from its twelve elements, row by row.</summary>
        public Affine(
            double m00, double m01, double m02, double m03,
            double m10, double m11, double m12, double m13,
            double m20, double m21, double m22, double m23)
        {
            this.m00 = m00;
            this.m01 = m01;
            this.m02 = m02;
            this.m03 = m03;
            this.m10 = m10;
            this.m11 = m11;
            this.m12 = m12;
            this.m13 = m13;
            this.m20 = m20;
            this.m21 = m21;
            this.m22 = m22;
            this.m23 = m23;
        }

        /// <summary>The map that changes nothing.</summary>
        public static Affine Identity => new Affine(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

        /// <summary>The determinant of the 3x3 part; negative for a map that mirrors.</summary>
        public double Determinant => VectorMm.Dot(Column(0), VectorMm.Cross(Column(1), Column(2)));

        /// <summary>Where (0, 0, 0) is mapped to: the last column.</summary>
        public PointMm Origin => new PointMm(m03, m13, m23);

        /// <summary>True when no element is NaN or infinite.</summary>
        public bool IsFinite => Column(0).IsFinite && Column(1).IsFinite && Column(2).IsFinite && Origin.IsFinite;

        /// <summary>An element.</summary>
        /// <param name="row">0 to 2.</param>
        /// <param name="col">0 to 3; column 3 is the translation.</param>
        /// <exception cref="ArgumentOutOfRangeException">Row or column outside its range.</exception>
        public double this[int row, int col]
        {
            get
            {
                if (row < 0 || row > 2)
                    throw new ArgumentOutOfRangeException(nameof(row), row, "A row is 0, 1 or 2.");
                PointMm column = col == 3 ? Origin : new PointMm(0, 0, 0) + Column(col);
                return row == 0 ? column.X : row == 1 ? column.Y : column.Z;
            }
        }

        /// <summary>Makes a map from the three columns of its matrix and its translation.</summary>
        public static Affine FromColumns(VectorMm column0, VectorMm column1, VectorMm column2, PointMm origin) =>
            new Affine(
                column0.X, column1.X, column2.X, origin.X,
                column0.Y, column1.Y, column2.Y, origin.Y,
                column0.Z, column1.Z, column2.Z, origin.Z);

        /// <summary>The map that applies <paramref name="b"/> first, then <paramref name="a"/>.</summary>
        public static Affine operator *(Affine a, Affine b) =>
            FromColumns(a.TransformVector(b.Column(0)), a.TransformVector(b.Column(1)), a.TransformVector(b.Column(2)), a.TransformPoint(b.Origin));

        /// <summary>Equal in every element, exactly.</summary>
        public static bool operator ==(Affine a, Affine b) => a.Equals(b);

        /// <summary>Different in at least one element.</summary>
        public static bool operator !=(Affine a, Affine b) => !a.Equals(b);

        /// <summary>A column of the 3x3 part: the image of a unit vector.</summary>
        /// <param name="col">0 to 2.</param>
        /// <exception cref="ArgumentOutOfRangeException">Column outside its range.</exception>
        public VectorMm Column(int col)
        {
            switch (col)
            {
                case 0:
                    return new VectorMm(m00, m10, m20);
                case 1:
                    return new VectorMm(m01, m11, m21);
                case 2:
                    return new VectorMm(m02, m12, m22);
                default:
                    throw new ArgumentOutOfRangeException(nameof(col), col, "A column is 0, 1 or 2 (3 is the translation).");
            }
        }

        /// <summary>Maps a point: matrix and translation.</summary>
        public PointMm TransformPoint(PointMm point) =>
            new PointMm(
                m00 * point.X + m01 * point.Y + m02 * point.Z + m03,
                m10 * point.X + m11 * point.Y + m12 * point.Z + m13,
                m20 * point.X + m21 * point.Y + m22 * point.Z + m23);

        /// <summary>Maps a vector: matrix only.</summary>
        public VectorMm TransformVector(VectorMm vector) =>
            new VectorMm(
                m00 * vector.X + m01 * vector.Y + m02 * vector.Z,
                m10 * vector.X + m11 * vector.Y + m12 * vector.Z,
                m20 * vector.X + m21 * vector.Y + m22 * vector.Z);

        /// <summary>The map back.</summary>
        /// <exception cref="ArgumentException">The matrix is singular or not finite.</exception>
        public Affine Inverse()
        {
            double determinant = Determinant;
            if (determinant == 0 || !double.IsFinite(determinant) || !IsFinite)
                throw new ArgumentException(FormattableString.Invariant($"The matrix has no inverse (determinant {determinant})."));
            VectorMm row0 = VectorMm.Cross(Column(1), Column(2)) / determinant;
            VectorMm row1 = VectorMm.Cross(Column(2), Column(0)) / determinant;
            VectorMm row2 = VectorMm.Cross(Column(0), Column(1)) / determinant;
            var origin = new VectorMm(m03, m13, m23);
            return new Affine(
                row0.X, row0.Y, row0.Z, -row0.Dot(origin),
                row1.X, row1.Y, row1.Z, -row1.Dot(origin),
                row2.X, row2.Y, row2.Z, -row2.Dot(origin));
        }

        /// <inheritdoc/>
        public bool Equals(Affine other) =>
            Column(0) == other.Column(0) && Column(1) == other.Column(1) && Column(2) == other.Column(2) && Origin == other.Origin;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is Affine other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Column(0), Column(1), Column(2), Origin);

        /// <summary>The three rows, in the invariant culture.</summary>
        public override string ToString() =>
            FormattableString.Invariant($"[{m00} {m01} {m02} {m03}; {m10} {m11} {m12} {m13}; {m20} {m21} {m22} {m23}]");
    }
}
