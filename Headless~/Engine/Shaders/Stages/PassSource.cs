using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;

namespace UnityEngine.Shaders
{
    /// <summary>The code of one pass with all that it includes, and what its pragmas say.</summary>
    sealed class PassSource
    {
        const int DefaultTarget = 25;

        internal const string Instanced = "STEREO_INSTANCING_ON", Multiview = "STEREO_MULTIVIEW_ON";

        /// <summary>The sets that Unity gives every program unasked.</summary>
        internal static readonly KeywordSet Stereo = new(new[] { "_", Instanced, Multiview }, local: false);

        static readonly Regex s_Pragma = new(@"^\s*#\s*pragma\s+(\w+)\s*(.*?)\s*(//.*)?$", RegexOptions.Compiled);
        static readonly Regex s_IncludeWithPragmas = new(@"^\s*#\s*include_with_pragmas\s+[""<](?<path>[^"">]+)["">]", RegexOptions.Compiled);
        static readonly Regex s_Identifier = new(@"[A-Za-z_]\w*", RegexOptions.Compiled);

        static readonly Dictionary<string, string[]> s_Shortcuts = new(StringComparer.Ordinal)
        {
            ["multi_compile_instancing"] = new[] { "_", "INSTANCING_ON" },
            ["multi_compile_fog"] = new[] { "_", "FOG_LINEAR", "FOG_EXP", "FOG_EXP2" },
            ["multi_compile_fwdbase"] = new[] { "DIRECTIONAL", "_" },
            ["multi_compile_shadowcaster"] = new[] { "SHADOWS_DEPTH", "SHADOWS_CUBE" },
        };

        readonly List<KeywordSet> m_Sets = new();
        readonly HashSet<string> m_Identifiers = new(StringComparer.Ordinal);

        PassSource(ShaderLabFile file, ShaderLabPass pass)
        {
            File = file;
            Pass = pass;
        }

        internal ShaderLabFile File { get; }

        internal ShaderLabPass Pass { get; }

        /// <summary>The text with all includes in place, with #line directives that lead back to the files.</summary>
        internal string Text { get; private set; }

        internal string VertexEntry { get; private set; }

        internal string FragmentEntry { get; private set; }

        /// <summary>Ten times the shader model.</summary>
        internal int Target { get; private set; } = DefaultTarget;

        /// <summary>The keyword sets, Unity's own for stereo last.</summary>
        internal IReadOnlyList<KeywordSet> KeywordSets => m_Sets;

        /// <summary>Graphics APIs by their name in pragmas; null for all.</summary>
        internal string[] OnlyRenderers { get; private set; }

        internal string[] ExcludedRenderers { get; private set; } = Array.Empty<string>();

        internal bool RunsOn(string renderer) =>
            (OnlyRenderers == null || OnlyRenderers.Contains(renderer)) && !ExcludedRenderers.Contains(renderer);

        /// <summary>Whether a word occurs anywhere in the source.</summary>
        internal bool Mentions(string identifier) => m_Identifiers.Contains(identifier);

        /// <summary>Every choice of one keyword per set.</summary>
        internal IEnumerable<IReadOnlyList<string>> AllVariants()
        {
            IEnumerable<IReadOnlyList<string>> variants = new[] { Array.Empty<string>() };
            foreach (var set in m_Sets)
                variants = variants.SelectMany(v => set.Keywords.Select(k => (IReadOnlyList<string>)(KeywordSet.IsNone(k) ? v : v.Append(k).ToList())));
            return variants;
        }

        /// <exception cref="ShaderCompileException">A pragma makes no sense or asks for what this host cannot do.</exception>
        internal static PassSource Load(ShaderLabFile file, ShaderLabPass pass)
        {
            var source = new PassSource(file, pass);
            foreach (var block in pass.Code.Blocks)
                source.ReadPragmas(file.Path, block.Text, block.Line);
            source.m_Sets.Add(Stereo);
            if (source.VertexEntry == null || source.FragmentEntry == null)
                throw source.Error(file.Path, pass.Line, "the Pass's program needs '#pragma vertex' and '#pragma fragment'");
            var unasked = pass.Code.IsCg ? new[] { "HLSLSupport.cginc", "UnityShaderVariables.cginc" } : Array.Empty<string>();
            source.Text = IncludeExpander.Expand(file.Path, unasked, pass.Code.Blocks);
            foreach (Match match in s_Identifier.Matches(source.Text))
                source.m_Identifiers.Add(match.Value);
            return source;
        }

        void ReadPragmas(string path, string text, int linesBefore)
        {
            var number = linesBefore - 1;
            foreach (var line in text.Split('\n'))
            {
                number++;
                var include = s_IncludeWithPragmas.Match(line);
                if (include.Success && IncludeExpander.Find(include.Groups["path"].Value, path) is { } found)
                    ReadPragmas(found.Path, found.Text, 1);
                var match = s_Pragma.Match(line.TrimEnd('\r'));
                if (match.Success)
                    Read(path, number, match.Groups[1].Value, match.Groups[2].Value.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries));
            }
        }

        void Read(string path, int line, string pragma, string[] words)
        {
            switch (pragma)
            {
                case "vertex": VertexEntry = One(path, line, pragma, words); break;
                case "fragment": FragmentEntry = One(path, line, pragma, words); break;
                case "target": Target = ReadTarget(path, line, One(path, line, pragma, words)); break;
                case "only_renderers": OnlyRenderers = words; break;
                case "exclude_renderers": ExcludedRenderers = words; break;
                case "surface" or "geometry" or "hull" or "domain" or "raytracing":
                    throw Error(path, line, $"'#pragma {pragma}' is not supported by this host");
                default:
                    if (pragma.StartsWith("multi_compile", StringComparison.Ordinal) || pragma.StartsWith("shader_feature", StringComparison.Ordinal))
                        ReadKeywords(path, line, pragma, words);
                    break;
            }
        }

        void ReadKeywords(string path, int line, string pragma, string[] words)
        {
            if (s_Shortcuts.TryGetValue(pragma, out var shortcut))
            {
                m_Sets.Add(new KeywordSet(shortcut, local: false));
                return;
            }
            var match = Regex.Match(pragma, @"^(multi_compile|shader_feature)(_local)?(_vertex|_fragment)?$");
            if (!match.Success)
                throw Error(path, line, $"'#pragma {pragma}' is not supported by this host");
            if (words.Length == 0)
                throw Error(path, line, $"'#pragma {pragma}' names no keyword");
            // One keyword alone is a feature that is on or off.
            var keywords = words.Length == 1 && match.Groups[1].Value == "shader_feature" ? new[] { "_", words[0] } : words;
            m_Sets.Add(new KeywordSet(keywords, match.Groups[2].Success));
        }

        int ReadTarget(string path, int line, string text)
        {
            if (!float.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var model) || model is < 2f or > 5f)
                throw Error(path, line, $"'#pragma target {text}' is no shader model from 2.0 to 5.0");
            return Mathf.RoundToInt(model * 10f);
        }

        string One(string path, int line, string pragma, string[] words) =>
            words.Length == 1 ? words[0] : throw Error(path, line, $"'#pragma {pragma}' takes one word");

        ShaderCompileException Error(string path, int line, string problem) =>
            new(string.Format(CultureInfo.InvariantCulture, "Shader error in '{0}': {1} at {2}({3})", File.Name, problem, path, line));
    }
}
