using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    /// <summary>Mip levels by the mean of two texels along each axis.</summary>
    static unsafe class MipBuilder
    {
        internal static void Build(TexturePixels pixels)
        {
            for (var mip = 1; mip < pixels.Shape.Mips; mip++)
                for (var layer = 0; layer < pixels.Shape.Layers; layer++)
                    BuildLevel(pixels, mip, layer);
        }

        static void BuildLevel(TexturePixels pixels, int mip, int layer)
        {
            var (width, height, depth) = pixels.Shape.Mip(mip);
            var (sourceWidth, sourceHeight, sourceDepth) = pixels.Shape.Mip(mip - 1);
            for (var z = 0; z < depth; z++)
            {
                for (var y = 0; y < height; y++)
                {
                    for (var x = 0; x < width; x++)
                    {
                        var sum = new Color(0, 0, 0, 0);
                        for (var corner = 0; corner < 8; corner++)
                        {
                            var sx = Mathf.Min(2 * x + (corner & 1), sourceWidth - 1);
                            var sy = Mathf.Min(2 * y + (corner >> 1 & 1), sourceHeight - 1);
                            var sz = Mathf.Min(2 * z + (corner >> 2), sourceDepth - 1);
                            sum += TexelCodec.Read(pixels.Format, pixels.Texel(mip - 1, layer, sx, sy, sz));
                        }
                        TexelCodec.Write(pixels.Format, pixels.Texel(mip, layer, x, y, z), sum * 0.125f);
                    }
                }
            }
        }
    }
}
