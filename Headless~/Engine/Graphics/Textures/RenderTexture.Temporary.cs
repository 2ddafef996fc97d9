using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    public partial class RenderTexture
    {
        /// <summary>The target of drawing and ReadPixels; null is the screen.</summary>
        public static RenderTexture active
        {
            get
            {
                MainThread.Check("get_active");
                return DrawTargets.Color;
            }
            set
            {
                MainThread.Check("set_active");
                DrawTargets.Set(value, 0, 0);
            }
        }

        /// <summary>A created texture from a pool; its contents are undefined. Give it back with <see cref="ReleaseTemporary"/>.</summary>
        public static RenderTexture GetTemporary(RenderTextureDescriptor desc)
        {
            Validate(desc);
            return RenderTexturePool.Get(desc);
        }

        public static RenderTexture GetTemporary(int width, int height) => GetTemporary(width, height, 0);

        public static RenderTexture GetTemporary(int width, int height, int depthBuffer) =>
            GetTemporary(width, height, depthBuffer, RenderTextureFormat.Default);

        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format) =>
            GetTemporary(width, height, depthBuffer, format, RenderTextureReadWrite.Default);

        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format, RenderTextureReadWrite readWrite) =>
            GetTemporary(new RenderTextureDescriptor(width, height, format, depthBuffer, Texture.GenerateAllMips, readWrite));

        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format, RenderTextureReadWrite readWrite,
            int antiAliasing) =>
            GetTemporary(new RenderTextureDescriptor(width, height, format, depthBuffer, Texture.GenerateAllMips, readWrite) { msaaSamples = antiAliasing });

        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, GraphicsFormat format) =>
            GetTemporary(new RenderTextureDescriptor(width, height, format, depthBuffer));

        public static void ReleaseTemporary(RenderTexture temp)
        {
            MainThread.Check("ReleaseTemporary");
            if (temp != null)
                RenderTexturePool.Return(temp);
        }
    }
}
