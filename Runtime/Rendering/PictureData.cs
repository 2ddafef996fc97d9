using System;
using AnatomyCarve.Volumes;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>A picture in main memory. Row 0 is the bottom row; pixel (x, y) is element x + Width * y.</summary>
    public sealed class PictureData
    {
        /// <summary>The segment where nothing is visible.</summary>
        public const ushort NoSegment = 65535;

        internal PictureData(int width, int height)
        {
            Width = width;
            Height = height;
            Color = new Color[width * height];
            DepthMm = new float[width * height];
            Segments = new ushort[width * height];
        }

        /// <summary>Width in pixels.</summary>
        public int Width { get; }

        /// <summary>Height in pixels.</summary>
        public int Height { get; }

        /// <summary>Colours: linear, premultiplied by alpha.</summary>
        public Color[] Color { get; }

        /// <summary>Depth of the first visible segment: the patient's millimetres along the ray from its origin; infinite where there is none.</summary>
        public float[] DepthMm { get; }

        /// <summary>First visible segment: its index in the segment table; <see cref="NoSegment"/> where there is none.</summary>
        public ushort[] Segments { get; }

        /// <summary>The picture over a background as 8-bit sRGB, 4 bytes a pixel (RGBA, alpha 255), bottom row first.</summary>
        /// <param name="background">The background, sRGB as in all of Unity's colour fields; its alpha does not count.</param>
        public byte[] ToSrgb(Color background)
        {
            Color behind = background.linear;
            var bytes = new byte[4 * Color.Length];
            for (int p = 0; p < Color.Length; p++)
            {
                Color c = Color[p];
                float through = 1f - Mathf.Clamp01(c.a);
                Color srgb = new Color(c.r + through * behind.r, c.g + through * behind.g, c.b + through * behind.b).gamma;
                bytes[4 * p] = ToByte(srgb.r);
                bytes[4 * p + 1] = ToByte(srgb.g);
                bytes[4 * p + 2] = ToByte(srgb.b);
                bytes[4 * p + 3] = 255;
            }
            return bytes;
        }

        /// <summary>The picture over a background as a PNG file's bytes (sRGB, 8 bits, first row on top as in every PNG).</summary>
        /// <param name="background">The background, sRGB.</param>
        public byte[] EncodeToPng(Color background) =>
            ImageConversion.EncodeArrayToPNG(ToSrgb(background), GraphicsFormat.R8G8B8A8_SRGB, (uint)Width, (uint)Height);

        internal void TakeColor(AsyncGPUReadbackRequest request)
        {
            NativeArray<ushort> halves = Get<ushort>(request, "colour");
            for (int p = 0; p < Color.Length; p++)
                Color[p] = new Color(
                    Mathf.HalfToFloat(halves[4 * p]), Mathf.HalfToFloat(halves[4 * p + 1]),
                    Mathf.HalfToFloat(halves[4 * p + 2]), Mathf.HalfToFloat(halves[4 * p + 3]));
        }

        internal void TakeDepth(AsyncGPUReadbackRequest request) => Get<float>(request, "depth").CopyTo(DepthMm);

        internal void TakeSegments(AsyncGPUReadbackRequest request)
        {
            NativeArray<uint> indices = Get<uint>(request, "segments");
            for (int p = 0; p < Segments.Length; p++)
                Segments[p] = (ushort)Math.Min(indices[p], NoSegment);
        }

        static NativeArray<T> Get<T>(AsyncGPUReadbackRequest request, string what) where T : struct
        {
            if (request.hasError)
                throw new AnatomyCarveException($"The device could not read the picture's {what} back.");
            return request.GetData<T>();
        }

        static byte ToByte(float value) => (byte)Mathf.RoundToInt(255f * Mathf.Clamp01(value));
    }
}
