using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>The enabled cameras and their turn in the frame.</summary>
    static class Cameras
    {
        internal static List<Camera> Running { get; } = new();

        internal static void RenderAll()
        {
            var cameras = Running.OrderBy(c => c.depth).ToList();
            if (RenderPipelines.Asset != null)
            {
                if (cameras.Count > 0)
                    RenderPipelines.Render(cameras);
            }
            else
            {
                foreach (var camera in cameras)
                    if (camera.IsRunning)
                        RenderBuiltIn(camera);
            }
            FrameMeshes.Clear();
        }

        /// <summary>Renders one camera now.</summary>
        internal static void Render(Camera camera)
        {
            if (RenderPipelines.Asset != null)
                RenderPipelines.Render(new List<Camera> { camera });
            else
                RenderBuiltIn(camera);
        }

        internal static void Forget()
        {
            Running.Clear();
            Renderers.All.Clear();
            Light.Running.Clear();
            FrameMeshes.Clear();
            RenderSettings.Forget();
            EmptyPictures.Forget();
            Camera.current = null;
            Camera.onPreCull = Camera.onPreRender = Camera.onPostRender = null;
        }

        static void RenderBuiltIn(Camera camera)
        {
            var previous = Camera.current;
            Camera.current = camera;
            Raise(camera, m => m.OnPreCull, Camera.onPreCull);
            if (Object.IsAlive(camera))
            {
                var visible = VisibleMeshes.Of(camera);
                foreach (var picture in CameraPicture.Of(camera))
                    RenderBuiltIn(picture, visible);
            }
            Camera.current = previous;
        }

        static void RenderBuiltIn(CameraPicture picture, VisibleMeshes visible)
        {
            var camera = picture.Camera;
            if (!Object.IsAlive(camera))
                return;
            camera.DrawnEye = picture.Eye;
            Raise(camera, m => m.OnPreRender, Camera.onPreRender);
            if (Object.IsAlive(camera))
                LogRouter.Guard(() => BuiltInPicture.Draw(picture, visible));
            Raise(camera, m => m.OnPostRender, Camera.onPostRender);
            camera.DrawnEye = Camera.MonoOrStereoscopicEye.Left;
        }

        static void Raise(Camera camera, Func<Messages, Message> message, Camera.CameraCallback callback)
        {
            if (!Object.IsAlive(camera))
                return;
            foreach (var script in camera.Owner.Components.OfType<MonoBehaviour>().ToList())
                if (script.IsRunning)
                    message(script.Messages).Send(script);
            if (callback != null)
                LogRouter.Guard(() => callback(camera));
        }
    }
}
