using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>Making and destroying what the garbage collector does not.</summary>
    static class GpuObjects
    {
        /// <exception cref="AnatomyCarveException">The device has no memory left for it.</exception>
        public static RenderTexture CreateWritable(RenderTextureDescriptor descriptor, string name, FilterMode filter)
        {
            var texture = new RenderTexture(descriptor)
            {
                name = name,
                filterMode = filter,
                wrapMode = TextureWrapMode.Clamp,
                hideFlags = HideFlags.HideAndDontSave,
            };
            CreateOrThrow(texture);
            return texture;
        }

        public static void CreateOrThrow(RenderTexture texture)
        {
            if (!texture.Create())
                throw new AnatomyCarveException($"The device could not make the texture '{texture.name}' ({texture.width} x {texture.height} x {texture.volumeDepth}, {texture.graphicsFormat}).");
        }

        /// <summary>Destroys in play mode and in edit mode; null and destroyed objects are fine.</summary>
        public static void Destroy(Object made)
        {
            if (made == null)
                return;
            if (made is RenderTexture texture)
                texture.Release();
            if (Application.isPlaying)
                Object.Destroy(made);
            else
                Object.DestroyImmediate(made);
        }
    }
}
