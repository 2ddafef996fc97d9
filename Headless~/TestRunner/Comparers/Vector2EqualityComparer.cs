using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils
{
    /// <summary>Vectors are equal when each component is, within an error that is relative above 1.</summary>
    public class Vector2EqualityComparer : IEqualityComparer<Vector2>
    {
        const float k_DefaultError = 0.0001f;

        readonly float m_AllowedError;

        Vector2EqualityComparer() : this(k_DefaultError)
        {
        }

        public Vector2EqualityComparer(float error) => m_AllowedError = error;

        /// <summary>The comparer with the default error, 0.0001.</summary>
        public static Vector2EqualityComparer Instance { get; } = new();

        public bool Equals(Vector2 expected, Vector2 actual) =>
            Utils.AreFloatsEqual(expected.x, actual.x, m_AllowedError) && Utils.AreFloatsEqual(expected.y, actual.y, m_AllowedError);

        public int GetHashCode(Vector2 vec2) => 0;
    }
}
