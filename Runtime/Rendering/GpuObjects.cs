using System;
using AnatomyCarve.Volumes;
using UnityEngine;
using Object = UnityEngine.Object;

namespace AnatomyCarve
{
    /// <summary>Making and destroying what the garbage collector does not.</summary>
    static class GpuObjects
    {
        /// <exception cref="AnatomyCarveException">The device cannot make it, or has no memory left for it.</exception>
        public static RenderTexture CreateWritable(RenderTextureDescriptor descriptor, string name, FilterMode filter)
        {
            RenderTexture texture;
            try
            {
                texture = new RenderTexture(descriptor)
                {
                    name = name,
                    filterMode = filter,
                    wrapMode = TextureWrapMode.Clamp,
                    hideFlags = HideFlags.HideAndDontSave,
                };
            }
            catch (ArgumentException e)
            {
                throw new AnatomyCarveException($"The device could not make the texture '{name}': {e.Message}", e);
            }
            try
            {
                CreateOrThrow(texture);
                return texture;
            }
            catch
            {
                Destroy(texture);
                throw;
            }
        }

        /// <summary>A structured buffer.</summary>
        /// <exception cref="AnatomyCarveException">The device cannot make it, or has no memory left for it.</exception>
        public static GraphicsBuffer CreateBuffer(string name, int count, int stride)
        {
            GraphicsBuffer buffer;
            try
            {
                buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, stride) { name = name };
            }
            catch (ArgumentException e)
            {
                throw new AnatomyCarveException($"The device could not make the buffer '{name}': {e.Message}", e);
            }
            if (buffer.IsValid())
                return buffer;
            buffer.Release();
            throw new AnatomyCarveException(FormattableString.Invariant($"The device could not make the buffer '{name}' ({count} x {stride} bytes)."));
        }

        public static void CreateOrThrow(RenderTexture texture)
        {
            if (!texture.Create())
                throw new AnatomyCarveException(
                    $"The device could not make the texture '{texture.name}' "
                    + $"({texture.width} x {texture.height} x {texture.volumeDepth}, {texture.graphicsFormat}).");
        }

        /// <summary>Destroys in Play, while it is paused, and in edit mode; null and destroyed objects are fine.</summary>
        public static void Destroy(Object made)
        {
            if (made == null)
                return;
            if (Application.isPlaying && !EditorLink.IsPaused)
                Object.Destroy(made);
            else
                Object.DestroyImmediate(made);
        }
    }
}
