using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>A texture that the GPU fills. Release frees its memory, Destroy the object.</summary>
    public partial class RenderTexture : Texture
    {
        RenderTextureDescriptor m_Descriptor;

        protected internal RenderTexture()
        {
        }

        /// <exception cref="ArgumentException">The format is not supported, or sizes are out of range.</exception>
        public RenderTexture(RenderTextureDescriptor desc)
        {
            KillUnless(() => Validate(desc));
            Initialize(desc);
        }

        /// <exception cref="ArgumentNullException">Null.</exception>
        public RenderTexture(RenderTexture textureToCopy)
        {
            KillUnless(() => _ = textureToCopy != null ? textureToCopy : throw new ArgumentNullException(nameof(textureToCopy)));
            Initialize(textureToCopy.descriptor);
        }

        /// <param name="width">Texels.</param>
        /// <param name="height">Texels.</param>
        /// <param name="depth">BITS of the depth buffer, not slices.</param>
        public RenderTexture(int width, int height, int depth)
            : this(width, height, depth, RenderTextureFormat.Default, RenderTextureReadWrite.Default)
        {
        }

        public RenderTexture(int width, int height, int depth, RenderTextureFormat format)
            : this(width, height, depth, format, RenderTextureReadWrite.Default)
        {
        }

        public RenderTexture(int width, int height, int depth, RenderTextureFormat format, RenderTextureReadWrite readWrite)
        {
            Initialize(new RenderTextureDescriptor(width, height, format, depth, GenerateAllMips, readWrite));
            RefuseUnsupported();
        }

        public RenderTexture(int width, int height, int depth, RenderTextureFormat format, int mipCount)
        {
            Initialize(new RenderTextureDescriptor(width, height, format, depth, mipCount, RenderTextureReadWrite.Default));
            RefuseUnsupported();
        }

        public RenderTexture(int width, int height, int depth, DefaultFormat format)
            : this(width, height, depth, SystemInfo.GetGraphicsFormat(format))
        {
        }

        public RenderTexture(int width, int height, int depth, GraphicsFormat format)
            : this(width, height, depth, format, GenerateAllMips)
        {
        }

        public RenderTexture(int width, int height, int depth, GraphicsFormat format, int mipCount)
        {
            Initialize(new RenderTextureDescriptor(width, height, format, depth, mipCount));
            RefuseUnsupported();
        }

        public RenderTexture(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat)
            : this(width, height, colorFormat, depthStencilFormat, GenerateAllMips)
        {
        }

        /// <param name="width">Texels.</param>
        /// <param name="height">Texels.</param>
        /// <param name="colorFormat">None for a texture of depth alone.</param>
        /// <param name="depthStencilFormat">None for a texture without depth.</param>
        /// <param name="mipCount">Levels; negative for all that fit.</param>
        public RenderTexture(int width, int height, GraphicsFormat colorFormat, GraphicsFormat depthStencilFormat, int mipCount)
        {
            Initialize(new RenderTextureDescriptor(width, height, colorFormat, depthStencilFormat, mipCount));
            RefuseUnsupported();
        }

        public override int width
        {
            get => m_Descriptor.width;
            set { CheckNotCreated("width"); m_Descriptor.width = value; }
        }

        public override int height
        {
            get => m_Descriptor.height;
            set { CheckNotCreated("height"); m_Descriptor.height = value; }
        }

        public override TextureDimension dimension
        {
            get => m_Descriptor.dimension;
            set { CheckNotCreated("dimension"); m_Descriptor.dimension = value; }
        }

        public new GraphicsFormat graphicsFormat
        {
            get => m_Descriptor.graphicsFormat;
            set { CheckNotCreated("graphicsFormat"); m_Descriptor.graphicsFormat = value; UpdateShape(); }
        }

        public RenderTextureFormat format
        {
            get => m_Descriptor.colorFormat;
            set { CheckNotCreated("format"); m_Descriptor.colorFormat = value; UpdateShape(); }
        }

        /// <summary>Slices of a volume or an array.</summary>
        public int volumeDepth
        {
            get => m_Descriptor.volumeDepth;
            set { CheckNotCreated("volumeDepth"); m_Descriptor.volumeDepth = value; }
        }

        /// <summary>Bits of the depth buffer.</summary>
        public int depth
        {
            get => m_Descriptor.depthBufferBits;
            set { CheckNotCreated("depth"); m_Descriptor.depthBufferBits = value; }
        }

        public GraphicsFormat depthStencilFormat
        {
            get => m_Descriptor.depthStencilFormat;
            set { CheckNotCreated("depthStencilFormat"); m_Descriptor.depthStencilFormat = value; }
        }

        /// <summary>Whether kernels may write it.</summary>
        public bool enableRandomWrite
        {
            get => m_Descriptor.enableRandomWrite;
            set { CheckNotCreated("enableRandomWrite"); m_Descriptor.enableRandomWrite = value; }
        }

        public bool useMipMap
        {
            get => m_Descriptor.useMipMap;
            set { CheckNotCreated("useMipMap"); m_Descriptor.useMipMap = value; }
        }

        public bool autoGenerateMips
        {
            get => m_Descriptor.autoGenerateMips;
            set { CheckNotCreated("autoGenerateMips"); m_Descriptor.autoGenerateMips = value; }
        }

        public int antiAliasing
        {
            get => m_Descriptor.msaaSamples;
            set { CheckNotCreated("antiAliasing"); m_Descriptor.msaaSamples = value; }
        }

        public VRTextureUsage vrUsage
        {
            get => m_Descriptor.vrUsage;
            set => m_Descriptor.vrUsage = value;
        }

        public bool sRGB => m_Descriptor.sRGB;

        public RenderTextureDescriptor descriptor
        {
            get => m_Descriptor;
            set
            {
                CheckNotCreated("descriptor");
                Validate(value);
                m_Descriptor = value;
                UpdateShape();
            }
        }

        internal override int MipCount =>
            m_Descriptor.useMipMap ? TextureShapes.Mips(width, height, IsVolume ? volumeDepth : 1, m_Descriptor.mipCount, true) : 1;

        bool IsVolume => dimension == TextureDimension.Tex3D;

        /// <summary>Makes the memory; its contents are undefined. True if it exists afterwards.</summary>
        public bool Create()
        {
            Use("Create");
            if (Native != null)
                return true;
            var problem = Problem(m_Descriptor);
            if (problem != null)
            {
                Debug.LogError("RenderTexture.Create failed: " + problem);
                return false;
            }
            CreateBuffers();
            return true;
        }

        public bool IsCreated()
        {
            Use("IsCreated");
            return Native != null;
        }

        /// <summary>Frees the memory; the object can be created again.</summary>
        public void Release()
        {
            Use("Release");
            ReleaseNative();
        }

        // A constructor that throws must not leave a living object behind.
        void KillUnless(Action check)
        {
            try
            {
                check();
            }
            catch
            {
                Kill();
                throw;
            }
        }

        static void Validate(in RenderTextureDescriptor desc)
        {
            if (desc.graphicsFormat == GraphicsFormat.None && desc.depthStencilFormat == GraphicsFormat.None)
                throw new ArgumentException("RenderTextureDesc graphicsFormat must be a supported GraphicsFormat. None is not supported.",
                    "desc.graphicsFormat");
            if (desc.graphicsFormat != GraphicsFormat.None && !SystemInfo.IsFormatSupported(desc.graphicsFormat, GraphicsFormatUsage.Render))
                throw new ArgumentException($"RenderTextureDesc graphicsFormat must be a supported GraphicsFormat. {desc.graphicsFormat} is not supported "
                    + "on this platform.", "desc.graphicsFormat");
            if (desc.depthStencilFormat != GraphicsFormat.None && !SystemInfo.IsFormatSupported(desc.depthStencilFormat, GraphicsFormatUsage.Render))
                throw new ArgumentException($"RenderTextureDesc depthStencilFormat must be a supported GraphicsFormat. {desc.depthStencilFormat} is not "
                    + "supported on this platform.", "desc.depthStencilFormat");
            if (desc.width <= 0)
                throw new ArgumentException("RenderTextureDesc width must be greater than zero.", "desc.width");
            if (desc.height <= 0)
                throw new ArgumentException("RenderTextureDesc height must be greater than zero.", "desc.height");
            if (desc.volumeDepth <= 0)
                throw new ArgumentException("RenderTextureDesc volumeDepth must be greater than zero.", "desc.volumeDepth");
            if (desc.msaaSamples is not (1 or 2 or 4 or 8))
                throw new ArgumentException("RenderTextureDesc msaaSamples must be 1, 2, 4, or 8.", "desc.msaaSamples");
        }

        static string Problem(in RenderTextureDescriptor d)
        {
            if (d.dimension is not (TextureDimension.Tex2D or TextureDimension.Tex2DArray or TextureDimension.Tex3D))
                return $"the dimension {d.dimension} is not supported by this host.";
            var max = d.dimension == TextureDimension.Tex3D ? SystemInfo.maxTexture3DSize : SystemInfo.maxTextureSize;
            if (d.width <= 0 || d.height <= 0 || d.volumeDepth <= 0 || d.width > max || d.height > max || d.volumeDepth > max)
                return $"{d.width} x {d.height} x {d.volumeDepth} is outside 1 to {max} per axis.";
            if (d.graphicsFormat == GraphicsFormat.None && d.depthStencilFormat == GraphicsFormat.None)
                return "there is neither a colour nor a depth format.";
            if (d.graphicsFormat != GraphicsFormat.None && !SystemInfo.IsFormatSupported(d.graphicsFormat, GraphicsFormatUsage.Render))
                return $"format {d.graphicsFormat} is not supported.";
            if (d.enableRandomWrite && !SystemInfo.IsFormatSupported(d.graphicsFormat, GraphicsFormatUsage.LoadStore))
                return $"format {d.graphicsFormat} does not support random writes.";
            if (d.depthStencilFormat != GraphicsFormat.None && d.dimension == TextureDimension.Tex3D)
                return "a volume has no depth buffer in this host.";
            return d.enableRandomWrite && d.msaaSamples > 1 ? "a multisampled texture cannot be random-write." : ProblemOfSamples(d);
        }

        void Initialize(in RenderTextureDescriptor desc)
        {
            m_Descriptor = desc;
            UpdateShape();
        }

        void RefuseUnsupported()
        {
            var (color, depth) = (m_Descriptor.graphicsFormat, m_Descriptor.depthStencilFormat);
            RefuseUnsupported(color != GraphicsFormat.None || depth == GraphicsFormat.None ? color : depth, GraphicsFormatUsage.Render);
        }

        void UpdateShape() => SetShape(m_Descriptor.width, m_Descriptor.height, m_Descriptor.dimension, m_Descriptor.graphicsFormat, TextureWrapMode.Clamp);

        void CheckNotCreated(string property)
        {
            Use("set_" + property);
            if (Native != null)
                Debug.LogError($"Setting {property} of already created render texture is not supported!");
        }
    }
}
