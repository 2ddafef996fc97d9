using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>The enabled cameras and their turn in the frame.</summary>
    static class Cameras
    {
        internal static List<Camera> Running { get; } = new();

        /// <summary>What really draws a camera's picture; null while nothing does.</summary>
        internal static Action<Camera> Drawing { get; set; }

        internal static void RenderAll()
        {
            foreach (var camera in Running.OrderBy(c => c.depth).ToList())
                if (camera.IsRunning)
                    Render(camera);
        }

        internal static void Render(Camera camera)
        {
            var previous = Camera.current;
            Camera.current = camera;
            Raise(camera, m => m.OnPreCull, Camera.onPreCull);
            Raise(camera, m => m.OnPreRender, Camera.onPreRender);
            if (Drawing != null)
                LogRouter.Guard(() => Drawing(camera));
            Raise(camera, m => m.OnPostRender, Camera.onPostRender);
            Camera.current = previous;
        }

        internal static void Forget()
        {
            Running.Clear();
            Drawing = null;
            Camera.current = null;
            Camera.onPreCull = Camera.onPreRender = Camera.onPostRender = null;
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
