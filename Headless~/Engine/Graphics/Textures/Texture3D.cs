using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>A volume that the CPU fills. x runs fastest, then y, then z.</summary>
    public sealed class Texture3D : Texture
    {
        TexturePixels m_Pixels;
        int m_Depth;

        /// <summary>Always linear.</summary>
        public Texture3D(int width, int height, int depth, TextureFormat textureFormat, bool mipChain)
            : this(width, height, depth, textureFormat, mipChain, false)
        {
        }

        public Texture3D(int width, int height, int depth, TextureFormat textureFormat, bool mipChain, bool createUninitialized) =>
            Create(width, height, depth, FormatTables.Of(textureFormat, false), GenerateAllMips, mipChain, createUninitialized);

        public Texture3D(int width, int height, int depth, TextureFormat textureFormat, int mipCount) =>
            Create(width, height, depth, FormatTables.Of(textureFormat, false), mipCount, mipCount != 1, false);

        public Texture3D(int width, int height, int depth, DefaultFormat format, TextureCreationFlags flags)
            : this(width, height, depth, SystemInfo.GetGraphicsFormat(format), flags)
        {
        }

        public Texture3D(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags)
            : this(width, height, depth, format, flags, GenerateAllMips)
        {
        }

        /// <param name="width">Texels.</param>
        /// <param name="height">Texels.</param>
        /// <param name="depth">Texels.</param>
        /// <param name="format">The format.</param>
        /// <param name="flags">Without MipChain there is one level, whatever <paramref name="mipCount"/> says.</param>
        /// <param name="mipCount">Levels; negative for all that fit.</param>
        public Texture3D(int width, int height, int depth, GraphicsFormat format, TextureCreationFlags flags, int mipCount) =>
            Create(width, height, depth, format, mipCount, TextureShapes.HasChain(flags), TextureShapes.IsUninitialized(flags));

        public int depth => m_Depth;

        public TextureFormat format => FormatTables.ToTextureFormat(graphicsFormat);

        public override bool isReadable => Pixels.IsReadable;

        internal override GpuTexture Native => Pixels.Native;

        internal override int MipCount => m_Pixels?.Shape.Mips ?? 0;

        TexturePixels Pixels
        {
            get
            {
                Use("Texture3D");
                return m_Pixels;
            }
        }

        /// <summary>Copies a whole mip level into the CPU's copy.</summary>
        /// <exception cref="UnityException">Not readable, no data, or too little of it.</exception>
        public void SetPixelData<T>(T[] data, int mipLevel, int sourceDataStartIndex = 0) =>
            PixelTransfer.Set(this, Pixels, data, mipLevel, 0, sourceDataStartIndex);

        public void SetPixelData<T>(NativeArray<T> data, int mipLevel, int sourceDataStartIndex = 0) where T : struct =>
            PixelTransfer.Set(this, Pixels, data, mipLevel, 0, sourceDataStartIndex);

        /// <summary>The CPU's copy of a mip level itself, not a copy of it.</summary>
        public NativeArray<T> GetPixelData<T>(int mipLevel) where T : struct => Pixels.View<T>(mipLevel, 0);

        public Color GetPixel(int x, int y, int z) => GetPixel(x, y, z, 0);

        public Color GetPixel(int x, int y, int z, int mipLevel) => PixelTransfer.Get(Pixels, mipLevel, 0, x, y, z);

        public void SetPixel(int x, int y, int z, Color color) => SetPixel(x, y, z, color, 0);

        public void SetPixel(int x, int y, int z, Color color, int mipLevel) => PixelTransfer.Set(Pixels, mipLevel, 0, x, y, z, color);

        public void Apply() => Pixels.Apply(true, false);

        public void Apply(bool updateMipmaps) => Pixels.Apply(updateMipmaps, false);

        /// <summary>Uploads the CPU's copy.</summary>
        /// <param name="updateMipmaps">Whether smaller levels are computed from level 0.</param>
        /// <param name="makeNoLongerReadable">Whether the copy is freed.</param>
        /// <exception cref="UnityException">The texture is not readable.</exception>
        public void Apply(bool updateMipmaps, bool makeNoLongerReadable) => Pixels.Apply(updateMipmaps, makeNoLongerReadable);

        private protected override void ReleaseNative()
        {
            m_Pixels?.Dispose();
            m_Pixels = null;
        }

        void Create(int width, int height, int depth, GraphicsFormat format, int mipCount, bool chain, bool uninitialized)
        {
            m_Depth = depth;
            SetShape(width, height, TextureDimension.Tex3D, format, TextureWrapMode.Repeat);
            if (RefuseUnsupported(format, GraphicsFormatUsage.Sample) || RefuseSize(width, height, depth, SystemInfo.maxTexture3DSize))
                return;
            var mips = TextureShapes.Mips(width, height, depth, mipCount, chain);
            var shape = new ImageShape(width, height, depth, 1, mips, volume: true, array: false);
            m_Pixels = new TexturePixels("Texture3D", this, shape, FormatInfo.Of(format), uninitialized);
        }
    }
}
