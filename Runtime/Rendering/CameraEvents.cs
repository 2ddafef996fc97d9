using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// Tells a component that a camera which sees its layer begins to render, after everything has moved and before it culls, in the Built-in pipeline and in
    /// any other. Previews of the Inspector do not count, nor does a component that an earlier listener disabled or destroyed.
    /// </summary>
    sealed class CameraEvents
    {
        readonly Behaviour seen;
        readonly Action<Camera> begin;

        public CameraEvents(Behaviour seen, Action<Camera> begin)
        {
            this.seen = seen;
            this.begin = begin;
        }

        public void Listen()
        {
            Camera.onPreCull += Begin;
            RenderPipelineManager.beginCameraRendering += Begin;
        }

        public void Stop()
        {
            Camera.onPreCull -= Begin;
            RenderPipelineManager.beginCameraRendering -= Begin;
        }

        void Begin(ScriptableRenderContext context, Camera camera) => Begin(camera);

        void Begin(Camera camera)
        {
            if (seen != null && seen.isActiveAndEnabled && camera.cameraType != CameraType.Preview && (camera.cullingMask & 1 << seen.gameObject.layer) != 0)
                begin(camera);
        }
    }
}
