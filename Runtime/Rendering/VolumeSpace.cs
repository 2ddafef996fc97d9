using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// Between Unity's space and the patient's. In a volume's local space +x is the patient's left, +y superior, +z posterior, in metres,
    /// with the volume's centre at the origin; the patient's space is LPS in millimetres. A rotated or sheared grid keeps its axes in the
    /// volume's geometry, so the local axes are the patient's for every volume.
    /// </summary>
    public static class VolumeSpace
    {
        /// <summary>Metres in a millimetre.</summary>
        public const double MetresPerMm = 0.001;

        const double MmPerMetre = 1000.0;

        /// <summary>A point of the patient in the volume's local space.</summary>
        /// <param name="geometry">The volume's geometry.</param>
        /// <param name="pointLps">The point in LPS millimetres.</param>
        /// <returns>The point in metres.</returns>
        public static Vector3 LpsToLocal(VolumeGeometry geometry, PointMm pointLps)
        {
            VectorMm v = (pointLps - Checked(geometry).CentreLps) * MetresPerMm;
            return new Vector3((float)v.X, (float)v.Z, (float)v.Y);
        }

        /// <summary>A point of the volume's local space in the patient.</summary>
        /// <param name="geometry">The volume's geometry.</param>
        /// <param name="local">The point in metres.</param>
        /// <returns>The point in LPS millimetres.</returns>
        public static PointMm LocalToLps(VolumeGeometry geometry, Vector3 local) =>
            Checked(geometry).CentreLps + new VectorMm(local.x * MmPerMetre, local.z * MmPerMetre, local.y * MmPerMetre);

        /// <summary>
        /// The matrix from world space to LPS millimetres.
        /// </summary>
        /// <param name="geometry">The volume's geometry.</param>
        /// <param name="localToWorld">The volume's transform; any rotation, position, scale and shear but a scale of 0.</param>
        /// <exception cref="ArgumentException">The transform cannot be inverted: a scale is 0.</exception>
        public static Affine WorldToLps(VolumeGeometry geometry, Matrix4x4 localToWorld)
        {
            PointMm centre = Checked(geometry).CentreLps;
            var localToLps = new Affine(
                MmPerMetre, 0, 0, centre.X,
                0, 0, MmPerMetre, centre.Y,
                0, MmPerMetre, 0, centre.Z);
            return localToLps * ToAffine(localToWorld).Inverse();
        }

        /// <summary>
        /// How many metres in the world one metre of the volume is: for a volume scaled unevenly the geometric mean of its three scales, so that a
        /// sphere keeps its volume.
        /// </summary>
        public static double WorldScale(Matrix4x4 localToWorld) => Math.Pow(Math.Abs(ToAffine(localToWorld).Determinant), 1.0 / 3.0);

        /// <summary>A ray of the world in the patient.</summary>
        /// <param name="geometry">The volume's geometry.</param>
        /// <param name="localToWorld">The volume's transform.</param>
        /// <param name="worldRay">The ray.</param>
        /// <param name="mmPerWorldUnit">Millimetres of the patient in one world unit along this ray.</param>
        /// <exception cref="ArgumentException">The transform cannot be inverted, or the ray has no direction.</exception>
        internal static RayMm RayToLps(VolumeGeometry geometry, Matrix4x4 localToWorld, Ray worldRay, out double mmPerWorldUnit)
        {
            Affine worldToLps = WorldToLps(geometry, localToWorld);
            Vector3 origin = worldRay.origin, direction = worldRay.direction;
            VectorMm directionLps = worldToLps.TransformVector(new VectorMm(direction.x, direction.y, direction.z));
            mmPerWorldUnit = directionLps.Length;
            return new RayMm(worldToLps.TransformPoint(new PointMm(origin.x, origin.y, origin.z)), directionLps);
        }

        internal static Affine ToAffine(Matrix4x4 m) => new Affine(m.m00, m.m01, m.m02, m.m03, m.m10, m.m11, m.m12, m.m13, m.m20, m.m21, m.m22, m.m23);

        static VolumeGeometry Checked(VolumeGeometry geometry) => geometry ?? throw new ArgumentNullException(nameof(geometry));
    }
}
