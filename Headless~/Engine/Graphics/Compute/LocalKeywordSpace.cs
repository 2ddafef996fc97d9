using System;
using System.Linq;
using UnityEngine.Shaders;

namespace UnityEngine.Rendering
{
    /// <summary>The keywords that a shader declares.</summary>
    public readonly struct LocalKeywordSpace : IEquatable<LocalKeywordSpace>
    {
        readonly KeywordOwner m_Program;

        internal LocalKeywordSpace(KeywordOwner program) => m_Program = program;

        public uint keywordCount => (uint)(m_Program?.Keywords.Count ?? 0);

        public string[] keywordNames => m_Program?.Keywords.ToArray() ?? Array.Empty<string>();

        public LocalKeyword[] keywords => Array.ConvertAll(keywordNames, FindKeyword);

        /// <summary>The keyword; invalid if there is none of that name.</summary>
        public LocalKeyword FindKeyword(string name) => new(this, name);

        internal bool Has(string name) => m_Program != null && m_Program.HasKeyword(name);

        internal bool IsOverridable(string name) => m_Program.IsOverridable(name);

        public bool Equals(LocalKeywordSpace rhs) => ReferenceEquals(m_Program, rhs.m_Program);

        public override bool Equals(object o) => o is LocalKeywordSpace other && Equals(other);

        public override int GetHashCode() => m_Program?.GetHashCode() ?? 0;

        public static bool operator ==(LocalKeywordSpace lhs, LocalKeywordSpace rhs) => lhs.Equals(rhs);

        public static bool operator !=(LocalKeywordSpace lhs, LocalKeywordSpace rhs) => !lhs.Equals(rhs);
    }
}
