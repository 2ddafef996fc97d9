using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>The texture _CameraDepthTexture of a camera's picture: the depth of what is opaque. A picture of both eyes has a slice for each.</summary>
    static class CameraDepth
    {
        static readonly int s_Name = Shader.PropertyToID("_CameraDepthTexture");

        /// <summary>Draws the depth of opaque objects with those passes of their shaders.</summary>
        internal static RenderTexture Draw(CameraPicture picture, VisibleMeshes visible, PassRules rules)
        {
            var texture = Create(picture);
            picture.Begin(texture);
            DrawTargets.Clear(false, true, true, default, 1f, 0);
            CameraPicture.Draw(visible.Opaque, rules);
            CameraPicture.End();
            return texture;
        }

        /// <summary>Makes it known to shaders. Null is let pass.</summary>
        internal static void Publish(RenderTexture texture)
        {
            if (texture != null)
                Shader.SetGlobalTexture(s_Name, texture);
        }

        /// <summary>Null is let pass.</summary>
        internal static void Release(RenderTexture texture)
        {
            if (texture == null)
                return;
            Shader.SetGlobalTexture(s_Name, null);
            RenderTexture.ReleaseTemporary(texture);
        }

        static RenderTexture Create(CameraPicture picture)
        {
            var shape = new RenderTextureDescriptor(picture.Camera.pixelWidth, picture.Camera.pixelHeight, GraphicsFormat.None, GraphicsFormat.D32_SFloat);
            if (picture.IsOfBothEyes)
                (shape.dimension, shape.volumeDepth, shape.vrUsage) = (TextureDimension.Tex2DArray, 2, VRTextureUsage.TwoEyes);
            var texture = RenderTexture.GetTemporary(shape);
            texture.filterMode = FilterMode.Point;
            return texture;
        }
    }
}
