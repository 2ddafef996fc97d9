using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// A volume's voxel centres as the kernels see them: in "centred millimetres", which are LPS millimetres minus the volume's centre, in float.
    /// Every operation is rounded to float by itself and none is fused, here by casts and in HLSL by <c>precise</c>, so that both agree in
    /// every bit. Oblique and sheared grids need nothing special.
    /// </summary>
    public sealed class CentredGrid
    {
        readonly float m00, m01, m02, m10, m11, m12, m20, m21, m22;

        /// <summary>Takes over a volume's geometry.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="geometry"/> is null.</exception>
        public CentredGrid(VolumeGeometry geometry)
        {
            Geometry = geometry ?? throw new ArgumentNullException(nameof(geometry));
            CentreLps = geometry.CentreLps;
            CentreI = (float)((geometry.SizeI - 1) * 0.5);
            CentreJ = (float)((geometry.SizeJ - 1) * 0.5);
            CentreK = (float)((geometry.SizeK - 1) * 0.5);
            Affine m = geometry.IjkToLps;
            m00 = (float)m[0, 0];
            m01 = (float)m[0, 1];
            m02 = (float)m[0, 2];
            m10 = (float)m[1, 0];
            m11 = (float)m[1, 1];
            m12 = (float)m[1, 2];
            m20 = (float)m[2, 0];
            m21 = (float)m[2, 1];
            m22 = (float)m[2, 2];
        }

        /// <summary>The geometry in double precision.</summary>
        public VolumeGeometry Geometry { get; }

        /// <summary>The point that centred millimetres count from, in LPS millimetres.</summary>
        public PointMm CentreLps { get; }

        /// <summary>The centre's voxel index along i, (SizeI - 1) / 2, exact in float.</summary>
        public float CentreI { get; }

        /// <summary>The centre's voxel index along j, (SizeJ - 1) / 2, exact in float.</summary>
        public float CentreJ { get; }

        /// <summary>The centre's voxel index along k, (SizeK - 1) / 2, exact in float.</summary>
        public float CentreK { get; }

        /// <summary>The matrix from voxel steps to millimetres, rounded to float.</summary>
        /// <param name="row">0 = L, 1 = P, 2 = S.</param>
        /// <param name="column">0 = i, 1 = j, 2 = k.</param>
        /// <exception cref="ArgumentOutOfRangeException">A number is not 0, 1 or 2.</exception>
        public float this[int row, int column]
        {
            get
            {
                if (row < 0 || row > 2)
                    throw new ArgumentOutOfRangeException(nameof(row), row, "Rows are 0, 1 and 2.");
                return column switch
                {
                    0 => row == 0 ? m00 : row == 1 ? m10 : m20,
                    1 => row == 0 ? m01 : row == 1 ? m11 : m21,
                    2 => row == 0 ? m02 : row == 1 ? m12 : m22,
                    _ => throw new ArgumentOutOfRangeException(nameof(column), column, "Columns are 0, 1 and 2."),
                };
            }
        }

        /// <summary>A voxel's centre in centred millimetres, bit for bit as in the kernels.</summary>
        public void Position(int i, int j, int k, out float x, out float y, out float z)
        {
            float fi = (float)(i - CentreI);
            float fj = (float)(j - CentreJ);
            float fk = (float)(k - CentreK);
            x = (float)((float)((float)(m00 * fi) + (float)(m01 * fj)) + (float)(m02 * fk));
            y = (float)((float)((float)(m10 * fi) + (float)(m11 * fj)) + (float)(m12 * fk));
            z = (float)((float)((float)(m20 * fi) + (float)(m21 * fj)) + (float)(m22 * fk));
        }

        /// <summary>A clip sphere in centred millimetres: the subtraction in double precision, then one rounding to float.</summary>
        /// <exception cref="ArgumentNullException"><paramref name="sphere"/> is null.</exception>
        public SphereF ToCentred(ClipSphere sphere)
        {
            if (sphere == null)
                throw new ArgumentNullException(nameof(sphere));
            return new SphereF(
                (float)(sphere.CentreLps.X - CentreLps.X),
                (float)(sphere.CentreLps.Y - CentreLps.Y),
                (float)(sphere.CentreLps.Z - CentreLps.Z),
                (float)sphere.RadiusMm);
        }

        /// <summary>
        /// A voxel's extent along a direction in millimetres: |n.a_i| + |n.a_j| + |n.a_k| with a_* the three voxel steps. It is the width of the
        /// slab, perpendicular to n, that just holds the voxel's box.
        /// </summary>
        /// <param name="nx">The unit direction's L component; <paramref name="ny"/> and <paramref name="nz"/> are P and S.</param>
        /// <param name="ny">P component.</param>
        /// <param name="nz">S component.</param>
        public float VoxelExtent(float nx, float ny, float nz)
        {
            float ei = Math.Abs((float)((float)((float)(nx * m00) + (float)(ny * m10)) + (float)(nz * m20)));
            float ej = Math.Abs((float)((float)((float)(nx * m01) + (float)(ny * m11)) + (float)(nz * m21)));
            float ek = Math.Abs((float)((float)((float)(nx * m02) + (float)(ny * m12)) + (float)(nz * m22)));
            return (float)((float)(ei + ej) + ek);
        }
    }
}
