namespace UnityEngine
{
    /// <summary>Unity's Euler angles (y * x * z) read back from a rotation matrix.</summary>
    static class EulerAngle
    {
        /// <summary>Degrees, each in [0, 360). At the poles (x = +-90) the turn about z is 0.</summary>
        internal static Vector3 FromRotation(Matrix4x4 m)
        {
            // The third column of Ry*Rx*Rz is (sin y cos x, -sin x, cos y cos x).
            var sine = -m.m12;
            float x, y, z;
            if (Mathf.Abs(sine) > 0.999999f)
            {
                x = Mathf.Sign(sine) * Mathf.PI * 0.5f;
                y = Mathf.Atan2(-m.m20, m.m00);
                z = 0f;
            }
            else
            {
                x = Mathf.Asin(sine);
                y = Mathf.Atan2(m.m02, m.m22);
                z = Mathf.Atan2(m.m10, m.m11);
            }

            return new Vector3(Positive(x), Positive(y), Positive(z));
        }

        static float Positive(float radians)
        {
            var degrees = radians * Mathf.Rad2Deg;
            // A hair below zero is zero, not 360, as in Unity.
            if (degrees < -0.0001f)
                return degrees + 360f;
            return degrees < 0f ? 0f : degrees;
        }
    }
}
