using System;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed partial class ComputeShader
    {
        public LocalKeywordSpace keywordSpace
        {
            get { Use("get_keywordSpace"); return new LocalKeywordSpace(Program); }
        }

        public LocalKeyword[] enabledKeywords
        {
            get => Array.ConvertAll(shaderKeywords, n => new LocalKeyword(keywordSpace, n));
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

        /// <summary>Turns a keyword on; names that the shader does not declare are let pass.</summary>
        public void EnableKeyword(string keyword)
        {
            Use("EnableKeyword");
            if (Program.HasKeyword(keyword))
                m_Keywords.Add(keyword);
            else
                WarnOnce($"it declares no keyword '{keyword}'; Unity ignores that silently");
        }

        public void DisableKeyword(string keyword)
        {
            Use("DisableKeyword");
            if (!m_Keywords.Remove(keyword) && !Program.HasKeyword(keyword))
                WarnOnce($"it declares no keyword '{keyword}'; Unity ignores that silently");
        }

        public bool IsKeywordEnabled(string keyword)
        {
            Use("IsKeywordEnabled");
            return m_Keywords.Contains(keyword);
        }

        public void EnableKeyword(in LocalKeyword keyword) => SetKeyword(keyword, true);

        public void DisableKeyword(in LocalKeyword keyword) => SetKeyword(keyword, false);

        public bool IsKeywordEnabled(in LocalKeyword keyword)
        {
            Use("IsKeywordEnabled");
            return keyword.isValid && m_Keywords.Contains(keyword.name);
        }

        /// <exception cref="ArgumentException">The keyword is not one of this shader's.</exception>
        public void SetKeyword(in LocalKeyword keyword, bool value)
        {
            Use("SetKeyword");
            if (!Program.HasKeyword(keyword.name ?? ""))
                throw new ArgumentException($"Keyword '{keyword.name}' is not one of compute shader '{NameForMessages}'");
            if (value)
                m_Keywords.Add(keyword.name);
            else
                m_Keywords.Remove(keyword.name);
        }
    }
}
