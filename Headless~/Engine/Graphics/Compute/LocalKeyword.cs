using System;

namespace UnityEngine.Rendering
{
    /// <summary>A keyword of one shader.</summary>
    public readonly struct LocalKeyword : IEquatable<LocalKeyword>
    {
        readonly LocalKeywordSpace m_Space;
        readonly string m_Name;

        /// <summary>Logs an error and stays invalid if the shader has no such keyword.</summary>
        /// <exception cref="ArgumentException">No shader, or no name.</exception>
        public LocalKeyword(ComputeShader shader, string name)
        {
            if (shader == null)
                throw new ArgumentException("Cannot initialize a LocalKeyword with a null ComputeShader.");
            if (name == null)
                throw new ArgumentException("Cannot initialize a LocalKeyword with a null name.");
            m_Space = shader.keywordSpace;
            m_Name = name;
            if (!isValid)
                Debug.LogErrorFormat("Local keyword {0} doesn't exist in the shader.", name);
        }

        /// <summary>Logs an error and stays invalid if the shader has no such keyword.</summary>
        /// <exception cref="ArgumentException">No shader, or no name.</exception>
        public LocalKeyword(Shader shader, string name)
        {
            if (shader == null)
                throw new ArgumentException("Cannot initialize a LocalKeyword with a null Shader.");
            if (name == null)
                throw new ArgumentException("Cannot initialize a LocalKeyword with a null name.");
            m_Space = shader.keywordSpace;
            m_Name = name;
            if (!isValid)
                Debug.LogErrorFormat("Local keyword {0} doesn't exist in the shader.", name);
        }

        internal LocalKeyword(LocalKeywordSpace space, string name)
        {
            m_Space = space;
            m_Name = name;
        }

        public string name => m_Name;

        public bool isValid => m_Name != null && m_Space.Has(m_Name);

        public bool isOverridable => isValid && m_Space.IsOverridable(m_Name);

        public bool isDynamic => false;

        public ShaderKeywordType type => isValid ? ShaderKeywordType.UserDefined : ShaderKeywordType.None;

        public bool Equals(LocalKeyword rhs) => m_Space == rhs.m_Space && m_Name == rhs.m_Name;

        public override bool Equals(object o) => o is LocalKeyword other && Equals(other);

        public override int GetHashCode() => m_Name?.GetHashCode(StringComparison.Ordinal) ?? 0;

        public override string ToString() => m_Name;

        public static bool operator ==(LocalKeyword lhs, LocalKeyword rhs) => lhs.Equals(rhs);

        public static bool operator !=(LocalKeyword lhs, LocalKeyword rhs) => !lhs.Equals(rhs);
    }
}
