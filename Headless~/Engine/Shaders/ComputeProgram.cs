using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Shaders
{
    /// <summary>What all copies of a ComputeShader share: source and compiled variants.</summary>
    sealed class ComputeProgram : KeywordOwner
    {
        readonly Dictionary<string, KernelVariant> m_Variants = new();

        internal ComputeProgram(ComputeSource source) : base(source.KeywordSets) => Source = source;

        internal ComputeSource Source { get; }

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

        /// <summary>The variant that fits the enabled keywords.</summary>
        internal KernelVariant Variant(int kernel, ISet<string> local, ISet<string> global)
        {
            var chosen = KeywordChoice.Of(Source.KeywordSets, local, global);
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
