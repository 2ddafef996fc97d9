using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Everything that makes a render texture.</summary>
    public struct RenderTextureDescriptor
    {
        RenderTextureCreationFlags m_Flags;
        int m_DepthBits;

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
            : this(width, height, FormatTables.Of(colorFormat, false), depthBufferBits, mipCount)
        {
        }

        public RenderTextureDescriptor(int width, int height, RenderTextureFormat colorFormat, int depthBufferBits, int mipCount,
            RenderTextureReadWrite readWrite)
            : this(width, height, GraphicsFormatUtility.GetGraphicsFormat(colorFormat, readWrite), depthBufferBits, mipCount)
        {
        }

        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits)
            : this(width, height, colorFormat, depthBufferBits, Texture.GenerateAllMips)
        {
        }

        public RenderTextureDescriptor(int width, int height, GraphicsFormat colorFormat, int depthBufferBits, int mipCount)
            : this()
        {
            m_Flags = RenderTextureCreationFlags.AutoGenerateMips | RenderTextureCreationFlags.AllowVerticalFlip;
            this.width = width;
            this.height = height;
            volumeDepth = 1;
            msaaSamples = 1;
            dimension = TextureDimension.Tex2D;
            graphicsFormat = colorFormat;
            this.depthBufferBits = depthBufferBits;
            this.mipCount = mipCount;
        }

        public int width { get; set; }

        public int height { get; set; }

        /// <summary>Slices of a volume or an array; 1 otherwise.</summary>
        public int volumeDepth { get; set; }

        public int msaaSamples { get; set; }

        public TextureDimension dimension { get; set; }

        public GraphicsFormat graphicsFormat { get; set; }

        public RenderTextureFormat colorFormat
        {
            get => FormatTables.ToRenderTextureFormat(graphicsFormat);
            set => graphicsFormat = FormatTables.Of(value, sRGB);
        }

        public bool sRGB
        {
            readonly get => GraphicsFormatUtility.IsSRGBFormat(graphicsFormat);
            set => graphicsFormat = value ? FormatTables.ToSRGB(graphicsFormat) : FormatTables.ToLinear(graphicsFormat);
        }

        public int depthBufferBits
        {
            readonly get => m_DepthBits;
            set => m_DepthBits = value;
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

        readonly bool Has(RenderTextureCreationFlags flag) => (m_Flags & flag) != 0;

        void Set(RenderTextureCreationFlags flag, bool on) => m_Flags = on ? m_Flags | flag : m_Flags & ~flag;
    }
}
