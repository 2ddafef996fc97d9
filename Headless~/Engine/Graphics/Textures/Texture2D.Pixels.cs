using System;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    public sealed partial class Texture2D
    {
        /// <summary>A texel of the CPU's copy; coordinates outside are clamped.</summary>
        public Color GetPixel(int x, int y) => GetPixel(x, y, 0);

        public Color GetPixel(int x, int y, int mipLevel) => PixelTransfer.Get(Pixels, mipLevel, 0, x, y, 0);

        public void SetPixel(int x, int y, Color color) => SetPixel(x, y, color, 0);

        public void SetPixel(int x, int y, Color color, int mipLevel) => PixelTransfer.Set(Pixels, mipLevel, 0, x, y, 0, color);

        /// <summary>All texels, row by row from the bottom.</summary>
        public Color[] GetPixels() => GetPixels(0);

        public Color[] GetPixels(int miplevel)
        {
            var (width, height, _) = Pixels.Shape.Mip(miplevel);
            var colors = new Color[width * height];
            for (var i = 0; i < colors.Length; i++)
                colors[i] = GetPixel(i % width, i / width, miplevel);
            return colors;
        }

        public void SetPixels(Color[] colors) => SetPixels(colors, 0);

        /// <exception cref="ArgumentException">Fewer colours than texels.</exception>
        public void SetPixels(Color[] colors, int miplevel)
        {
            var (width, height, _) = Pixels.Shape.Mip(miplevel);
            if (colors == null || colors.Length < width * height)
                throw new ArgumentException($"SetPixels needs {width * height} colors", nameof(colors));
            for (var i = 0; i < width * height; i++)
                SetPixel(i % width, i / width, colors[i], miplevel);
        }

        public Color32[] GetPixels32() => GetPixels32(0);

        public Color32[] GetPixels32(int miplevel) => Array.ConvertAll(GetPixels(miplevel), c => (Color32)c);

        public void SetPixels32(Color32[] colors) => SetPixels32(colors, 0);

        public void SetPixels32(Color32[] colors, int miplevel) => SetPixels(Array.ConvertAll(colors, c => (Color)c), miplevel);

        /// <summary>Reads a part of the active render texture, or of the screen; waits for the GPU. Stored values are converted between formats, not between
        /// colour spaces.</summary>
        /// <exception cref="UnityException">Not readable.</exception>
        public void ReadPixels(Rect source, int destX, int destY) => ReadPixels(source, destX, destY, true);

        public unsafe void ReadPixels(Rect source, int destX, int destY, bool recalculateMipMaps)
        {
            if (!isReadable)
                throw NotReadable();
            var active = RenderTexture.active;
            var native = active == null ? ScreenBuffer.Texture.ColorNative : active.ColorNative;
            if (native == null)
            {
                Debug.LogError("ReadPixels was called while the active render texture has no colours.");
                return;
            }
            var (fullWidth, fullHeight) = (DrawTargets.Width, DrawTargets.Height);
            var box = new TexelBox((int)source.x, (int)source.y, 0, (int)source.width, (int)source.height, 1);
            if (box.X < 0 || box.Y < 0 || box.X + box.Width > fullWidth || box.Y + box.Height > fullHeight
                || destX < 0 || destY < 0 || destX + box.Width > width || destY + box.Height > height)
            {
                Debug.LogError("Reading pixels out of bounds");
                return;
            }
            var format = native.Format;
            // The screen's first row is its top one.
            var y0 = active == null ? fullHeight - box.Y - box.Height : box.Y;
            var slice = Math.Max(0, DrawTargets.Slice);
            var data = Gpu.Context.Readbacks.ReadNow(native, DrawTargets.Mip, new TexelBox(box.X, y0, slice, box.Width, box.Height, 1));
            if (active == null)
                ScreenBuffer.Flip(data, box.Width * format.BytesPerTexel);
            fixed (byte* texels = data)
            {
                for (var y = 0; y < box.Height; y++)
                    for (var x = 0; x < box.Width; x++)
                        SetPixel(destX + x, destY + y, TexelCodec.Read(format, texels + (y * box.Width + x) * format.BytesPerTexel));
            }
            if (recalculateMipMaps && MipCount > 1)
                MipBuilder.Build(Pixels);
        }
    }
}
