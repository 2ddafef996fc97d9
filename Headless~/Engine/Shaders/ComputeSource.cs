using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace UnityEngine.Shaders
{
    /// <summary>A kernel as its #pragma names it.</summary>
    sealed class KernelPragma
    {
        internal KernelPragma(string name, IReadOnlyList<string> defines)
        {
            Name = name;
            Defines = defines;
        }

        internal string Name { get; }

        /// <summary>"NAME" or "NAME=VALUE".</summary>
        internal IReadOnlyList<string> Defines { get; }
    }

    /// <summary>The keywords of one #pragma multi_compile; "_" stands for none of them.</summary>
    sealed class KeywordSet
    {
        internal KeywordSet(IReadOnlyList<string> keywords, bool local)
        {
            Keywords = keywords;
            IsLocal = local;
        }

        internal IReadOnlyList<string> Keywords { get; }

        internal bool IsLocal { get; }

        internal static bool IsNone(string keyword) => keyword.Trim('_').Length == 0;
    }

    /// <summary>A .compute file with everything that it includes, and what its pragmas say.</summary>
    sealed class ComputeSource
    {
        static readonly Regex s_Pragma = new(@"^\s*#\s*pragma\s+(\w+)\s*(.*)$", RegexOptions.Compiled);
        static readonly Regex s_Identifier = new(@"[A-Za-z_]\w*", RegexOptions.Compiled);

        readonly HashSet<string> m_Identifiers = new();

        ComputeSource(string path) => Path = path;

        internal string Path { get; }

        /// <summary>The text with all includes in place, with #line directives that lead back to the files.</summary>
        internal string Text { get; private set; }

        internal IReadOnlyList<KernelPragma> Kernels { get; private set; }

        internal IReadOnlyList<KeywordSet> KeywordSets { get; private set; }

        /// <summary>Whether a word occurs anywhere in the source.</summary>
        internal bool Mentions(string identifier) => m_Identifiers.Contains(identifier);

        /// <exception cref="ShaderCompileException">A file is missing, or a pragma makes no sense.</exception>
        internal static ComputeSource Load(string path)
        {
            var source = new ComputeSource(System.IO.Path.GetFullPath(path));
            string root;
            try
            {
                root = File.ReadAllText(source.Path, Encoding.UTF8);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                throw new ShaderCompileException($"{path} cannot be read: {e.Message}", e);
            }
            source.ReadPragmas(root);
            source.Text = IncludeExpander.Expand(source.Path, root);
            foreach (Match match in s_Identifier.Matches(source.Text))
                source.m_Identifiers.Add(match.Value);
            return source;
        }

        void ReadPragmas(string text)
        {
            var kernels = new List<KernelPragma>();
            var sets = new List<KeywordSet>();
            var number = 0;
            foreach (var line in text.Split('\n'))
            {
                number++;
                var match = s_Pragma.Match(line.TrimEnd('\r'));
                if (!match.Success)
                    continue;
                var words = match.Groups[2].Value.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
                switch (match.Groups[1].Value)
                {
                    case "kernel":
                        if (words.Length == 0 || words.Any(w => w.StartsWith("//", StringComparison.Ordinal)))
                            throw new ShaderCompileException($"{Path}({number}): '#pragma kernel' needs a name and takes no comment");
                        kernels.Add(new KernelPragma(words[0], words.Skip(1).ToList()));
                        break;
                    case "multi_compile":
                    case "multi_compile_local":
                        sets.Add(new KeywordSet(words, match.Groups[1].Value == "multi_compile_local"));
                        break;
                    case "shader_feature":
                    case "shader_feature_local":
                        throw new ShaderCompileException($"{Path}({number}): '#pragma {match.Groups[1].Value}' is stripped from builds of compute shaders; "
                            + "use multi_compile");
                }
            }
            Kernels = kernels;
            KeywordSets = sets;
        }
    }
}
