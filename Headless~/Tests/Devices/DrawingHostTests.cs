using System;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless.Tests.Devices
{
    /// <summary>What a host draws as its options say: colour space, pipeline, headset, pretended device; and that nothing is left of it.</summary>
    public sealed class DrawingHostTests
    {
        readonly List<string> m_Messages = new();

        [TestCase(ColorSpace.Linear)]
        [TestCase(ColorSpace.Gamma)]
        public void Screen_HasTheColoursThatAreMeant(ColorSpace space)
        {
            using var host = Start(new HostOptions { ColorSpace = space, ScreenWidth = 16, ScreenHeight = 8 });
            Assert.That(QualitySettings.activeColorSpace, Is.EqualTo(space));
            var camera = MakeCamera();
            camera.backgroundColor = new Color32(128, 64, 191, 255);
            host.Step();
            Assert.That(At(host.ReadScreen(), 0), Is.EqualTo(new Color32(128, 64, 191, 255)), "people see the same in both");
            End(host);
        }

        [TestCase(ColorSpace.Linear, 0.2140411f, 0f)]
        [TestCase(ColorSpace.Gamma, 0.5f, 1f)]
        public void Shaders_ComputeInTheProjectsSpace(ColorSpace space, float expected, float isGamma)
        {
            using var host = Start(new HostOptions { ColorSpace = space });
            var texture = new Texture2D(1, 1);
            texture.SetPixel(0, 0, new Color(0, 0.5f, 0, 1));
            texture.Apply();
            var material = new Material(Shader.Load(Path.Combine(host.PackageRoot, "Headless~", "Tests", "Graphics", "Fixtures", "ColourSpace.shader")));
            material.mainTexture = texture;
            var target = new RenderTexture(4, 4, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.D32_SFloat);
            UnityEngine.Graphics.Blit(null, target, material, 0);
            var read = AsyncGPUReadback.Request(target);
            read.WaitForCompletion();
            var pixel = read.GetData<Color>()[0];
            Assert.That(pixel.r, Is.EqualTo(expected).Within(1e-5), "a material's colour");
            Assert.That(pixel.g, Is.EqualTo(expected).Within(3e-3), "a texture of colours");
            Assert.That(pixel.b, Is.EqualTo(isGamma), "UNITY_COLORSPACE_GAMMA");
            foreach (var o in new UnityEngine.Object[] { texture, material.shader, material, target })
                UnityEngine.Object.DestroyImmediate(o);
            End(host);
        }

        [TestCase(HostPipeline.BuiltIn, "", "Default-Material")]
        [TestCase(HostPipeline.Universal, "UniversalPipeline", "Lit")]
        [TestCase(HostPipeline.HighDefinition, "HDRenderPipeline", "Default-Material")]
        [TestCase(HostPipeline.Other, "OtherPipeline", "Default-Material")]
        public void Pipeline_IsThatOfTheOptions(HostPipeline pipeline, string tag, string material)
        {
            using var host = Start(new HostOptions { RenderPipeline = pipeline, ScreenWidth = 16, ScreenHeight = 8 });
            Assert.That(GraphicsSettings.currentRenderPipeline == null ? "" : GraphicsSettings.currentRenderPipeline.renderPipelineShaderTag, Is.EqualTo(tag));
            MakeCamera();
            var cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            Assert.That(cube.GetComponent<Renderer>().sharedMaterial.name, Is.EqualTo(material));
            host.Step();
            var middle = At(host.ReadScreen(), 4 * 16 + 8);
            var isDrawn = pipeline is HostPipeline.BuiltIn or HostPipeline.Universal;
            Assert.That(middle.r > 0, Is.EqualTo(isDrawn), middle.ToString());
            End(host);
        }

        [TestCase(HostStereo.MultiPass)]
        [TestCase(HostStereo.SinglePassInstanced)]
        [TestCase(HostStereo.Multiview)]
        public void Headset_HasAPictureForEachEye(HostStereo stereo)
        {
            var headset = new HostHeadset { EyeWidth = 32, EyeHeight = 16, Separation = 0.4f };
            using var host = Start(new HostOptions
            {
                Stereo = stereo,
                Headset = headset,
                UniversalDepthTexture = true,
                RenderPipeline = HostPipeline.Universal,
            });
            MakeCamera();
            GameObject.CreatePrimitive(PrimitiveType.Cube);
            host.Step();
            var (left, right) = (host.ReadEye(0), host.ReadEye(1));
            Assert.That(left, Has.Length.EqualTo(4 * 32 * 16));
            Assert.That(Leftmost(left), Is.GreaterThan(Leftmost(right)), "the left eye is left of the box's middle");
            Assert.That(() => host.ReadEye(2), Throws.TypeOf<ArgumentOutOfRangeException>());
            End(host);

            static int Leftmost(byte[] eye)
            {
                for (var x = 0; x < 32; x++)
                    for (var y = 0; y < 16; y++)
                        if (eye[4 * (y * 32 + x)] > 0)
                            return x;
                return -1;
            }
        }

        [Test]
        public void NoHeadset_HasNoEyes()
        {
            using var host = Start(new HostOptions());
            Assert.That(() => host.ReadEye(0), Throws.TypeOf<InvalidOperationException>().With.Message.Contains("HostOptions.Stereo"));
            End(host);
        }

        [TestCase(GraphicsDeviceType.OpenGLES3, false)]
        [TestCase(GraphicsDeviceType.Direct3D11, true)]
        [TestCase(GraphicsDeviceType.WebGPU, true)]
        public void PretendedDevice_IsWhatScriptsAndShadersSee(GraphicsDeviceType type, bool runs)
        {
            using var host = Start(new HostOptions { GraphicsDeviceType = type, ComputeShaders = type != GraphicsDeviceType.WebGPU });
            Assert.That(SystemInfo.graphicsDeviceType, Is.EqualTo(type));
            Assert.That(SystemInfo.supportsComputeShaders, Is.EqualTo(type != GraphicsDeviceType.WebGPU));
            var path = Path.Combine(TestContext.CurrentContext.WorkDirectory, "renderers.shader");
            File.WriteAllText(path, "Shader \"T\" { SubShader { Pass { HLSLPROGRAM\n#pragma exclude_renderers gles3\n#pragma vertex v\n#pragma fragment f\n"
                + "float4 v() : SV_POSITION { return 0; } float4 f() : SV_Target { return 0; }\nENDHLSL } } }");
            var shader = Shader.Load(path);
            Assert.That(shader.isSupported, Is.EqualTo(runs));
            UnityEngine.Object.DestroyImmediate(shader);
            End(host);
        }

        [Test]
        public void NullDevice_RunsNoComputeShaders()
        {
            using var host = Start(new HostOptions { GraphicsDeviceType = GraphicsDeviceType.Null });
            Assert.That(SystemInfo.supportsComputeShaders, Is.False);
            End(host);
        }

        UnityHost Start(HostOptions options)
        {
            m_Messages.Clear();
            options.Validation = true;
            options.Log = (type, message, _) =>
            {
                if (type != LogType.Log)
                    m_Messages.Add(message);
            };
            return UnityHost.Start(options);
        }

        /// <summary>At (0, 0, -3), black behind; ends with the scene.</summary>
        static Camera MakeCamera()
        {
            var camera = new GameObject("camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0, 0, -3);
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            return camera;
        }

        void End(UnityHost host)
        {
            foreach (var o in UnityEngine.Object.FindObjectsByType<Transform>(FindObjectsSortMode.None))
                UnityEngine.Object.DestroyImmediate(o.gameObject);
            host.Dispose();
            Assert.That(m_Messages, Is.Empty);
            Assert.That(host.Report.LeakCount, Is.Zero, host.Report.ToString());
        }

        static Color32 At(byte[] picture, int pixel) =>
            new(picture[4 * pixel], picture[4 * pixel + 1], picture[4 * pixel + 2], picture[4 * pixel + 3]);
    }
}
