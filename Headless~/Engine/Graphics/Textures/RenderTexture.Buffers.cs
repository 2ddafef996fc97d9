using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>The colour or the depth of a render texture; the default value is the screen's.</summary>
    public struct RenderBuffer
    {
        internal RenderBuffer(RenderTexture owner, bool isDepth)
        {
            Owner = owner;
            IsDepth = isDepth;
        }

        /// <summary>Null for the screen.</summary>
        internal RenderTexture Owner { get; }

        internal bool IsDepth { get; }
    }

    public partial class RenderTexture
    {
        GpuTexture m_Color;
        GpuTexture m_Multisampled;
        GpuTexture m_Depth;

        public RenderBuffer colorBuffer => new(this, false);

        public RenderBuffer depthBuffer => new(this, true);

        /// <summary>What shaders read: the colour, or the depth where there is no colour.</summary>
        internal override GpuTexture Native => Alive(m_Color) ?? (m_Color == null ? Alive(m_Depth) : null);

        /// <summary>Null for a texture of depth alone.</summary>
        internal GpuTexture ColorNative => Alive(m_Color);

        /// <summary>Several samples per texel, from which the colour is resolved when a pass ends; null if there is one.</summary>
        internal GpuTexture MultisampledNative => Alive(m_Multisampled);

        internal GpuTexture DepthNative => Alive(m_Depth);

        int Layers => dimension == TextureDimension.Tex2DArray ? volumeDepth : 1;

        /// <summary>Declares the contents undefined.</summary>
        public void DiscardContents() => DiscardContents(true, true);

        public void DiscardContents(bool discardColor, bool discardDepth)
        {
            Use("DiscardContents");
            if (discardColor)
            {
                ColorNative?.FillUndefined();
                MultisampledNative?.FillUndefined();
            }
            if (discardDepth)
                DepthNative?.FillUndefined();
        }

        private protected override void ReleaseNative()
        {
            m_Color?.Release();
            m_Multisampled?.Release();
            m_Depth?.Release();
            m_Color = m_Multisampled = m_Depth = null;
            DrawTargets.Drop(this);
        }

        void CreateBuffers()
        {
            var (color, depth) = (graphicsFormat, depthStencilFormat);
            var array = dimension == TextureDimension.Tex2DArray;
            var shape = new ImageShape(width, height, IsVolume ? volumeDepth : 1, Layers, MipCount, IsVolume, array);
            var samples = antiAliasing;
            if (color != GraphicsFormat.None)
                m_Color = Buffer("RenderTexture", shape, color, enableRandomWrite, 1);
            if (color != GraphicsFormat.None && samples > 1)
                m_Multisampled = Buffer("RenderTexture's samples", shape, color, false, samples);
            if (depth != GraphicsFormat.None)
                m_Depth = Buffer("RenderTexture's depth", new ImageShape(width, height, 1, Layers, 1, false, array), depth, false, samples);
        }

        GpuTexture Buffer(string kind, in ImageShape shape, GraphicsFormat format, bool randomWrite, int samples)
        {
            var buffer = new GpuTexture(kind, NameForMessages, shape, FormatInfo.Of(format), randomWrite, target: !IsVolume, samples);
            buffer.FillUndefined();
            return buffer;
        }

        static string ProblemOfSamples(in RenderTextureDescriptor d)
        {
            if (d.msaaSamples <= 1)
                return null;
            if (d.dimension == TextureDimension.Tex3D || d.useMipMap)
                return "a multisampled texture is neither a volume nor has it mip levels.";
            if (d.graphicsFormat == GraphicsFormat.None)
                return "a multisampled texture of depth alone could not be read, and is not supported by this host.";
            var supported = SystemInfo.GetRenderTextureSupportedMSAASampleCount(d);
            return supported == d.msaaSamples ? null
                : $"{d.msaaSamples} samples per texel are not supported here, {supported} are; ask SystemInfo.GetRenderTextureSupportedMSAASampleCount.";
        }

        static GpuTexture Alive(GpuTexture texture) => texture is { IsAlive: true } ? texture : null;
    }
}
