using System;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;

namespace UnityEngine.Shaders
{
    /// <summary>Version expressions as Unity writes them: "17.0" is that or newer, "[16,17)" an interval, "[17.0.3]" exactly that.</summary>
    static class VersionRange
    {
        /// <summary>Whether a version fits an expression; everything fits null and "".</summary>
        /// <exception cref="FormatException">The expression makes no sense.</exception>
        internal static bool Contains(string expression, string version)
        {
            if (string.IsNullOrWhiteSpace(expression))
                return true;
            var text = expression.Trim();
            if (text[0] is not ('[' or '('))
                return Compare(version, text) >= 0;
            var match = Regex.Match(text, @"^([\[(])\s*([^,\])]*?)\s*(?:(,)\s*([^\])]*?)\s*)?([\])])$");
            if (!match.Success)
                throw new FormatException($"'{expression}' is no version expression");
            if (!match.Groups[3].Success)
                return Compare(version, match.Groups[2].Value) == 0;
            var (low, high) = (match.Groups[2].Value, match.Groups[4].Value);
            var above = low.Length == 0 || Compare(version, low) >= (match.Groups[1].Value == "[" ? 0 : 1);
            var below = high.Length == 0 || Compare(version, high) <= (match.Groups[5].Value == "]" ? 0 : -1);
            return above && below;
        }

        static int Compare(string a, string b)
        {
            var (left, right) = (Numbers(a), Numbers(b));
            for (var i = 0; i < Math.Max(left.Length, right.Length); i++)
            {
                var difference = (i < left.Length ? left[i] : 0).CompareTo(i < right.Length ? right[i] : 0);
                if (difference != 0)
                    return difference;
            }
            return 0;
        }

        // What follows the numbers (-pre.3, f1) does not count.
        static int[] Numbers(string version)
        {
            var match = Regex.Match(version.Trim(), @"^\d+(\.\d+)*");
            if (!match.Success)
                throw new FormatException($"'{version}' is no version");
            return match.Value.Split('.').Select(n => int.Parse(n, CultureInfo.InvariantCulture)).ToArray();
        }
    }
}
