using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    /// <summary>
    /// The window's picture: made when it is first drawn into or read, with the window's size. Its first row is the top one, as on a real
    /// screen of this API.
    /// </summary>
    static class ScreenBuffer
    {
        static RenderTexture s_Texture;

        internal static RenderTexture Texture
        {
            get
            {
                if (s_Texture != null && (s_Texture.width != Screen.width || s_Texture.height != Screen.height))
                    Clear();
                if (s_Texture == null)
                {
                    var format = ColorSpaces.IsLinear ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
                    s_Texture = new RenderTexture(Screen.width, Screen.height, format, GraphicsFormat.D32_SFloat) { name = "Screen" };
                    s_Texture.Create();
                    ObjectRegistry.Remove(s_Texture);
                    EmptyPictures.ClearScreen();
                }
                return s_Texture;
            }
        }

        /// <summary>The picture's bytes as they are stored, RGBA, the bottom row first.</summary>
        internal static byte[] Read()
        {
            var texture = Texture;
            var bytes = Gpu.Context.Readbacks.ReadNow(texture.ColorNative, 0, new TexelBox(0, 0, 0, texture.width, texture.height, 1));
            Flip(bytes, texture.width * 4);
            return bytes;
        }

        internal static void Clear()
        {
            if (s_Texture != null)
                Object.DestroyImmediate(s_Texture, true);
            s_Texture = null;
        }

        /// <summary>Turns rows over.</summary>
        internal static void Flip(byte[] bytes, int row)
        {
            var kept = new byte[row];
            for (int low = 0, high = bytes.Length - row; low < high; low += row, high -= row)
            {
                System.Buffer.BlockCopy(bytes, low, kept, 0, row);
                System.Buffer.BlockCopy(bytes, high, bytes, low, row);
                System.Buffer.BlockCopy(kept, 0, bytes, high, row);
            }
        }
    }
}
