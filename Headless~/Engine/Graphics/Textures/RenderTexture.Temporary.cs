using UnityEngine.Experimental.Rendering;

namespace UnityEngine
{
    public partial class RenderTexture
    {
        static RenderTexture s_Active;

        /// <summary>The target of drawing and ReadPixels; null is the screen, which this host does not have.</summary>
        public static RenderTexture active
        {
            get
            {
                MainThread.Check("get_active");
                return s_Active;
            }
            set
            {
                MainThread.Check("set_active");
                if (value != null)
                    value.Create();
                s_Active = value;
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
            GetTemporary(width, height, depthBuffer, GraphicsFormatUtility.GetGraphicsFormat(format, readWrite));

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
