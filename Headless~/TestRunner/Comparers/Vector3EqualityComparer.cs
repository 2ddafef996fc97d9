using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils
{
    /// <summary>Vectors are equal when each component is, within an error that is relative above 1.</summary>
    public class Vector3EqualityComparer : IEqualityComparer<Vector3>
    {
        const float k_DefaultError = 0.0001f;

        readonly float m_AllowedError;

        Vector3EqualityComparer() : this(k_DefaultError)
        {
        }

        public Vector3EqualityComparer(float allowedError) => m_AllowedError = allowedError;

        /// <summary>The comparer with the default error, 0.0001.</summary>
        public static Vector3EqualityComparer Instance { get; } = new();

        public bool Equals(Vector3 expected, Vector3 actual) => Utils.AreFloatsEqual(expected.x, actual.x, m_AllowedError) &&
            Utils.AreFloatsEqual(expected.y, actual.y, m_AllowedError) && Utils.AreFloatsEqual(expected.z, actual.z, m_AllowedError);

        public int GetHashCode(Vector3 vec3) => 0;
    }
}
