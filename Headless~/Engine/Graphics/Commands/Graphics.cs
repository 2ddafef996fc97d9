using System;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Work for the GPU that has no object of its own.</summary>
    public partial class Graphics
    {
        /// <summary>Runs what the command buffer recorded, in order with all other work, without waiting.</summary>
        /// <exception cref="ArgumentNullException">No buffer.</exception>
        public static void ExecuteCommandBuffer(CommandBuffer buffer)
        {
            MainThread.Check("Graphics.ExecuteCommandBuffer");
            if (buffer == null)
                throw new ArgumentNullException(nameof(buffer));
            buffer.Execute();
        }

        /// <summary>All mip levels and elements; sizes and formats must agree.</summary>
        public static void CopyTexture(Texture src, Texture dst) => TextureCopy.All(src, dst);

        /// <summary>All mip levels of one element: a picture of an array, a slice of a volume.</summary>
        public static void CopyTexture(Texture src, int srcElement, Texture dst, int dstElement) => TextureCopy.Element(src, srcElement, dst, dstElement);

        public static void CopyTexture(Texture src, int srcElement, int srcMip, Texture dst, int dstElement, int dstMip) =>
            TextureCopy.Element(src, srcElement, srcMip, dst, dstElement, dstMip);

        public static void CopyTexture(Texture src, int srcElement, int srcMip, int srcX, int srcY, int srcWidth, int srcHeight, Texture dst, int dstElement,
            int dstMip, int dstX, int dstY) =>
            TextureCopy.Region(src, srcElement, srcMip, srcX, srcY, srcWidth, srcHeight, dst, dstElement, dstMip, dstX, dstY);

        /// <summary>All bytes; sizes must agree.</summary>
        /// <exception cref="ArgumentException">A buffer lacks the target CopySource or CopyDestination, or sizes differ.</exception>
        public static void CopyBuffer(GraphicsBuffer source, GraphicsBuffer dest)
        {
            MainThread.Check("Graphics.CopyBuffer");
            if (source is not { Native: { IsAlive: true } })
                throw new ArgumentNullException(nameof(source));
            if (dest is not { Native: { IsAlive: true } })
                throw new ArgumentNullException(nameof(dest));
            if ((source.target & GraphicsBuffer.Target.CopySource) == 0)
                throw new ArgumentException("The source lacks the target CopySource", nameof(source));
            if ((dest.target & GraphicsBuffer.Target.CopyDestination) == 0)
                throw new ArgumentException("The destination lacks the target CopyDestination", nameof(dest));
            if (source.Native.Size != dest.Native.Size)
                throw new ArgumentException($"The sizes differ: {source.Native.Size} and {dest.Native.Size} bytes", nameof(dest));
            dest.Native.CopyFrom(source.Native.Storage, 0, 0, (ulong)source.Native.Size);
        }
    }
}
