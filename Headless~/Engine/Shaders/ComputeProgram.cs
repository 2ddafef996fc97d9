using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Shaders
{
    /// <summary>What all copies of a ComputeShader share: source and compiled variants.</summary>
    sealed class ComputeProgram
    {
        readonly Dictionary<string, KernelVariant> m_Variants = new();
        readonly HashSet<string> m_Keywords = new();

        internal ComputeProgram(ComputeSource source)
        {
            Source = source;
            Keywords = source.KeywordSets.SelectMany(s => s.Keywords).Where(k => !KeywordSet.IsNone(k)).Distinct().ToList();
            m_Keywords.UnionWith(Keywords);
        }

        internal ComputeSource Source { get; }

        /// <summary>All keywords, in order of declaration.</summary>
        internal IReadOnlyList<string> Keywords { get; }

        internal bool HasKeyword(string name) => m_Keywords.Contains(name);

        internal int KernelIndex(string name)
        {
            for (var i = 0; i < Source.Kernels.Count; i++)
                if (Source.Kernels[i].Name == name)
                    return i;
            return -1;
        }

        /// <summary>Whether some variant of the kernel is known to run; then bindings need not wait for the present one.</summary>
        internal bool IsKnownToRun(int kernel)
        {
            var prefix = kernel + " ";
            return m_Variants.Any(v => v.Value.Runs && v.Key.StartsWith(prefix, System.StringComparison.Ordinal));
        }

        /// <summary>The variant that fits the enabled keywords: the first enabled one of each set; a set without a "none" falls back to its first.</summary>
        internal KernelVariant Variant(int kernel, ISet<string> local, ISet<string> global)
        {
            var chosen = new List<string>();
            foreach (var set in Source.KeywordSets)
            {
                var keyword = set.Keywords.FirstOrDefault(k => local.Contains(k) || (!set.IsLocal && global.Contains(k)));
                if (keyword == null && set.Keywords.Count > 1 && !set.Keywords.Any(KeywordSet.IsNone))
                    keyword = set.Keywords[0];
                if (keyword != null && !KeywordSet.IsNone(keyword))
                    chosen.Add(keyword);
            }
            var key = kernel + " " + string.Join(" ", chosen);
            if (!m_Variants.TryGetValue(key, out var variant))
            {
                variant = new KernelVariant(Source, Source.Kernels[kernel], chosen);
                m_Variants.Add(key, variant);
            }
            return variant;
        }
    }
}
