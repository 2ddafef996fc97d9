namespace UnityEngine
{
    public partial struct Matrix4x4
    {
        /// <summary>The planes of a projection, at their distances; left..top on the near plane.</summary>
        public FrustumPlanes decomposeProjection
        {
            get
            {
                var planes = new FrustumPlanes();
                if (m32 != 0f)
                {
                    planes.zNear = m23 / (m22 - 1f);
                    planes.zFar = m23 / (m22 + 1f);
                    planes.left = planes.zNear * (m02 - 1f) / m00;
                    planes.right = planes.zNear * (m02 + 1f) / m00;
                    planes.bottom = planes.zNear * (m12 - 1f) / m11;
                    planes.top = planes.zNear * (m12 + 1f) / m11;
                }
                else
                {
                    planes.zNear = (m23 + 1f) / m22;
                    planes.zFar = (m23 - 1f) / m22;
                    planes.left = -(1f + m03) / m00;
                    planes.right = (1f - m03) / m00;
                    planes.bottom = -(1f + m13) / m11;
                    planes.top = (1f - m13) / m11;
                }

                return planes;
            }
        }

        /// <summary>OpenGL's perspective: looks along -z, z to -1..1. <paramref name="fov"/> is vertical, in degrees.</summary>
        public static Matrix4x4 Perspective(float fov, float aspect, float zNear, float zFar)
        {
            var cotangent = (float)(1.0 / System.Math.Tan(fov * 0.5 * System.Math.PI / 180.0));
            return new Matrix4x4
            {
                m00 = cotangent / aspect,
                m11 = cotangent,
                m22 = (zNear + zFar) / (zNear - zFar),
                m23 = 2f * zNear * zFar / (zNear - zFar),
                m32 = -1f,
            };
        }

        /// <summary>OpenGL's parallel projection.</summary>
        public static Matrix4x4 Ortho(float left, float right, float bottom, float top, float zNear, float zFar) => new()
        {
            m00 = 2f / (right - left),
            m03 = -(right + left) / (right - left),
            m11 = 2f / (top - bottom),
            m13 = -(top + bottom) / (top - bottom),
            m22 = -2f / (zFar - zNear),
            m23 = -(zFar + zNear) / (zFar - zNear),
            m33 = 1f,
        };

        /// <summary>OpenGL's off-centre perspective; left..top are on the near plane.</summary>
        public static Matrix4x4 Frustum(float left, float right, float bottom, float top, float zNear, float zFar) => new()
        {
            m00 = 2f * zNear / (right - left),
            m02 = (right + left) / (right - left),
            m11 = 2f * zNear / (top - bottom),
            m12 = (top + bottom) / (top - bottom),
            m22 = -(zFar + zNear) / (zFar - zNear),
            m23 = -2f * zFar * zNear / (zFar - zNear),
            m32 = -1f,
        };

        public static Matrix4x4 Frustum(FrustumPlanes fp) => Frustum(fp.left, fp.right, fp.bottom, fp.top, fp.zNear, fp.zFar);
    }
}
