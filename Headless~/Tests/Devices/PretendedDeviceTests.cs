using System.Collections.Generic;
using AnatomyCarve.Tests;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless.Tests.Devices
{
    /// <summary>Devices on which no volume can be: a sentence in the Console, once, and the same one for the Inspector.</summary>
    public sealed class PretendedDeviceTests
    {
        readonly List<string> errors = [];

        [TestCase(GraphicsDeviceType.OpenGLES3, true, "OpenGL ES")]
        [TestCase(GraphicsDeviceType.OpenGLCore, true, "OpenGL is not supported")]
        [TestCase(GraphicsDeviceType.Null, false, "no graphics device")]
        [TestCase(GraphicsDeviceType.Direct3D11, false, "no compute shaders")]
        public void Draw_OnADeviceThatCannot_SaysWhyOnce(GraphicsDeviceType type, bool computeShaders, string expected)
        {
            errors.Clear();
            using UnityHost host = UnityHost.Start(new HostOptions { GraphicsDeviceType = type, ComputeShaders = computeShaders, Log = Remember });
            var renderer = new GameObject("Volume", typeof(VolumeLoader), typeof(CarvedVolumeRenderer)).GetComponent<CarvedVolumeRenderer>();
            renderer.Loader.SetVolume(Phantoms.Cube(12, "Cube"));
            Camera camera = MakeCamera();
            for (int frame = 0; frame < 3; frame++)
            {
                host.Step();
                camera.Render();
            }
            Assert.That(renderer.Problem, Does.Contain(expected));
            Assert.That(errors, Has.Count.EqualTo(1));
            Assert.That(errors[0], Does.Contain(expected));
            Assert.That(renderer.Render(camera), Is.Null);
        }

        [TestCase(GraphicsDeviceType.Direct3D11)]
        [TestCase(GraphicsDeviceType.Direct3D12)]
        [TestCase(GraphicsDeviceType.Metal)]
        [TestCase(GraphicsDeviceType.Vulkan)]
        public void Draw_OnADeviceThatCan_SaysNothing(GraphicsDeviceType type)
        {
            errors.Clear();
            using UnityHost host = UnityHost.Start(new HostOptions { GraphicsDeviceType = type, Log = Remember });
            var renderer = new GameObject("Volume", typeof(VolumeLoader), typeof(CarvedVolumeRenderer)).GetComponent<CarvedVolumeRenderer>();
            renderer.Loader.SetVolume(Phantoms.Cube(12, "Cube"));
            MakeCamera().Render();
            Assert.That(renderer.Problem, Is.Null);
            Assert.That(errors, Is.Empty);
        }

        static Camera MakeCamera()
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.enabled = false;
            camera.transform.position = new Vector3(0f, 0f, -0.1f);
            camera.nearClipPlane = 0.01f;
            camera.targetTexture = new RenderTexture(16, 16, 32);
            return camera;
        }

        void Remember(LogType type, string message, string stackTrace)
        {
            if (type is LogType.Error or LogType.Exception or LogType.Assert)
                errors.Add(message);
        }
    }
}
