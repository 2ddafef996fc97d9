using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering
{
    /// <summary>What renders all cameras in place of the Built-in pipeline.</summary>
    public abstract class RenderPipeline
    {
        protected RenderPipeline()
        {
        }

        public bool disposed { get; private set; }

        protected abstract void Render(ScriptableRenderContext context, Camera[] cameras);

        protected virtual void Render(ScriptableRenderContext context, List<Camera> cameras) => Render(context, cameras.ToArray());

        protected virtual void Dispose(bool disposing)
        {
        }

        protected virtual bool IsRenderRequestSupported<RequestData>(Camera camera, RequestData data) => false;

        protected virtual void ProcessRenderRequests<RequestData>(ScriptableRenderContext context, Camera camera, RequestData renderRequest)
        {
        }

        protected static void BeginContextRendering(ScriptableRenderContext context, List<Camera> cameras) =>
            RenderPipelineManager.RaiseBeginContext(context, cameras);

        protected static void BeginCameraRendering(ScriptableRenderContext context, Camera camera) =>
            RenderPipelineManager.RaiseBeginCamera(context, camera);

        protected static void EndContextRendering(ScriptableRenderContext context, List<Camera> cameras) =>
            RenderPipelineManager.RaiseEndContext(context, cameras);

        protected static void EndCameraRendering(ScriptableRenderContext context, Camera camera) => RenderPipelineManager.RaiseEndCamera(context, camera);

        public static bool SupportsRenderRequest<RequestData>(Camera camera, RequestData data)
        {
            MainThread.Check("SupportsRenderRequest");
            return RenderPipelines.Current?.IsRenderRequestSupported(camera, data) ?? false;
        }

        /// <summary>Renders a camera now, into what the request says.</summary>
        public static void SubmitRenderRequest<RequestData>(Camera camera, RequestData data)
        {
            MainThread.Check("SubmitRenderRequest");
            if (camera == null)
                throw new ArgumentNullException(nameof(camera));
            var pipeline = RenderPipelines.Current;
            if (pipeline == null)
            {
                Debug.LogWarning("SubmitRenderRequest is only available with a scriptable render pipeline");
                return;
            }
            if (!pipeline.IsRenderRequestSupported(camera, data))
            {
                Debug.LogWarning($"The render pipeline does not support the request {typeof(RequestData).Name}");
                return;
            }
            RenderPipelines.Process(camera, data);
        }

        internal void RenderAll(ScriptableRenderContext context, List<Camera> cameras) => Render(context, cameras);

        internal void Process<RequestData>(ScriptableRenderContext context, Camera camera, RequestData data) => ProcessRenderRequests(context, camera, data);

        internal void End()
        {
            disposed = true;
            Dispose(true);
        }

        /// <summary>A picture of a camera into a texture.</summary>
        public class StandardRequest
        {
            public RenderTexture destination;
            public int mipLevel;
            public CubemapFace face = CubemapFace.Unknown;
            public int slice;
        }
    }
}
