using System;
using AnatomyCarve.Volumes;
using UnityEngine;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Editor
{
    /// <summary>A histogram as a texture, one texel column for each pixel of a plot; made anew only when something else is to be seen.</summary>
    sealed class HistogramTexture : IDisposable
    {
        const int Rows = 128, WidestPlot = 2048;

        static readonly Color32 Filled = new Color32(128, 150, 175, 110), Empty = new Color32(128, 150, 175, 0);

        Texture2D texture;
        float[] heights = Array.Empty<float>();
        Color32[] pixels;
        IntensityHistogram shown;
        ValueWindow window;

        /// <param name="histogram">What to show.</param>
        /// <param name="wanted">The values from the left edge to the right one.</param>
        /// <param name="width">The plot's width in pixels.</param>
        public Texture2D Of(IntensityHistogram histogram, ValueWindow wanted, int width)
        {
            width = Mathf.Clamp(width, 1, WidestPlot);
            if (texture != null && histogram == shown && wanted.Equals(window) && width == heights.Length)
                return texture;
            shown = histogram;
            window = wanted;
            Resize(width);
            HistogramColumns.Fill(histogram, wanted, heights);
            for (int column = 0; column < width; column++)
            {
                int filled = Mathf.RoundToInt(heights[column] * Rows);
                for (int row = 0; row < Rows; row++)
                    pixels[row * width + column] = row < filled ? Filled : Empty;
            }
            texture.SetPixels32(pixels);
            texture.Apply(false);
            return texture;
        }

        public void Dispose()
        {
            if (texture != null)
                Object.DestroyImmediate(texture);
            texture = null;
        }

        void Resize(int width)
        {
            if (texture != null && texture.width == width)
                return;
            Dispose();
            texture = new Texture2D(width, Rows, TextureFormat.RGBA32, false)
            {
                name = "AnatomyCarve histogram", hideFlags = HideFlags.HideAndDontSave, filterMode = FilterMode.Point, wrapMode = TextureWrapMode.Clamp,
            };
            heights = new float[width];
            pixels = new Color32[width * Rows];
        }
    }
}
