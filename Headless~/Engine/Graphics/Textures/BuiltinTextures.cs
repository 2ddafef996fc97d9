namespace UnityEngine
{
    /// <summary>Small textures of one colour.</summary>
    static class BuiltinTextures
    {
        const int Size = 4;

        static Texture2D s_White, s_Black;

        internal static Texture2D White => s_White = s_White != null ? s_White : Create("UnityWhite", Color.white);

        internal static Texture2D Black => s_Black = s_Black != null ? s_Black : Create("UnityBlack", new Color(0, 0, 0, 0));

        internal static void Clear()
        {
            if (s_White != null)
                Object.DestroyImmediate(s_White, true);
            if (s_Black != null)
                Object.DestroyImmediate(s_Black, true);
            s_White = s_Black = null;
        }

        static Texture2D Create(string name, Color color)
        {
            var texture = new Texture2D(Size, Size, TextureFormat.RGBA32, false, true) { name = name };
            for (var i = 0; i < Size * Size; i++)
                texture.SetPixel(i % Size, i / Size, color);
            texture.Apply(false, true);
            ObjectRegistry.Remove(texture);
            return texture;
        }
    }
}
