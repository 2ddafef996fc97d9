using System;

namespace UnityEngine.TestTools.Utils
{
    /// <summary>Comparisons with tolerance.</summary>
    public static class Utils
    {
        /// <summary>Equal within an error: absolute for values up to 1, relative to the larger one above. Infinities equal themselves.</summary>
        public static bool AreFloatsEqual(float expected, float actual, float epsilon)
        {
            if (float.IsInfinity(expected) || float.IsInfinity(actual))
                return expected == actual;
            return Math.Abs(actual - expected) <= epsilon * Mathf.Max(Mathf.Max(Mathf.Abs(actual), Mathf.Abs(expected)), 1f);
        }
    }
}
