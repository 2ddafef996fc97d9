using System;

namespace UnityEngine
{
    public partial class Graphics
    {
        /// <summary>Copies a texture, with filtering and conversion between formats and colour spaces. The destination stays the active target.</summary>
        public static void Blit(Texture source, RenderTexture dest) => Blit(source, dest, Vector2.one, Vector2.zero);

        /// <param name="source">A picture.</param>
        /// <param name="dest">Null for the screen.</param>
        /// <param name="scale">Of the source's texture coordinates.</param>
        /// <param name="offset">Of the source's texture coordinates.</param>
        public static void Blit(Texture source, RenderTexture dest, Vector2 scale, Vector2 offset)
        {
            MainThread.Check("Graphics.Blit");
            Target(dest, 0);
            Blitter.Draw(source, null, -1, new Vector4(scale.x, scale.y, offset.x, offset.y));
        }

        public static void Blit(Texture source, RenderTexture dest, Material mat) => Blit(source, dest, mat, -1);

        public static void Blit(Texture source, RenderTexture dest, Material mat, int pass) => Blit(source, dest, mat, pass, 0);

        /// <summary>Draws a square over the destination with a material, which sees the source as _MainTex.</summary>
        public static void Blit(Texture source, RenderTexture dest, Material mat, int pass, int destDepthSlice)
        {
            MainThread.Check("Graphics.Blit");
            if (mat == null)
                throw new ArgumentNullException(nameof(mat));
            Target(dest, destDepthSlice);
            Blitter.Draw(source, mat, pass, new Vector4(1, 1, 0, 0));
        }

        public static void Blit(Texture source, Material mat) => Blit(source, mat, -1);

        /// <summary>The same into the active target.</summary>
        public static void Blit(Texture source, Material mat, int pass)
        {
            MainThread.Check("Graphics.Blit");
            if (mat == null)
                throw new ArgumentNullException(nameof(mat));
            Blitter.Draw(source, mat, pass, new Vector4(1, 1, 0, 0));
        }

        static void Target(RenderTexture dest, int slice) => DrawTargets.Set(dest != null ? dest : null, 0, slice);
    }
}
