using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>The texture with the depth of what is opaque, of both pipelines.</summary>
    public sealed class CameraDepthTests : DrawTest
    {
        const int Middle = Size / 2;

        [TearDown]
        public void BackToBuiltIn() => ProjectPipeline.Forget();

        [TestCase("BuiltIn")]
        [TestCase("Universal")]
        public void DepthTexture_HoldsWhatIsOpaque(string pipeline)
        {
            ProjectPipeline.Choose(Enum.Parse<PipelineKind>(pipeline));
            var target = Target();
            var camera = Camera(target);
            camera.depthTextureMode = DepthTextureMode.Depth;
            // Above the axis, so that a picture that is turned over would show.
            Object(Cube, Opaque(), new Vector3(0, 1.2f, 2));
            Object(Cube, Material("SceneDepth"), new Vector3(0, 0, -2), 2f);
            camera.Render();
            Assert.That(Pixel(target, Middle, Middle + 6).r, Is.EqualTo(6.5f).Within(0.01f), "through the upper half the opaque box is seen");
            Assert.That(Pixel(target, Middle, Middle + 6).g, Is.EqualTo(2f).Within(0.01f), "its own distance");
            Assert.That(Pixel(target, Middle, Middle - 6).r, Is.EqualTo(50f).Within(0.1f), "nothing: the far plane");
        }

        [TestCase("BuiltIn")]
        [TestCase("Universal")]
        public void DepthTexture_OfThePictureOnTheScreen_IsTheRightWayUp(string pipeline)
        {
            ProjectPipeline.Choose(Enum.Parse<PipelineKind>(pipeline), depthTexture: true);
            (Screen.width, Screen.height) = (Size, Size);
            var camera = Camera(null);
            camera.depthTextureMode = DepthTextureMode.Depth;
            Object(Cube, Opaque(), new Vector3(0, 1.2f, 2));
            var material = Material("SceneDepth");
            material.SetFloat("_Unit", 50);
            Object(Cube, material, new Vector3(0, 0, -2), 2f);
            camera.Render();
            var screen = GraphicsSetUp.Host.ReadScreen();
            (Screen.width, Screen.height) = (1280, 720);
            Assert.That(Distance(Middle + 6), Is.EqualTo(6.5f).Within(0.3f));
            Assert.That(Distance(Middle - 6), Is.EqualTo(50).Within(0.3f));
            Assert.That(screen[0], Is.Zero, "the background");

            float Distance(int row) => 50 * Mathf.GammaToLinearSpace(screen[4 * (Size * row + Middle)] / 255f);
        }

        [Test]
        public void DepthTexture_OfAPictureWithSamples_IsThereToo()
        {
            ProjectPipeline.Choose(PipelineKind.Universal, depthTexture: true);
            var target = Own(new RenderTexture(Size, Size, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.D32_SFloat) { antiAliasing = 4 });
            Object(Cube, Opaque(), new Vector3(0, 0, 2));
            Object(Cube, Material("SceneDepth"), new Vector3(0, 0, -2), 2f);
            Camera(target).Render();
            Assert.That(Pixel(target, Middle, Middle).r, Is.EqualTo(6.5f).Within(0.01f));
        }

        Material Opaque()
        {
            var name = RenderPipelines.Asset != null ? "Universal Render Pipeline/Unlit" : "Unlit/Color";
            return Own(new Material(UnityEngine.Shader.Find(name)));
        }
    }
}
