using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// The box that a volume fills, as a matrix: it takes the cube of side 1 around the origin to the volume's box, oblique and sheared ones too.
    /// </summary>
    static class BoxFrame
    {
        /// <summary>From the unit cube to the volume's local space (metres; +x left, +y superior, +z posterior).</summary>
        public static Matrix4x4 UnitCubeToLocal(VolumeGeometry geometry)
        {
            Affine ijkToLps = geometry.IjkToLps;
            Matrix4x4 matrix = Matrix4x4.identity;
            matrix.SetColumn(0, ToLocal(geometry, ijkToLps.Column(0) * geometry.SizeI));
            matrix.SetColumn(1, ToLocal(geometry, ijkToLps.Column(1) * geometry.SizeJ));
            matrix.SetColumn(2, ToLocal(geometry, ijkToLps.Column(2) * geometry.SizeK));
            return matrix;
        }

        /// <summary>Half the size of the box in local axes, which are the patient's; metres.</summary>
        public static Vector3 Extents(VolumeGeometry geometry)
        {
            Matrix4x4 m = UnitCubeToLocal(geometry);
            return 0.5f * new Vector3(
                Mathf.Abs(m.m00) + Mathf.Abs(m.m01) + Mathf.Abs(m.m02),
                Mathf.Abs(m.m10) + Mathf.Abs(m.m11) + Mathf.Abs(m.m12),
                Mathf.Abs(m.m20) + Mathf.Abs(m.m21) + Mathf.Abs(m.m22));
        }

        static Vector4 ToLocal(VolumeGeometry geometry, VectorMm axis) => VolumeSpace.LpsToLocal(geometry, geometry.CentreLps + axis);
    }
}
