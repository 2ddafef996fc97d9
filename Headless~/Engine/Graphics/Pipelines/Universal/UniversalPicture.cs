using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>A picture as URP draws it: what is opaque, the depth texture, what is transparent.</summary>
    static class UniversalPicture
    {
        internal static void Draw(CameraPicture picture, VisibleMeshes visible, bool depthOfAll)
        {
            if (visible.IsEmpty && EmptyPictures.TrySkip(picture))
                return;
            var camera = picture.Camera;
            var wantsDepth = depthOfAll || (camera.depthTextureMode & DepthTextureMode.Depth) != 0;
            // URP does not draw into the screen itself what needs the depth texture, so that both have the same first row.
            var instead = wantsDepth && picture.Target is null && CameraPicture.ClearsColor(camera) ? RenderTexture.GetTemporary(Shape(camera)) : null;
            var restore = DrawTargets.Remember();
            // Drawn apart, and not copied, as the target may have several samples per pixel.
            var depth = wantsDepth ? CameraDepth.Draw(picture, visible, PassRules.Universal) : null;
            if (instead is null)
                picture.Begin();
            else
                picture.Begin(instead);
            picture.Clear();
            CameraPicture.Draw(visible.Opaque, PassRules.Universal);
            CameraDepth.Publish(depth);
            CameraPicture.Draw(visible.Transparent, PassRules.Universal);
            CameraPicture.End();
            if (instead is not null)
            {
                Show(instead, camera);
                RenderTexture.ReleaseTemporary(instead);
            }
            restore();
            CameraDepth.Release(depth);
        }

        static void Show(RenderTexture picture, Camera camera)
        {
            DrawTargets.Set(null, 0, 0);
            DrawTargets.Viewport = camera.pixelRect;
            Blitter.Draw(picture, null, -1, new Vector4(1, 1, 0, 0));
        }

        static RenderTextureDescriptor Shape(Camera camera) => new(camera.pixelWidth, camera.pixelHeight,
            ColorSpaces.IsLinear ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
    }
}
