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
        readonly RenderBuffer m_Buffer;

        public RenderTargetIdentifier(BuiltinRenderTextureType type) : this(type, 0)
        {
        }

        public RenderTargetIdentifier(BuiltinRenderTextureType type, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
            : this(type, 0, null, default, mipLevel, cubeFace, depthSlice)
        {
        }

        public RenderTargetIdentifier(Texture tex) : this(tex, 0)
        {
        }

        /// <param name="tex">The texture.</param>
        /// <param name="mipLevel">The level.</param>
        /// <param name="cubeFace">Unknown: there are no cube maps here.</param>
        /// <param name="depthSlice">The slice; <see cref="AllDepthSlices"/> for all.</param>
        public RenderTargetIdentifier(Texture tex, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
            : this(tex == null ? BuiltinRenderTextureType.None : BuiltinRenderTextureType.BindableTexture, 0, tex, default, mipLevel, cubeFace, depthSlice)
        {
        }

        public RenderTargetIdentifier(int nameID) : this(nameID, 0)
        {
        }

        public RenderTargetIdentifier(int nameID, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
            : this(BuiltinRenderTextureType.PropertyName, nameID, null, default, mipLevel, cubeFace, depthSlice)
        {
        }

        public RenderTargetIdentifier(string name) : this(Shader.PropertyToID(name))
        {
        }

        public RenderTargetIdentifier(RenderBuffer buf, int mipLevel = 0, CubemapFace cubeFace = CubemapFace.Unknown, int depthSlice = 0)
            : this(BuiltinRenderTextureType.BufferPtr, 0, null, buf, mipLevel, cubeFace, depthSlice)
        {
        }

        public RenderTargetIdentifier(RenderTargetIdentifier renderTargetIdentifier, int mipLevel, CubemapFace cubeFace = CubemapFace.Unknown,
            int depthSlice = 0)
            : this(renderTargetIdentifier.m_Type, renderTargetIdentifier.m_NameId, renderTargetIdentifier.m_Texture, renderTargetIdentifier.m_Buffer,
                mipLevel, cubeFace, depthSlice)
        {
        }

        RenderTargetIdentifier(BuiltinRenderTextureType type, int nameId, Texture texture, RenderBuffer buffer, int mip, CubemapFace face, int slice)
        {
            (m_Type, m_NameId, m_Texture, m_Buffer) = (type, nameId, texture, buffer);
            (Mip, Face, Slice) = (mip, face, slice);
        }

        internal readonly int Mip;
        internal readonly CubemapFace Face;
        internal readonly int Slice;

        internal readonly bool IsNone => m_Type == BuiltinRenderTextureType.None;

        /// <summary>The target of drawing that is meant now; null for the screen.</summary>
        /// <exception cref="ArgumentException">It is no render target.</exception>
        internal readonly RenderTexture ResolveTarget()
        {
            switch (m_Type)
            {
                case BuiltinRenderTextureType.CameraTarget:
                    return Camera.current != null ? Camera.current.targetTexture : null;
                case BuiltinRenderTextureType.CurrentActive:
                    return DrawTargets.Color;
                default:
                    var texture = Resolve();
                    return texture as RenderTexture ?? throw new ArgumentException($"{this} cannot be drawn into");
            }
        }

        /// <summary>The texture that is meant now; null if there is none.</summary>
        internal readonly Texture Resolve() => m_Type switch
        {
            BuiltinRenderTextureType.BindableTexture => m_Texture,
            BuiltinRenderTextureType.BufferPtr => m_Buffer.Owner,
            BuiltinRenderTextureType.CurrentActive => DrawTargets.Color,
            BuiltinRenderTextureType.CameraTarget => Camera.current != null ? Camera.current.targetTexture : null,
            BuiltinRenderTextureType.PropertyName => Shader.GetGlobalTexture(m_NameId),
            _ => null,
        };

        public static implicit operator RenderTargetIdentifier(BuiltinRenderTextureType type) => new(type);

        public static implicit operator RenderTargetIdentifier(string name) => new(name);

        public static implicit operator RenderTargetIdentifier(int nameID) => new(nameID);

        public static implicit operator RenderTargetIdentifier(Texture tex) => new(tex);

        public bool Equals(RenderTargetIdentifier rhs) => m_Type == rhs.m_Type && m_NameId == rhs.m_NameId && ReferenceEquals(m_Texture, rhs.m_Texture)
            && ReferenceEquals(m_Buffer.Owner, rhs.m_Buffer.Owner) && Mip == rhs.Mip && Face == rhs.Face && Slice == rhs.Slice;

        public override bool Equals(object obj) => obj is RenderTargetIdentifier other && Equals(other);

        public override int GetHashCode() => ((int)m_Type * 397 ^ m_NameId) * 397 ^ (m_Texture is null ? 0 : m_Texture.GetHashCode());

        public override string ToString() => $"Type {m_Type} NameID {m_NameId} Texture {(m_Texture is null ? "none" : m_Texture.NameForMessages)}";

        public static bool operator ==(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => lhs.Equals(rhs);

        public static bool operator !=(RenderTargetIdentifier lhs, RenderTargetIdentifier rhs) => !lhs.Equals(rhs);
    }
}
