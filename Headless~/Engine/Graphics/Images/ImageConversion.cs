using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    /// <summary>Pictures to and from PNG files. Row 0 of the data is the bottom row of the picture. Stored values are written as they are.</summary>
    public static class ImageConversion
    {
        /// <exception cref="UnityException">The texture is not readable.</exception>
        public static byte[] EncodeToPNG(this Texture2D tex)
        {
            var pixels = tex.Pixels;
            if (!pixels.IsReadable)
                throw tex.NotReadable();
            return Encode(tex.GetPixelData<byte>(0).AsReadOnlySpan(), tex.graphicsFormat, (uint)tex.width, (uint)tex.height, 0);
        }

        /// <summary>Works on any thread.</summary>
        /// <param name="array">The texels.</param>
        /// <param name="format">8 or 16 bits of unorm or sRGB, or floats, which are cut to 0..1 and stored as 8 bits.</param>
        /// <param name="width">Texels.</param>
        /// <param name="height">Texels.</param>
        /// <param name="rowBytes">Bytes from row to row; 0 if rows lie close.</param>
        /// <exception cref="ArgumentException">The array is too small, or the format has no picture.</exception>
        public static byte[] EncodeArrayToPNG(Array array, GraphicsFormat format, uint width, uint height, uint rowBytes = 0)
        {
            if (array == null)
                throw new ArgumentNullException(nameof(array));
            var size = BufferTransfer.Blittable(array.GetType().GetElementType(), "EncodeArrayToPNG") * array.Length;
            var handle = GCHandle.Alloc(array, GCHandleType.Pinned);
            try
            {
                unsafe
                {
                    return Encode(new ReadOnlySpan<byte>((void*)handle.AddrOfPinnedObject(), size), format, width, height, rowBytes);
                }
            }
            finally
            {
                handle.Free();
            }
        }

        /// <summary>Works on any thread. The result is the caller's to dispose of.</summary>
        public static NativeArray<byte> EncodeNativeArrayToPNG<T>(NativeArray<T> input, GraphicsFormat format, uint width, uint height, uint rowBytes = 0)
            where T : struct
        {
            var png = Encode(input.Reinterpret<byte>(PixelTransfer.SizeOf<T>()).AsReadOnlySpan(), format, width, height, rowBytes);
            return new NativeArray<byte>(png, Allocator.Persistent);
        }

        /// <summary>Loads a PNG into a texture, which takes its size and becomes RGBA32. False if the file cannot be read: 8 bits per channel, not
        /// interlaced.</summary>
        public static bool LoadImage(this Texture2D tex, byte[] data) => LoadImage(tex, data, false);

        public static bool LoadImage(this Texture2D tex, byte[] data, bool markNonReadable)
        {
            if (data == null)
                throw new ArgumentNullException(nameof(data));
            if (!PngDecoder.TryDecode(data, out var width, out var height, out var rgba))
                return false;
            if (!tex.Reinitialize(width, height, TextureFormat.RGBA32, false))
                return false;
            tex.SetPixelData(rgba, 0);
            tex.Apply(false, markNonReadable);
            return true;
        }

        static unsafe byte[] Encode(ReadOnlySpan<byte> data, GraphicsFormat format, uint width, uint height, uint rowBytes)
        {
            var info = FormatInfo.Of(format);
            if (info == null || info.Kind is ChannelKind.UInt or ChannelKind.SInt or ChannelKind.SNorm)
                throw new ArgumentException($"A PNG cannot be made of the format {format}", nameof(format));
            if (width == 0 || height == 0)
                throw new ArgumentException("The picture is empty", nameof(width));
            var row = (long)width * info.BytesPerTexel;
            var step = rowBytes == 0 ? row : rowBytes;
            if (step < row || (height - 1) * step + row > data.Length)
                throw new ArgumentException($"The array has {data.Length} bytes, {(height - 1) * step + row} are needed", nameof(data));
            // Grey and alpha is what two channels mean in a PNG; Unity shows red and green.
            var channels = info.Channels == 2 ? 3 : info.Channels;
            var bits = info.Kind == ChannelKind.SFloat ? 8 : info.Bits;
            var output = new byte[checked(width * height * channels * bits / 8)];
            var direct = bits == 8 && info.Kind != ChannelKind.SFloat && channels == info.Channels && !info.IsBlueFirst;
            fixed (byte* source = data)
            {
                for (var y = 0; y < height; y++)
                {
                    var line = source + (height - 1 - y) * step;
                    var at = (int)(y * width * channels * bits / 8);
                    if (direct)
                        data.Slice((int)((height - 1 - y) * step), (int)row).CopyTo(output.AsSpan(at));
                    else
                        Convert(info, line, (int)width, channels, bits, output, at);
                }
            }
            return PngEncoder.Encode((int)width, (int)height, channels, bits, output);
        }

        static unsafe void Convert(FormatInfo info, byte* line, int width, int channels, int bits, byte[] output, int at)
        {
            for (var x = 0; x < width; x++)
            {
                var color = TexelCodec.Read(info, line + x * info.BytesPerTexel);
                for (var c = 0; c < channels; c++)
                {
                    var value = Math.Round((double)Mathf.Clamp01(float.IsNaN(color[c]) ? 0 : color[c]) * (bits == 8 ? 255 : 65535));
                    if (bits == 16)
                        output[at++] = (byte)((int)value >> 8);
                    output[at++] = (byte)(int)value;
                }
            }
        }
    }
}
