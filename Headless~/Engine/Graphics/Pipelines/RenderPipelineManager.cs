using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering
{
    /// <summary>The pipeline in use and its events. As in Unity a handler that throws ends that frame's rendering.</summary>
    public static class RenderPipelineManager
    {
        public static event Action<ScriptableRenderContext, List<Camera>> beginContextRendering;

        public static event Action<ScriptableRenderContext, List<Camera>> endContextRendering;

        public static event Action<ScriptableRenderContext, Camera> beginCameraRendering;

        public static event Action<ScriptableRenderContext, Camera> endCameraRendering;

        public static event Action activeRenderPipelineTypeChanged;

        public static event Action<RenderPipelineAsset, RenderPipelineAsset> activeRenderPipelineAssetChanged;

        public static event Action activeRenderPipelineCreated;

        public static event Action activeRenderPipelineDisposed;

        /// <summary>Made with the first picture; null before, and in the Built-in pipeline.</summary>
        public static RenderPipeline currentPipeline => RenderPipelines.Existing;

        internal static void RaiseBeginContext(ScriptableRenderContext context, List<Camera> cameras) => beginContextRendering?.Invoke(context, cameras);

        internal static void RaiseEndContext(ScriptableRenderContext context, List<Camera> cameras) => endContextRendering?.Invoke(context, cameras);

        internal static void RaiseBeginCamera(ScriptableRenderContext context, Camera camera) => beginCameraRendering?.Invoke(context, camera);

        internal static void RaiseEndCamera(ScriptableRenderContext context, Camera camera) => endCameraRendering?.Invoke(context, camera);

        internal static void RaiseCreated() => Guard(activeRenderPipelineCreated);

        internal static void RaiseDisposed() => Guard(activeRenderPipelineDisposed);

        internal static void RaiseChanged(RenderPipelineAsset from, RenderPipelineAsset to)
        {
            var changed = activeRenderPipelineAssetChanged;
            if (changed != null)
                LogRouter.Guard(() => changed(from, to));
            if (from?.GetType() != to?.GetType())
                Guard(activeRenderPipelineTypeChanged);
        }

        internal static void Forget()
        {
            beginContextRendering = endContextRendering = null;
            beginCameraRendering = endCameraRendering = null;
            activeRenderPipelineTypeChanged = activeRenderPipelineCreated = activeRenderPipelineDisposed = null;
            activeRenderPipelineAssetChanged = null;
        }

        static void Guard(Action callback)
        {
            if (callback != null)
                LogRouter.Guard(callback);
        }
    }
}
