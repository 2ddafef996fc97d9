using System;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public partial class Material
    {
        public LocalKeyword[] enabledKeywords
        {
            get => Array.ConvertAll(shaderKeywords, n => new LocalKeyword(m_Shader.keywordSpace, n));
            set => shaderKeywords = Array.ConvertAll(value, k => k.name);
        }

        /// <summary>Names of the keywords that are on.</summary>
        public string[] shaderKeywords
        {
            get
            {
                Use("get_shaderKeywords");
                return m_Keywords.OrderBy(k => k, StringComparer.Ordinal).ToArray();
            }
            set
            {
                Use("set_shaderKeywords");
                m_Keywords.Clear();
                foreach (var name in value ?? Array.Empty<string>())
                    EnableKeyword(name);
            }
        }

        /// <summary>Turns a keyword on; names that the shader does not declare are kept for another one.</summary>
        public void EnableKeyword(string keyword)
        {
            Use("EnableKeyword");
            m_Keywords.Add(keyword ?? throw new ArgumentNullException(nameof(keyword)));
            if (!m_Shader.KeywordsOfAll.HasKeyword(keyword))
                WarnOnce($"it declares no keyword '{keyword}'; Unity ignores that silently");
        }

        public void DisableKeyword(string keyword)
        {
            Use("DisableKeyword");
            m_Keywords.Remove(keyword);
        }

        public bool IsKeywordEnabled(string keyword)
        {
            Use("IsKeywordEnabled");
            return m_Keywords.Contains(keyword);
        }

        public void EnableKeyword(in LocalKeyword keyword) => SetKeyword(keyword, true);

        public void DisableKeyword(in LocalKeyword keyword) => SetKeyword(keyword, false);

        public bool IsKeywordEnabled(in LocalKeyword keyword) => keyword.isValid && IsKeywordEnabled(keyword.name);

        /// <exception cref="ArgumentException">The keyword is not one of this shader's.</exception>
        public void SetKeyword(in LocalKeyword keyword, bool value)
        {
            Use("SetKeyword");
            if (!m_Shader.KeywordsOfAll.HasKeyword(keyword.name ?? ""))
                throw new ArgumentException($"Keyword '{keyword.name}' is not one of shader '{m_Shader.NameForMessages}'");
            if (value)
                m_Keywords.Add(keyword.name);
            else
                m_Keywords.Remove(keyword.name);
        }
    }
}
