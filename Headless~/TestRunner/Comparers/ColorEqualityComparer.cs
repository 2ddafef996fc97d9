using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils
{
    /// <summary>Colours are equal when each component is, within an absolute error.</summary>
    public class ColorEqualityComparer : IEqualityComparer<Color>
    {
        const float k_DefaultError = 0.01f;

        readonly float m_AllowedError;

        ColorEqualityComparer() : this(k_DefaultError)
        {
        }

        public ColorEqualityComparer(float error) => m_AllowedError = error;

        /// <summary>The comparer with the default error, 0.01.</summary>
        public static ColorEqualityComparer Instance { get; } = new();

        public bool Equals(Color expected, Color actual) => System.Math.Abs(expected.r - actual.r) <= m_AllowedError &&
            System.Math.Abs(expected.g - actual.g) <= m_AllowedError && System.Math.Abs(expected.b - actual.b) <= m_AllowedError &&
            System.Math.Abs(expected.a - actual.a) <= m_AllowedError;

        public int GetHashCode(Color color) => 0;
    }
}
