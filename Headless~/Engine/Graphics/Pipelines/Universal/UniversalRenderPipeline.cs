using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>
    /// Stands for URP: its events in its order, its passes of shaders, its depth texture. Headsets that take their eyes in turn make it announce a
    /// camera once per eye.
    /// </summary>
    sealed class UniversalRenderPipeline : RenderPipeline
    {
        readonly UniversalRenderPipelineAsset m_Asset;

        internal UniversalRenderPipeline(UniversalRenderPipelineAsset asset) => m_Asset = asset;

        protected override void Render(ScriptableRenderContext context, Camera[] cameras) => Render(context, cameras.ToList());

        protected override void Render(ScriptableRenderContext context, List<Camera> cameras)
        {
            BeginContextRendering(context, cameras);
            foreach (var camera in cameras.OrderBy(c => c.depth).ToList())
                if (Object.IsAlive(camera))
                    Render(context, camera);
            EndContextRendering(context, cameras);
            context.Submit();
        }

        protected override bool IsRenderRequestSupported<RequestData>(Camera camera, RequestData data) =>
            data is StandardRequest { destination: not null };

        protected override void ProcessRenderRequests<RequestData>(ScriptableRenderContext context, Camera camera, RequestData renderRequest)
        {
            if (renderRequest is not StandardRequest request)
                return;
            var (destination, mip, slice) = (request.destination, request.mipLevel, request.slice);
            var previous = camera.targetTexture;
            var whole = mip == 0 && slice == 0 && destination.dimension == TextureDimension.Tex2D;
            var target = whole ? destination : RenderTexture.GetTemporary(OneLevel(destination, mip));
            camera.targetTexture = target;
            try
            {
                Render(context, new List<Camera> { camera });
                if (!whole)
                    Graphics.CopyTexture(target, 0, 0, destination, slice, mip);
            }
            finally
            {
                if (Object.IsAlive(camera))
                    camera.targetTexture = previous;
                if (!whole)
                    RenderTexture.ReleaseTemporary(target);
            }
        }

        static RenderTextureDescriptor OneLevel(RenderTexture texture, int mip)
        {
            var shape = texture.descriptor;
            (shape.width, shape.height) = (Mathf.Max(1, texture.width >> mip), Mathf.Max(1, texture.height >> mip));
            (shape.dimension, shape.volumeDepth, shape.vrUsage) = (TextureDimension.Tex2D, 1, VRTextureUsage.None);
            (shape.useMipMap, shape.autoGenerateMips, shape.enableRandomWrite, shape.mipCount) = (false, false, false, 1);
            return shape;
        }

        void Render(ScriptableRenderContext context, Camera camera)
        {
            foreach (var picture in CameraPicture.Of(camera))
            {
                if (!Object.IsAlive(camera))
                    return;
                camera.DrawnEye = picture.Eye;
                BeginCameraRendering(context, camera);
                context.Submit();
                if (Object.IsAlive(camera))
                    UniversalPicture.Draw(picture, VisibleMeshes.Of(camera), m_Asset.SupportsCameraDepthTexture);
                EndCameraRendering(context, camera);
                context.Submit();
                camera.DrawnEye = Camera.MonoOrStereoscopicEye.Left;
            }
        }
    }
}
