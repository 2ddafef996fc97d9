using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>Pictures of one size that the CPU fills.</summary>
    public sealed class Texture2DArray : Texture
    {
        TexturePixels m_Pixels;
        int m_Layers;

        public Texture2DArray(int width, int height, int depth, TextureFormat textureFormat, bool mipChain)
            : this(width, height, depth, textureFormat, mipChain, false)
        {
        }

        public Texture2DArray(int width, int height, int depth, TextureFormat textureFormat, bool mipChain, bool linear) =>
            Create(width, height, depth, SystemInfo.TextureFormatOf(textureFormat, !linear), GenerateAllMips, mipChain, false);

        public Texture2DArray(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags)
            : this(width, height, depth, format, flags, GenerateAllMips)
        {
        }

        public Texture2DArray(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags, int mipCount) =>
            Create(width, height, depth, format, mipCount, TextureShapes.HasChain(flags), TextureShapes.IsUninitialized(flags));

        /// <summary>How many pictures.</summary>
        public int depth => m_Layers;

        public TextureFormat format => FormatTables.ToTextureFormat(graphicsFormat);

        public override bool isReadable => Pixels.IsReadable;

        internal override GpuTexture Native => Pixels.Native;

        internal override int MipCount => m_Pixels?.Shape.Mips ?? 0;

        TexturePixels Pixels
        {
            get
            {
                Use("Texture2DArray");
                return m_Pixels;
            }
        }

        /// <summary>Copies a mip level of one picture into the CPU's copy.</summary>
        public void SetPixelData<T>(T[] data, int mipLevel, int element, int sourceDataStartIndex = 0) =>
            PixelTransfer.Set(this, Pixels, data, mipLevel, element, sourceDataStartIndex);

        public void SetPixelData<T>(NativeArray<T> data, int mipLevel, int element, int sourceDataStartIndex = 0) where T : struct =>
            PixelTransfer.Set(this, Pixels, data, mipLevel, element, sourceDataStartIndex);

        public NativeArray<T> GetPixelData<T>(int mipLevel, int element) where T : struct => Pixels.View<T>(mipLevel, element);

        public void Apply() => Pixels.Apply(true, false);

        public void Apply(bool updateMipmaps) => Pixels.Apply(updateMipmaps, false);

        public void Apply(bool updateMipmaps, bool makeNoLongerReadable) => Pixels.Apply(updateMipmaps, makeNoLongerReadable);

        private protected override void ReleaseNative()
        {
            m_Pixels?.Dispose();
            m_Pixels = null;
        }

        void Create(int width, int height, int depth, GraphicsFormat format, int mipCount, bool chain, bool uninitialized)
        {
            m_Layers = depth;
            SetShape(width, height, TextureDimension.Tex2DArray, format, TextureWrapMode.Repeat);
            if (RefuseUnsupported(format, GraphicsFormatUsage.Sample) || RefuseSize(width, height, depth, SystemInfo.maxTextureArraySlices))
                return;
            var mips = TextureShapes.Mips(width, height, 1, mipCount, chain);
            var shape = new ImageShape(width, height, 1, depth, mips, volume: false, array: true);
            m_Pixels = new TexturePixels("Texture2DArray", this, shape, FormatInfo.Of(format), uninitialized);
        }
    }
}
