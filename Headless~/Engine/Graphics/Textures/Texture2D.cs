using System;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>A picture that the CPU fills. Row 0 is the bottom row.</summary>
    public sealed partial class Texture2D : Texture
    {
        TexturePixels m_Pixels;

        /// <summary>RGBA32, sRGB, with all mip levels.</summary>
        public Texture2D(int width, int height) => Create(width, height, SystemInfo.TextureFormatOf(TextureFormat.RGBA32, true), GenerateAllMips, true, false);

        public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
            : this(width, height, textureFormat, mipChain, false)
        {
        }

        /// <param name="width">Texels.</param>
        /// <param name="height">Texels.</param>
        /// <param name="textureFormat">The format.</param>
        /// <param name="mipChain">Whether there are smaller mip levels.</param>
        /// <param name="linear">False: colours are sRGB where the format has such a twin.</param>
        public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain, bool linear) =>
            Create(width, height, SystemInfo.TextureFormatOf(textureFormat, !linear), GenerateAllMips, mipChain, false);

        public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain, bool linear, bool createUninitialized) =>
            Create(width, height, SystemInfo.TextureFormatOf(textureFormat, !linear), GenerateAllMips, mipChain, createUninitialized);

        public Texture2D(int width, int height, TextureFormat textureFormat, int mipCount, bool linear) =>
            Create(width, height, SystemInfo.TextureFormatOf(textureFormat, !linear), mipCount, mipCount != 1, false);

        public Texture2D(int width, int height, TextureFormat textureFormat, int mipCount, bool linear, bool createUninitialized) =>
            Create(width, height, SystemInfo.TextureFormatOf(textureFormat, !linear), mipCount, mipCount != 1, createUninitialized);

        public Texture2D(int width, int height, DefaultFormat format, TextureCreationFlags flags)
            : this(width, height, SystemInfo.GetGraphicsFormat(format), flags)
        {
        }

        public Texture2D(int width, int height, GraphicsFormat format, TextureCreationFlags flags)
            : this(width, height, format, GenerateAllMips, flags)
        {
        }

        public Texture2D(int width, int height, GraphicsFormat format, int mipCount, TextureCreationFlags flags) =>
            Create(width, height, format, mipCount, TextureShapes.HasChain(flags), TextureShapes.IsUninitialized(flags));

        public TextureFormat format => FormatTables.ToTextureFormat(graphicsFormat);

        public override bool isReadable => Pixels.IsReadable;

        /// <summary>A 4 x 4 texture of one colour, made anew each time it is asked for after it was destroyed.</summary>
        public static Texture2D whiteTexture => BuiltinTextures.White;

        public static Texture2D blackTexture => BuiltinTextures.Black;

        internal override GpuTexture Native => Pixels.Native;

        internal override int MipCount => m_Pixels?.Shape.Mips ?? 0;

        internal TexturePixels Pixels
        {
            get
            {
                Use("Texture2D");
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

        public NativeArray<T> GetRawTextureData<T>() where T : struct => Pixels.ViewAll<T>();

        public byte[] GetRawTextureData() => Pixels.ViewAll<byte>().ToArray();

        public void LoadRawTextureData(byte[] data)
        {
            var all = Pixels.ViewAll<byte>();
            if (data == null || data.Length < all.Length)
                throw new UnityException($"LoadRawTextureData: not enough data provided (will result in overread): {data?.Length ?? 0} bytes for "
                    + $"{all.Length}.");
            data.AsSpan(0, all.Length).CopyTo(all.AsSpan());
        }

        public void LoadRawTextureData<T>(NativeArray<T> data) where T : struct =>
            LoadRawTextureData(data.Reinterpret<byte>(PixelTransfer.SizeOf<T>()).ToArray());

        public void Apply() => Pixels.Apply(true, false);

        public void Apply(bool updateMipmaps) => Pixels.Apply(updateMipmaps, false);

        /// <summary>Uploads the CPU's copy.</summary>
        /// <param name="updateMipmaps">Whether smaller levels are computed from level 0.</param>
        /// <param name="makeNoLongerReadable">Whether the copy is freed.</param>
        /// <exception cref="UnityException">The texture is not readable.</exception>
        public void Apply(bool updateMipmaps, bool makeNoLongerReadable) => Pixels.Apply(updateMipmaps, makeNoLongerReadable);

        /// <summary>Changes size and format; the contents are lost.</summary>
        public bool Reinitialize(int width, int height) => Reinitialize(width, height, graphicsFormat, MipCount > 1);

        public bool Reinitialize(int width, int height, TextureFormat format, bool hasMipMap) =>
            Reinitialize(width, height, SystemInfo.TextureFormatOf(format, isDataSRGB), hasMipMap);

        public bool Reinitialize(int width, int height, GraphicsFormat format, bool hasMipMap)
        {
            if (!isReadable)
                throw NotReadable();
            var (filter, u, v, w) = (filterMode, wrapModeU, wrapModeV, wrapModeW);
            ReleaseNative();
            Create(width, height, format, GenerateAllMips, hasMipMap, false);
            if (this == null)
                return false;
            (filterMode, wrapModeU, wrapModeV, wrapModeW) = (filter, u, v, w);
            return true;
        }

        private protected override void ReleaseNative()
        {
            m_Pixels?.Dispose();
            m_Pixels = null;
        }

        void Create(int width, int height, GraphicsFormat format, int mipCount, bool chain, bool uninitialized)
        {
            SetShape(width, height, TextureDimension.Tex2D, format, TextureWrapMode.Repeat);
            if (RefuseUnsupported(format, GraphicsFormatUsage.Sample) || RefuseSize(width, height, 1, SystemInfo.maxTextureSize))
                return;
            var mips = TextureShapes.Mips(width, height, 1, mipCount, chain);
            var shape = new ImageShape(width, height, 1, 1, mips, volume: false, array: false);
            m_Pixels = new TexturePixels("Texture2D", this, shape, FormatInfo.Of(format), uninitialized);
        }
    }
}
