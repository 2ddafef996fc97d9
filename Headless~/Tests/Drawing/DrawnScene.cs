using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Drawing
{
    /// <summary>A volume and a camera in a project of one's own, and what is drawn there against what the kernel makes of the same rays.</summary>
    sealed class DrawnScene : IDisposable
    {
        const int Size = 96;
        static readonly Color32 Behind = new(40, 60, 90, 255);

        readonly UnityHost host;
        readonly HostOptions options;

        public DrawnScene(HostOptions options)
        {
            this.options = options;
            options.Validation = true;
            options.Log = (type, message, _) =>
            {
                if (type is LogType.Error or LogType.Exception or LogType.Assert)
                    Errors.Add(message);
            };
            options.Headset = new HostHeadset
            {
                EyeWidth = Size,
                EyeHeight = Size,
                Separation = 0.01f,
                LeftEye = new FrustumPlanes { left = -0.5f, right = 0.4f, bottom = -0.48f, top = 0.45f },
                RightEye = new FrustumPlanes { left = -0.4f, right = 0.5f, bottom = -0.48f, top = 0.45f },
            };
            host = UnityHost.Start(options);
            Camera = new GameObject("Camera").AddComponent<Camera>();
            Camera.enabled = false;
            Camera.clearFlags = CameraClearFlags.SolidColor;
            Camera.backgroundColor = Behind;
            Camera.allowHDR = Camera.allowMSAA = false;
            Camera.nearClipPlane = 0.01f;
            Camera.farClipPlane = 5f;
            Target = new RenderTexture(Size, Size,
                options.ColorSpace == ColorSpace.Linear ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
            Assert.That(Target.Create(), Is.True);
        }

        public List<string> Errors { get; } = [];

        public Camera Camera { get; }

        public CarvedVolumeRenderer Renderer { get; private set; }

        RenderTexture Target { get; }

        /// <summary>A frame; then its Start methods have run and its readers have had time.</summary>
        public void Step() => host.Step();

        /// <summary>The volume, looked at from where all of it is seen.</summary>
        public CarvedVolumeRenderer Show(SegmentedVolume volume)
        {
            var shown = new GameObject("Volume", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer));
            shown.GetComponent<VolumeLoader>().SetVolume(volume);
            Renderer = shown.GetComponent<CarvedVolumeRenderer>();
            LookAtVolume();
            return Renderer;
        }

        /// <summary>The phantom of markers with a sphere that cuts into it, opaque or like a veil.</summary>
        public void ShowMarkers(string transferFunction = "400:0,600:1")
        {
            Show(Phantoms.Markers()).TransferFunction = OpacityTransferFunction.Parse(transferFunction);
            Renderer.Stack.SetActive(new Vector3(0.003f, 0.004f, -0.01f), 0.008f);
            Renderer.transform.SetPositionAndRotation(new Vector3(0.02f, -0.01f, 0.03f), Quaternion.Euler(10f, 30f, -20f));
            LookAtVolume();
        }

        /// <summary>A folder with a scan, a segmentation, a transfer function and a carving.</summary>
        public void ShowFiles(string scan, string labels, string transferFunction, string carving)
        {
            var volume = new GameObject("Volume", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer));
            var loader = volume.GetComponent<VolumeLoader>();
            Renderer = volume.GetComponent<CarvedVolumeRenderer>();
            var load = loader.LoadAsync(scan, labels);
            while (!load.IsCompleted)
            {
                host.Step();
                Thread.Sleep(1);
            }
            load.GetAwaiter().GetResult();
            Renderer.TransferFunction = TransferFunctionFile.Read(transferFunction);
            Renderer.Stack.Load(carving);
            LookAtVolume();
        }

        void LookAtVolume()
        {
            Vector3 size = VolumeBounds();
            Vector3 from = new Vector3(0.35f, 0.45f, -1f).normalized * (1.1f * size.magnitude);
            Camera.transform.position = Renderer.transform.position + from;
            Camera.transform.rotation = Quaternion.LookRotation(-from, Vector3.up);
            Camera.fieldOfView = 50f;
            Camera.aspect = 1f;
        }

        Vector3 VolumeBounds()
        {
            VolumeGeometry grid = Renderer.Volume.Geometry;
            return new Vector3((float)(grid.SizeI * grid.SpacingMm.X), (float)(grid.SizeJ * grid.SpacingMm.Y), (float)(grid.SizeK * grid.SpacingMm.Z)) / 1000f;
        }

        /// <summary>A camera's picture: one, or the headset's two.</summary>
        public void Draw()
        {
            Camera.targetTexture = options.Stereo == HostStereo.Mono ? Target : null;
            Camera.Render();
        }

        public int Eyes => options.Stereo == HostStereo.Mono ? 1 : 2;

        public Color32[] Drawn(int eye)
        {
            if (options.Stereo != HostStereo.Mono)
                return ToColors(host.ReadEye(eye));
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(Target, 0);
            request.WaitForCompletion();
            return ToColors(request.GetData<byte>().ToArray());
        }

        /// <summary>What the depth buffer holds, as millimetres along the pixels' rays; infinity where nothing was drawn.</summary>
        public float[] DrawnDepthMm(int eye) => DepthBuffer.ToMillimetres(
            options.Stereo == HostStereo.Mono ? host.ReadDepth(Target) : host.ReadEyeDepth(eye), Size, Projection(eye), Camera.nearClipPlane, Camera.farClipPlane);

        /// <summary>The kernel's picture of what an eye sees.</summary>
        public PictureData Kernel(int eye)
        {
            var twin = new GameObject("Twin").AddComponent<Camera>();
            twin.enabled = false;
            twin.nearClipPlane = Camera.nearClipPlane;
            twin.farClipPlane = Camera.farClipPlane;
            twin.worldToCameraMatrix = Eyes == 1 ? Camera.worldToCameraMatrix : Camera.GetStereoViewMatrix((Camera.StereoscopicEye)eye);
            twin.projectionMatrix = Projection(eye);
            // The place matters too: rays begin there.
            twin.transform.SetPositionAndRotation(twin.worldToCameraMatrix.inverse.GetPosition(), Camera.transform.rotation);
            PictureData picture = Renderer.Render(twin, Size, Size).Read();
            UnityEngine.Object.DestroyImmediate(twin.gameObject);
            return picture;
        }

        /// <summary>A kernel's pixels over the background, blended and encoded as the project does it: codes from 0 to 255, not rounded.</summary>
        public Vector3[] Blended(PictureData picture)
        {
            bool isLinear = options.ColorSpace == ColorSpace.Linear;
            Color encodedBehind = Behind, linearBehind = encodedBehind.linear;
            return Array.ConvertAll(picture.Color, c =>
            {
                Color color = isLinear ? (c + (1f - c.a) * linearBehind).gamma : Encoded(c) + (1f - c.a) * encodedBehind;
                return 255f * new Vector3(Mathf.Clamp01(color.r), Mathf.Clamp01(color.g), Mathf.Clamp01(color.b));
            });
        }

        public void Dispose()
        {
            foreach (Transform transform in UnityEngine.Object.FindObjectsByType<Transform>(FindObjectsInactive.Include, FindObjectsSortMode.None))
                if (transform != null)
                    UnityEngine.Object.DestroyImmediate(transform.root.gameObject);
            UnityEngine.Object.DestroyImmediate(Target);
            host.Step(); // what the objects held goes
            host.Step();
            host.Dispose();
            HostEnds.Note("Tests/Drawing", host.Report.LeakCount == 0 && host.Report.ErrorsAtEnd == 0 && host.Report.ValidationMessages == 0, host.Report);
        }

        static Color Encoded(Color premultiplied) => premultiplied.a > 0f ? (premultiplied * (1f / premultiplied.a)).gamma * premultiplied.a : default;

        Matrix4x4 Projection(int eye) => Eyes == 1 ? Camera.projectionMatrix : Camera.GetStereoProjectionMatrix((Camera.StereoscopicEye)eye);

        static Color32[] ToColors(byte[] rgba)
        {
            var colors = new Color32[rgba.Length / 4];
            for (int p = 0; p < colors.Length; p++)
                colors[p] = new Color32(rgba[4 * p], rgba[4 * p + 1], rgba[4 * p + 2], rgba[4 * p + 3]);
            return colors;
        }

        /// <summary>A file of the sample.</summary>
        public static string Sample(string name) => Path.Combine(Layout.PackageTree.OfRepository().Root, "Samples~/DemoHead", name);
    }
}
