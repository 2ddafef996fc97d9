using System;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    /// <summary>Graphics.CopyTexture: texels as they are, between textures of the same format and size.</summary>
    static class TextureCopy
    {
        /// <summary>Everything that both have.</summary>
        internal static void All(Texture source, Texture target)
        {
            if (!Ready(source, target, out var from, out var to))
                return;
            var (a, b) = (from.Image.Shape, to.Image.Shape);
            if (a.Width != b.Width || a.Height != b.Height || a.Depth != b.Depth || a.Layers != b.Layers || a.Mips != b.Mips)
            {
                Fail(source, target, "the sizes or mip counts differ");
                return;
            }
            for (var mip = 0; mip < a.Mips; mip++)
            {
                var (width, height, depth) = a.Mip(mip);
                from.CopyTo(to, mip, new TexelBox(0, 0, 0, width, height, Math.Max(depth, a.Layers)), mip, 0, 0, 0);
            }
        }

        /// <summary>One slice or picture of all mip levels.</summary>
        internal static void Element(Texture source, int sourceElement, Texture target, int targetElement)
        {
            if (!Ready(source, target, out var from, out _))
                return;
            for (var mip = 0; mip < from.Image.Shape.Mips; mip++)
                Element(source, sourceElement, mip, target, targetElement, mip);
        }

        internal static void Element(Texture source, int sourceElement, int sourceMip, Texture target, int targetElement, int targetMip)
        {
            if (!Ready(source, target, out var from, out _) || !HasMip(source, target, from, sourceMip))
                return;
            var (width, height, _) = from.Image.Shape.Mip(sourceMip);
            Region(source, sourceElement, sourceMip, 0, 0, width, height, target, targetElement, targetMip, 0, 0);
        }

        internal static void Region(Texture source, int sourceElement, int sourceMip, int sourceX, int sourceY, int width, int height,
            Texture target, int targetElement, int targetMip, int targetX, int targetY)
        {
            if (!Ready(source, target, out var from, out var to) || !HasMip(source, target, from, sourceMip) || !HasMip(source, target, to, targetMip))
                return;
            if (!Inside(from, sourceMip, sourceX, sourceY, sourceElement, width, height)
                || !Inside(to, targetMip, targetX, targetY, targetElement, width, height))
            {
                Fail(source, target, "the region is not inside both textures");
                return;
            }
            from.CopyTo(to, sourceMip, new TexelBox(sourceX, sourceY, sourceElement, width, height, 1), targetMip, targetX, targetY, targetElement);
        }

        static bool Ready(Texture source, Texture target, out GpuTexture from, out GpuTexture to)
        {
            MainThread.Check("Graphics.CopyTexture");
            if (source == null)
                throw new ArgumentNullException(nameof(source));
            if (target == null)
                throw new ArgumentNullException(nameof(target));
            if (target is RenderTexture render)
                render.Create();
            (from, to) = (source.Native, target.Native);
            if (from == null || to == null)
                return Fail(source, target, "the source is not created");
            if (from == to)
                return Fail(source, target, "source and destination are the same texture");
            if (FormatTables.ToLinear(from.Format.Format) != FormatTables.ToLinear(to.Format.Format))
                return Fail(source, target, $"the formats {from.Format.Format} and {to.Format.Format} are not compatible");
            return true;
        }

        static bool HasMip(Texture source, Texture target, GpuTexture texture, int mip) =>
            (mip >= 0 && mip < texture.Image.Shape.Mips) || Fail(source, target, $"there is no mip level {mip}");

        static bool Inside(GpuTexture texture, int mip, int x, int y, int element, int width, int height)
        {
            var (w, h, depth) = texture.Image.Shape.Mip(mip);
            return x >= 0 && y >= 0 && width > 0 && height > 0 && x + width <= w && y + height <= h
                && element >= 0 && element < Math.Max(depth, texture.Image.Shape.Layers);
        }

        static bool Fail(Texture source, Texture target, string reason)
        {
            Debug.LogError($"Graphics.CopyTexture from '{source.NameForMessages}' to '{target.NameForMessages}' failed: {reason}.");
            return false;
        }
    }
}
