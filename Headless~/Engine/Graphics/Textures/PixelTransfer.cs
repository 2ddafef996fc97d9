using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine.Experimental.Rendering;

#pragma warning disable CS8500 // sizeof(T): T is checked to hold no references

namespace UnityEngine
{
    /// <summary>Arrays and colours to and from a texture's CPU copy.</summary>
    static unsafe class PixelTransfer
    {
        internal static int SizeOf<T>() where T : struct => sizeof(T);

        internal static void Set<T>(Texture texture, TexturePixels pixels, T[] data, int mip, int layer, int start)
        {
            CheckReadable(texture, pixels);
            if (data == null || data.Length == 0)
                throw new UnityException("No texture data provided to SetPixelData.");
            CheckStart(start, data.Length);
            var element = BufferTransfer.Blittable(typeof(T), "SetPixelData");
            var handle = GCHandle.Alloc(data, GCHandleType.Pinned);
            try
            {
                pixels.Set((byte*)handle.AddrOfPinnedObject() + (long)start * element, (long)(data.Length - start) * element, mip, layer, "SetPixelData");
            }
            finally
            {
                handle.Free();
            }
        }

        internal static void Set<T>(Texture texture, TexturePixels pixels, NativeArray<T> data, int mip, int layer, int start) where T : struct
        {
            CheckReadable(texture, pixels);
            if (!data.IsCreated || data.Length == 0)
                throw new UnityException("No texture data provided to SetPixelData.");
            CheckStart(start, data.Length);
            pixels.Set((byte*)data.GetUnsafeReadOnlyPtr() + (long)start * sizeof(T), (long)(data.Length - start) * sizeof(T), mip, layer, "SetPixelData");
        }

        /// <summary>A texel as a colour; coordinates outside are clamped.</summary>
        internal static Color Get(TexturePixels pixels, int mip, int layer, int x, int y, int z)
        {
            var (width, height, depth) = pixels.Shape.Mip(mip);
            return TexelCodec.Read(pixels.Format,
                pixels.Texel(mip, layer, Mathf.Clamp(x, 0, width - 1), Mathf.Clamp(y, 0, height - 1), Mathf.Clamp(z, 0, depth - 1)));
        }

        internal static void Set(TexturePixels pixels, int mip, int layer, int x, int y, int z, Color color)
        {
            var (width, height, depth) = pixels.Shape.Mip(mip);
            TexelCodec.Write(pixels.Format,
                pixels.Texel(mip, layer, Mathf.Clamp(x, 0, width - 1), Mathf.Clamp(y, 0, height - 1), Mathf.Clamp(z, 0, depth - 1)), color);
        }

        static void CheckReadable(Texture texture, TexturePixels pixels)
        {
            if (!pixels.IsReadable)
                throw texture.NotReadable();
        }

        static void CheckStart(int start, int length)
        {
            if (start < 0 || start >= length)
                throw new UnityException($"SetPixelData: sourceDataStartIndex must be >= 0 and less than the data's length ({start} of {length}).");
        }
    }
}
