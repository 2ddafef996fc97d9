using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>What all textures have in common. Destroy them: nobody else does.</summary>
    public class Texture : Object
    {
        /// <summary>Stands for all mip levels that fit.</summary>
        public static readonly int GenerateAllMips = -1;

        TextureWrapMode m_WrapU, m_WrapV, m_WrapW;
        FilterMode m_Filter = FilterMode.Bilinear;
        int m_Width, m_Height;
        TextureDimension m_Dimension;
        GraphicsFormat m_Format;

        protected Texture() => MainThread.Check("Texture constructor");

        public virtual int width
        {
            get => m_Width;
            set => throw new NotImplementedException();
        }

        public virtual int height
        {
            get => m_Height;
            set => throw new NotImplementedException();
        }

        public virtual TextureDimension dimension
        {
            get => m_Dimension;
            set => throw new NotImplementedException();
        }

        public virtual GraphicsFormat graphicsFormat => m_Format;

        /// <summary>Whether the CPU's copy of the texels exists.</summary>
        public virtual bool isReadable => false;

        public int mipmapCount => MipCount;

        public bool isDataSRGB => GraphicsFormatUtility.IsSRGBFormat(graphicsFormat);

        /// <summary>One texel in texture coordinates.</summary>
        public Vector2 texelSize => new(1f / width, 1f / height);

        public FilterMode filterMode
        {
            get { Use("get_filterMode"); return m_Filter; }
            set { Use("set_filterMode"); m_Filter = value; }
        }

        /// <summary>What is read outside, along all axes; reads the U axis.</summary>
        public TextureWrapMode wrapMode
        {
            get { Use("get_wrapMode"); return m_WrapU; }
            set { Use("set_wrapMode"); m_WrapU = m_WrapV = m_WrapW = value; }
        }

        public TextureWrapMode wrapModeU
        {
            get { Use("get_wrapModeU"); return m_WrapU; }
            set { Use("set_wrapModeU"); m_WrapU = value; }
        }

        public TextureWrapMode wrapModeV
        {
            get { Use("get_wrapModeV"); return m_WrapV; }
            set { Use("set_wrapModeV"); m_WrapV = value; }
        }

        public TextureWrapMode wrapModeW
        {
            get { Use("get_wrapModeW"); return m_WrapW; }
            set { Use("set_wrapModeW"); m_WrapW = value; }
        }

        public int anisoLevel { get; set; } = 1;

        public float mipMapBias { get; set; }

        /// <summary>How often the contents changed, as far as it is counted.</summary>
        public uint updateCount { get; private set; }

        /// <summary>Bytes of all textures on the device.</summary>
        public static ulong totalTextureMemory => Gpu.IsStarted ? Gpu.Context.TextureBytes : 0;

        public void IncrementUpdateCount() => updateCount++;

        /// <summary>The memory on the device, made if need be; null where there is none (a render texture that is not created).</summary>
        internal virtual GpuTexture Native => null;

        internal virtual int MipCount => 1;

        internal void SetShape(int width, int height, TextureDimension dimension, GraphicsFormat format, TextureWrapMode wrap)
        {
            m_Width = width;
            m_Height = height;
            m_Dimension = dimension;
            m_Format = format;
            m_WrapU = m_WrapV = m_WrapW = wrap;
        }

        internal Vulkan.SamplerState Sampler => new(m_Filter, m_WrapU, m_WrapV, m_WrapW);

        internal override void OnNativeDestroy() => ReleaseNative();

        private protected virtual void ReleaseNative()
        {
        }

        internal UnityException NotReadable() =>
            new($"Texture '{NameForMessages}' is not readable, the texture memory can not be accessed from scripts. You can make the texture readable in "
                + "the Texture Import Settings.");

        /// <summary>Logs Unity's error and makes the object a fake null if a texture of this format cannot exist.</summary>
        internal bool RefuseUnsupported(GraphicsFormat format, GraphicsFormatUsage usage)
        {
            if (SystemInfo.IsFormatSupported(format, usage))
                return false;
            Debug.LogError($"Texture creation failed. '{format}' is not supported for {usage} usage on this platform. Use 'SystemInfo.IsFormatSupported' "
                + "C# API to check format support.");
            Kill();
            return true;
        }

        /// <summary>Logs an error and makes the object a fake null if it would be too large.</summary>
        internal bool RefuseSize(int width, int height, int depth, int max)
        {
            if (width > 0 && height > 0 && depth > 0 && width <= max && height <= max && depth <= max)
                return false;
            Debug.LogError($"Texture creation failed. {width} x {height} x {depth} is outside 1 to {max} per axis.");
            Kill();
            return true;
        }
    }
}
