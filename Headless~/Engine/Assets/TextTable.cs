using System.Collections.Generic;
using System.IO;

namespace UnityEngine
{
    /// <summary>The tables of facts that are built into the engine.</summary>
    static class TextTable
    {
        /// <summary>The lines that say something: no empty ones, no comments.</summary>
        internal static IEnumerable<string> Lines(string name)
        {
            using var stream = typeof(TextTable).Assembly.GetManifestResourceStream(name) ?? throw new FileNotFoundException("There is no such table", name);
            using var reader = new StreamReader(stream);
            while (reader.ReadLine() is { } line)
                if (line.Trim().Length > 0 && line[0] != '#')
                    yield return line;
        }
    }
}
