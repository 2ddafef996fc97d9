using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve
{
    /// <summary>
    /// Tells that a camera which sees a GameObject's layer begins to render, after everything has moved and before it culls, in the Built-in pipeline and in
    /// any other. Previews of the Inspector do not count.
    /// </summary>
    sealed class CameraEvents
    {
        readonly GameObject seen;
        readonly Action<Camera> begin;

        public CameraEvents(GameObject seen, Action<Camera> begin)
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
            if (camera.cameraType != CameraType.Preview && (camera.cullingMask & 1 << seen.layer) != 0)
                begin(camera);
        }
    }
}
