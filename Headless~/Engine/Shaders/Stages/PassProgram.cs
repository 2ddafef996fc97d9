using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Shaders
{
    /// <summary>A pass with the variants of it that were asked for.</summary>
    sealed class PassProgram
    {
        readonly ShaderLabFile m_File;
        readonly Dictionary<string, PassVariant> m_Variants = new();
        PassSource m_Source;
        bool m_Loaded;

        internal PassProgram(ShaderLabFile file, ShaderLabPass pass)
        {
            m_File = file;
            Pass = pass;
        }

        internal ShaderLabPass Pass { get; }

        /// <summary>Null if its pragmas make no sense, which is logged once.</summary>
        internal PassSource Source
        {
            get
            {
                if (m_Loaded)
                    return m_Source;
                m_Loaded = true;
                try
                {
                    m_Source = PassSource.Load(m_File, Pass);
                }
                catch (ShaderCompileException e)
                {
                    Debug.LogError(e.Message);
                }
                return m_Source;
            }
        }

        /// <summary>The variant that fits the enabled keywords; null if there is no source.</summary>
        internal PassVariant Variant(ICollection<string> local, ICollection<string> global)
        {
            if (Source == null)
                return null;
            var chosen = KeywordChoice.Of(Source.KeywordSets, local, global);
            var key = string.Join(" ", chosen);
            if (!m_Variants.TryGetValue(key, out var variant))
                m_Variants.Add(key, variant = new PassVariant(Source, chosen));
            return variant;
        }
    }

    /// <summary>The SubShader of a shader that is drawn here, now.</summary>
    sealed class SubShaderProgram
    {
        internal SubShaderProgram(ShaderLabFile file, ShaderLabSubShader subShader)
        {
            SubShader = subShader;
            Passes = subShader.Passes.Select(p => new PassProgram(file, p)).ToList();
        }

        internal ShaderLabSubShader SubShader { get; }

        internal IReadOnlyList<PassProgram> Passes { get; }

        /// <summary>Whether tag, packages, level of detail and graphics API let it be used.</summary>
        internal bool Fits(string pipelineTag, int maximumLod, string renderer)
        {
            var tag = SubShader.Tag("RenderPipeline");
            return (tag.Length == 0 || tag == pipelineTag) && SubShader.Lod <= maximumLod && ShaderEnvironment.Meets(SubShader)
                && Passes.All(p => p.Source == null || p.Source.RunsOn(renderer));
        }
    }

    /// <summary>The keywords of all passes of a shader.</summary>
    sealed class ShaderKeywords : KeywordOwner
    {
        internal ShaderKeywords(IEnumerable<PassProgram> passes)
            : base(passes.Where(p => p.Source != null).SelectMany(p => p.Source.KeywordSets).Where(s => s != PassSource.Stereo))
        {
        }
    }
}
