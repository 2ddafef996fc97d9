using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils
{
    /// <summary>Floats are equal within an error that is relative above 1.</summary>
    public class FloatEqualityComparer : IEqualityComparer<float>
    {
        const float k_DefaultError = 0.0001f;

        readonly float m_AllowedError;

        FloatEqualityComparer() : this(k_DefaultError)
        {
        }

        public FloatEqualityComparer(float allowedError) => m_AllowedError = allowedError;

        /// <summary>The comparer with the default error, 0.0001.</summary>
        public static FloatEqualityComparer Instance { get; } = new();

        public bool Equals(float expected, float actual) => Utils.AreFloatsEqual(expected, actual, m_AllowedError);

        public int GetHashCode(float value) => 0;
    }
}
