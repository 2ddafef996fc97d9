using System;

namespace UnityEngine.Rendering
{
    /// <summary>A texture in a command buffer: an object, or the name of a global one.</summary>
    public struct RenderTargetIdentifier : IEquatable<RenderTargetIdentifier>
    {
        public const int AllDepthSlices = -1;

        readonly BuiltinRenderTextureType m_Type;
        readonly int m_NameId;
        readonly Texture m_Texture;

        public RenderTargetIdentifier(BuiltinRenderTextureType type)
        {
            m_Type = type;
            m_NameId = 0;
            m_Texture = null;
        }

        public RenderTargetIdentifier(Texture tex)
        {
            m_Type = tex == null ? BuiltinRenderTextureType.None : BuiltinRenderTextureType.BindableTexture;
            m_NameId = 0;
            m_Texture = tex;
        }

        public RenderTargetIdentifier(int nameID)
        {
            m_Type = BuiltinRenderTextureType.PropertyName;
            m_NameId = nameID;
            m_Texture = null;
        }

        public RenderTargetIdentifier(string name) : this(Shader.PropertyToID(name))
        {
        }

        /// <summary>The texture that is meant now; null if there is none.</summary>
        internal Texture Resolve() => m_Type switch
        {
            BuiltinRenderTextureType.BindableTexture => m_Texture,
            BuiltinRenderTextureType.PropertyName => Shader.GetGlobalTexture(m_NameId),
            _ => null,
        };

        public static implicit operator RenderTargetIdentifier(BuiltinRenderTextureType type) => new(type);

        public static implicit operator RenderTargetIdentifier(string name) => new(name);

        public static implicit operator RenderTargetIdentifier(int nameID) => new(nameID);

        public static implicit operator RenderTargetIdentifier(Texture tex) => new(tex);

        public bool Equals(RenderTargetIdentifier rhs) => m_Type == rhs.m_Type && m_NameId == rhs.m_NameId && ReferenceEquals(m_Texture, rhs.m_Texture);

        public override bool Equals(object obj) => obj is RenderTargetIdentifier other && Equals(other);

        public override int GetHashCode() => ((int)m_Type * 397 ^ m_NameId) * 397 ^ (m_Texture is null ? 0 : m_Texture.GetHashCode());

        public override string ToString() => $"Type {m_Type} NameID {m_NameId} Texture {(m_Texture is null ? "none" : m_Texture.NameForMessages)}";

        public static bool operator ==(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => lhs.Equals(rhs);

        public static bool operator !=(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => !lhs.Equals(rhs);
    }
}
