using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using System.Text.RegularExpressions;

namespace UnityEngine.Shaders
{
    /// <summary>
    /// Puts included files in place, as Unity finds them: beside the including file, under "Packages/name/", or among Unity's own. The compiler
    /// then needs no search path, and the text holds all that the result depends on.
    /// </summary>
    static class IncludeExpander
    {
        const string PackagePrefix = "Packages/com.anatomycarve.vr/";
        const int MaxDepth = 32;

        static readonly Regex s_Include = new(@"^\s*#\s*include(_with_pragmas)?\s+[""<](?<path>[^"">]+)["">]", RegexOptions.Compiled);

        internal static string Expand(string path, string text)
        {
            var output = new StringBuilder(text.Length * 2);
            Append(output, path, text, 0, new List<string>(), new HashSet<string>(StringComparer.Ordinal));
            return output.ToString();
        }

        /// <summary>The same for blocks of one file that follow each other, after files that are included unasked.</summary>
        internal static string Expand(string path, IEnumerable<string> first, IEnumerable<ShaderLabBlock> blocks)
        {
            var output = new StringBuilder();
            var once = new HashSet<string>(StringComparer.Ordinal);
            foreach (var include in first)
                Append(output, path, "#include \"" + include + "\"\n", 0, new List<string>(), once);
            foreach (var block in blocks)
                Append(output, path, block.Text, block.Line - 1, new List<string>(), once);
            return output.ToString();
        }

        /// <summary>The text of a file that an #include names; null if there is none.</summary>
        internal static (string Path, string Text)? Find(string include, string from) =>
            Resolve(include, from) is { } path ? (path, Read(path)) : null;

        static void Append(StringBuilder output, string path, string text, int linesBefore, List<string> stack, HashSet<string> once)
        {
            if (stack.Count == MaxDepth)
                throw new ShaderCompileException($"{path}: includes are nested more than {MaxDepth} deep");
            stack.Add(path);
            Line(output, linesBefore + 1, path);
            var lines = text.TrimStart('\uFEFF').Split('\n');
            for (var i = 0; i < lines.Length; i++)
            {
                var line = lines[i].TrimEnd('\r');
                if (Regex.IsMatch(line, @"^\s*#\s*pragma\s+once\b"))
                {
                    once.Add(path);
                    output.Append('\n');
                    continue;
                }
                var match = s_Include.Match(line);
                if (!match.Success)
                {
                    output.Append(line).Append('\n');
                    continue;
                }
                var included = Resolve(match.Groups["path"].Value, path);
                if (included == null)
                {
                    // It may stand in a part that is compiled out, so only the compiler can call it an error.
                    output.Append($"#error include file '{match.Groups["path"].Value}' not found\n");
                    continue;
                }
                // A file that includes itself in a circle is under its own guard by now.
                if (!stack.Contains(included) && !once.Contains(included))
                    Append(output, included, Read(included), 0, stack, once);
                Line(output, linesBefore + i + 2, path);
            }
            stack.RemoveAt(stack.Count - 1);
        }

        static string Resolve(string include, string from)
        {
            if (include.StartsWith(PackagePrefix, StringComparison.Ordinal))
            {
                if (string.IsNullOrEmpty(GpuOptions.PackageRoot))
                    return null;
                return Existing(Path.Combine(GpuOptions.PackageRoot, include.Substring(PackagePrefix.Length)));
            }
            return Beside(include, from) ?? ShaderEnvironment.Resolve(include);
        }

        static string Beside(string include, string from)
        {
            var path = (Path.GetDirectoryName(from) ?? ".") + "/" + include;
            return IsLibrary(from) ? ShaderEnvironment.Resolve(path.Substring(ShaderEnvironment.LibraryPrefix.Length)) : Existing(path);
        }

        static bool IsLibrary(string path) => path.StartsWith(ShaderEnvironment.LibraryPrefix, StringComparison.Ordinal);

        static string Read(string path) => IsLibrary(path) ? ShaderEnvironment.ReadLibrary(path) : File.ReadAllText(path, Encoding.UTF8);

        static string Existing(string path) => File.Exists(path) ? Path.GetFullPath(path) : null;

        static void Line(StringBuilder output, int number, string path) =>
            output.Append("#line ").Append(number.ToString(CultureInfo.InvariantCulture)).Append(" \"").Append(path.Replace('\\', '/')).Append("\"\n");
    }
}
