using System;

namespace UnityEngine.Rendering
{
    /// <summary>A tag's name or value as a number.</summary>
    public struct ShaderTagId : IEquatable<ShaderTagId>
    {
        public static readonly ShaderTagId none = default;

        readonly int m_Id;

        public ShaderTagId(string name) => m_Id = string.IsNullOrEmpty(name) ? 0 : Shader.PropertyToID(name);

        public string name => ShaderGlobals.Name(m_Id) ?? "";

        public override bool Equals(object obj) => obj is ShaderTagId other && Equals(other);

        public bool Equals(ShaderTagId other) => m_Id == other.m_Id;

        public override int GetHashCode() => m_Id;

        public static bool operator ==(ShaderTagId tag1, ShaderTagId tag2) => tag1.Equals(tag2);

        public static bool operator !=(ShaderTagId tag1, ShaderTagId tag2) => !tag1.Equals(tag2);

        public static explicit operator ShaderTagId(string name) => new(name);

        public static explicit operator string(ShaderTagId tagId) => tagId.name;
    }
}
