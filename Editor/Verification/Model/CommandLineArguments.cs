using System;
using System.Collections.Generic;

namespace AnatomyCarve.Editor
{
    /// <summary>Options that the Editor was started with and does not know itself.</summary>
    static class CommandLineArguments
    {
        /// <summary>The value behind an option's name.</summary>
        /// <param name="arguments">All arguments.</param>
        /// <param name="name">The option, with its dash.</param>
        /// <returns>Null where the option is not given; of several the last counts.</returns>
        /// <exception cref="ArgumentException">It is given without a value.</exception>
        public static string Value(IReadOnlyList<string> arguments, string name)
        {
            for (int a = arguments.Count - 1; a >= 0; a--)
            {
                if (!string.Equals(arguments[a], name, StringComparison.OrdinalIgnoreCase))
                    continue;
                if (a + 1 == arguments.Count || arguments[a + 1].Length == 0 || arguments[a + 1].StartsWith("-", StringComparison.Ordinal))
                    throw new ArgumentException($"{name} needs a value.", nameof(arguments));
                return arguments[a + 1];
            }
            return null;
        }
    }
}
