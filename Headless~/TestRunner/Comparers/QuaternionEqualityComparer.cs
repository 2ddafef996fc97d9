using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils
{
    /// <summary>Rotations are equal when the magnitude of their dot product is 1 within an error.</summary>
    public class QuaternionEqualityComparer : IEqualityComparer<Quaternion>
    {
        const float k_DefaultError = 0.00001f;

        readonly float m_AllowedError;

        QuaternionEqualityComparer() : this(k_DefaultError)
        {
        }

        public QuaternionEqualityComparer(float allowedError) => m_AllowedError = allowedError;

        /// <summary>The comparer with the default error, 0.00001.</summary>
        public static QuaternionEqualityComparer Instance { get; } = new();

        public bool Equals(Quaternion expected, Quaternion actual) => Mathf.Abs(Quaternion.Dot(expected, actual)) > 1f - m_AllowedError;

        public int GetHashCode(Quaternion quaternion) => 0;
    }
}
