using System;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    /// <summary>Rules on sizes and mip counts.</summary>
    static class TextureShapes
    {
        /// <summary>The mip count that a constructor's arguments mean. Negative: all that fit.</summary>
        internal static int Mips(int width, int height, int depth, int asked, bool chain)
        {
            if (!chain)
                return 1;
            var all = 1;
            for (var size = Math.Max(width, Math.Max(height, depth)); size > 1; size >>= 1)
                all++;
            return asked < 0 ? all : Math.Min(Math.Max(asked, 1), all);
        }

        internal static bool HasChain(TextureCreationFlags flags) => (flags & TextureCreationFlags.MipChain) != 0;

        internal static bool IsUninitialized(TextureCreationFlags flags) =>
            (flags & (TextureCreationFlags.DontInitializePixels | TextureCreationFlags.DontUploadUponCreate)) != 0;
    }
}
