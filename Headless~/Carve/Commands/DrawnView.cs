using System;
using System.Linq;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless.Cli.Commands
{
    /// <summary>
    /// What a camera of the scene draws, by the eye shader: as Unity stores it, and how far it is. The camera sees what the <see cref="PerspectiveCamera"/>
    /// does; a headset has two of them side by side, <see cref="EyeDistance"/> apart, with parallel views.
    /// </summary>
    sealed class DrawnView
    {
        /// <summary>From eye to eye in metres.</summary>
        public const float EyeDistance = 0.064f;

        const float Nearest = 0.001f;

        readonly UnityHost host;
        readonly Camera camera;
        readonly PictureSize size;
        readonly bool isStereo;

        DrawnView(RenderScene scene, RenderRequest request, PerspectiveCamera place)
        {
            (host, size, isStereo) = (scene.Host, request.Size, request.Project.Stereo != HostStereo.Mono);
            var geometry = scene.Loader.Volume.Geometry;
            camera = new GameObject("camera").AddComponent<Camera>();
            camera.enabled = false;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = new Color32(request.Background.R, request.Background.G, request.Background.B, 255);
            camera.allowHDR = false;
            camera.allowMSAA = false;
            camera.fieldOfView = (float)place.VerticalFovDegrees;
            camera.aspect = (float)size.Width / size.Height;
            var target = VolumeSpace.LpsToLocal(geometry, place.TargetLps);
            var up = VolumeSpace.LpsToLocal(geometry, place.TargetLps + place.UpLps) - target;
            camera.transform.position = VolumeSpace.LpsToLocal(geometry, place.EyeLps);
            camera.transform.rotation = Quaternion.LookRotation(target - camera.transform.position, up);

            // As near to the volume as the planes may be, for a depth buffer that can tell surfaces apart.
            var reach = Reach(geometry);
            var distance = camera.transform.position.magnitude;
            camera.nearClipPlane = Math.Max(distance - reach, Nearest);
            camera.farClipPlane = distance + reach;
        }

        /// <summary>Bytes of RGBA and millimetres along each pixel's ray, infinity where nothing was drawn; the bottom row first.</summary>
        public readonly record struct Picture(int Width, int Height, byte[] Rgba, float[] DepthMm);

        /// <summary>Draws the scene as it is.</summary>
        public static Picture Draw(RenderScene scene, RenderRequest request, PerspectiveCamera place)
        {
            var view = new DrawnView(scene, request, place);
            return view.isStereo ? view.DrawEyes() : view.DrawMono(request.Project.ColorSpace);
        }

        // From the centre to the farthest corner in metres, and a voxel more.
        static float Reach(VolumeGeometry geometry)
        {
            var farthest = Enumerable.Range(0, VolumeGeometry.Corners).Max(corner => geometry.CornerOffset(corner).Length);
            var spacing = geometry.SpacingMm;
            return (float)((farthest + Math.Max(spacing.X, Math.Max(spacing.Y, spacing.Z))) / 1000);
        }

        Picture DrawMono(ColorSpace colorSpace)
        {
            var format = colorSpace == ColorSpace.Linear ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
            var target = new RenderTexture(size.Width, size.Height, format, GraphicsFormat.D32_SFloat) { name = "drawn" };
            target.Create();
            camera.targetTexture = target;
            camera.Render();
            var colors = AsyncGPUReadback.Request(target, 0);
            colors.WaitForCompletion();
            return new Picture(size.Width, size.Height, colors.GetData<byte>().ToArray(), Distances(host.ReadDepth(target), camera.projectionMatrix));
        }

        Picture DrawEyes()
        {
            var projection = camera.projectionMatrix;
            for (var eye = 0; eye < 2; eye++)
            {
                camera.SetStereoProjectionMatrix((Camera.StereoscopicEye)eye, projection);
            }

            camera.Render();
            var colors = Enumerable.Range(0, 2).Select(host.ReadEye).ToArray();
            var depths = Enumerable.Range(0, 2).Select(eye => Distances(host.ReadEyeDepth(eye), projection)).ToArray();
            return new Picture(2 * size.Width, size.Height, SideBySide.Join(colors, 4 * size.Width), SideBySide.Join(depths, size.Width));
        }

        float[] Distances(float[] stored, Matrix4x4 projection) =>
            DepthBuffer.ToMillimetres(stored, size.Width, projection, camera.nearClipPlane, camera.farClipPlane);
    }
}
