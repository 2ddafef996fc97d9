using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Everything that makes a render texture.</summary>
    public struct RenderTextureDescriptor
    {
        RenderTextureCreationFlags m_Flags;

        public RenderTextureDescriptor(int width, int height) : this(width, height, RenderTextureFormat.Default, 0)
        {
        }

        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat) : this(width, height, colorFormat, 0)
        {
        }

        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits)
            : this(width, height, colorFormat, depthBufferBits, Texture.GenerateAllMips)
        {
        }

        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits, int mipCount)
            : this(width, height, colorFormat, depthBufferBits, mipCount, RenderTextureReadWrite.Linear)
        {
        }

        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits, int mipCount,
            RenderTextureReadWrite readWrite)
            : this(width, height, GraphicsFormatUtility.GetGraphicsFormat(colorFormat, readWrite), DepthFormat(colorFormat, depthBufferBits), mipCount)
        {
        }

        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits)
            : this(width, height, colorFormat, depthBufferBits, Texture.GenerateAllMips)
        {
        }

        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits, int mipCount)
            : this(width, height, colorFormat, DepthFormat(colorFormat, depthBufferBits), mipCount)
        {
        }

        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat)
            : this(width, height, colorFormat, depthStencilFormat, Texture.GenerateAllMips)
        {
        }

        /// <param name="width">Texels.</param>
        /// <param name="height">Texels.</param>
        /// <param name="colorFormat">None for a texture of depth alone.</param>
        /// <param name="depthStencilFormat">None for a texture without depth.</param>
        /// <param name="mipCount">Levels; negative for all that fit.</param>
        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat, int mipCount)
            : this()
        {
            m_Flags = RenderTextureCreationFlags.AutoGenerateMips | RenderTextureCreationFlags.AllowVerticalFlip;
            this.width = width;
            this.height = height;
            volumeDepth = 1;
            msaaSamples = 1;
            dimension = TextureDimension.Tex2D;
            graphicsFormat = colorFormat;
            this.depthStencilFormat = depthStencilFormat;
            this.mipCount = mipCount;
        }

        public int width { get; set; }

        public int height { get; set; }

        /// <summary>Slices of a volume or an array; 1 otherwise.</summary>
        public int volumeDepth { get; set; }

        public int msaaSamples { get; set; }

        public TextureDimension dimension { get; set; }

        public GraphicsFormat graphicsFormat { get; set; }

        /// <summary>The depth buffer's format, or None.</summary>
        public GraphicsFormat depthStencilFormat { get; set; }

        public RenderTextureFormat colorFormat
        {
            get => graphicsFormat == GraphicsFormat.None && depthStencilFormat != GraphicsFormat.None ? RenderTextureFormat.Depth
                : FormatTables.ToRenderTextureFormat(graphicsFormat);
            set
            {
                graphicsFormat = FormatTables.Of(value, sRGB);
                if (value == RenderTextureFormat.Depth && depthStencilFormat == GraphicsFormat.None)
                    depthStencilFormat = DepthFormat(value, 0);
            }
        }

        public bool sRGB
        {
            readonly get => GraphicsFormatUtility.IsSRGBFormat(graphicsFormat);
            set => graphicsFormat = value ? FormatTables.ToSRGB(graphicsFormat) : FormatTables.ToLinear(graphicsFormat);
        }

        /// <summary>Bits of the depth buffer: the format follows, with stencil above 16 beside a colour format.</summary>
        public int depthBufferBits
        {
            readonly get => GraphicsFormatUtility.GetDepthBits(depthStencilFormat);
            set => depthStencilFormat = DepthFormat(graphicsFormat, value);
        }

        /// <summary>Levels; negative for all that fit. Counts only with <see cref="useMipMap"/>.</summary>
        public int mipCount { get; set; }

        public RenderTextureMemoryless memoryless { get; set; }

        public VRTextureUsage vrUsage { get; set; }

        public RenderTextureCreationFlags flags => m_Flags;

        public bool useMipMap
        {
            get => Has(RenderTextureCreationFlags.MipMap);
            set => Set(RenderTextureCreationFlags.MipMap, value);
        }

        public bool autoGenerateMips
        {
            get => Has(RenderTextureCreationFlags.AutoGenerateMips);
            set => Set(RenderTextureCreationFlags.AutoGenerateMips, value);
        }

        /// <summary>Whether kernels may write it.</summary>
        public bool enableRandomWrite
        {
            get => Has(RenderTextureCreationFlags.EnableRandomWrite);
            set => Set(RenderTextureCreationFlags.EnableRandomWrite, value);
        }

        static GraphicsFormat DepthFormat(GraphicsFormat colorFormat, int bits) =>
            bits <= 0 ? GraphicsFormat.None
                : colorFormat == GraphicsFormat.None ? GraphicsFormatUtility.GetDepthStencilFormat(bits, 0) : GraphicsFormatUtility.GetDepthStencilFormat(bits);

        // A texture of depth alone has a depth buffer, whatever was asked for.
        static GraphicsFormat DepthFormat(RenderTextureFormat colorFormat, int bits) =>
            colorFormat == RenderTextureFormat.Depth ? GraphicsFormatUtility.GetDepthStencilFormat(bits > 0 ? bits : 32, 0)
                : DepthFormat(FormatTables.Of(colorFormat, false), bits);

        readonly bool Has(RenderTextureCreationFlags flag) => (m_Flags & flag) != 0;

        void Set(RenderTextureCreationFlags flag, bool on) => m_Flags = on ? m_Flags | flag : m_Flags & ~flag;
    }
}
