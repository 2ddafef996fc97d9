using System.Collections.Generic;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Drawing
{
    /// <summary>
    /// The eye shader's picture against the kernel's of the same camera. Both march the same rays; what differs is the rounding of where a ray begins, which
    /// can move a sample over an edge: hence a share of pixels that may differ.
    /// </summary>
    sealed class EyeShaderTests : DrawnScene
    {
        /// <summary>None of 9,216 pixels was seen to differ where matter is soft, up to 12 at hard edges.</summary>
        const double AllowedShare = 0.002;

        static IEnumerable<Vector3> Positions() => new[]
        {
            new Vector3(0f, 0f, -0.08f), new Vector3(0.05f, 0.04f, -0.05f), new Vector3(-0.07f, 0.01f, 0.03f), new Vector3(0.001f, 0.09f, 0.002f),
        };

        [Test]
        public void Picture_OfOpaqueMatter_IsTheKernels([ValueSource(nameof(Positions))] Vector3 position, [Values] TextureLayout layout)
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Layout = layout;
            renderer.Stack.SetActive(new Vector3(0.003f, 0.004f, -0.01f), 0.008f);
            AssertTheKernels(renderer, MakeDrawingCamera(position, Vector3.up), layout.ToString());
        }

        [Test]
        public void Picture_OfTranslucentMatter_IsTheKernels([Values("fast", "balanced", "best")] string quality)
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.TransferFunction = OpacityTransferFunction.Parse("0:0.01,500:0.05,1000:0.2");
            renderer.Quality = RenderQuality.Named(quality);
            renderer.Stack.SetActive(new Vector3(0f, 0.004f, -0.004f), 0.007f);
            AssertTheKernels(renderer, MakeDrawingCamera(new Vector3(0.03f, 0.05f, -0.06f), Vector3.up), quality);
        }

        [Test]
        public void Picture_OfATurnedAndScaledVolume_IsTheKernels()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.transform.SetPositionAndRotation(new Vector3(0.3f, -0.2f, 0.5f), Quaternion.Euler(20f, 130f, -40f));
            renderer.transform.localScale = new Vector3(2f, 2f, 2f);
            Camera camera = MakeDrawingCamera(new Vector3(0.3f, -0.1f, 0.35f), Vector3.up);
            camera.transform.LookAt(renderer.transform);
            AssertTheKernels(renderer, camera, "turned and scaled");
        }

        [Test]
        public void Picture_OfAnUnevenlyScaledAndMirroredVolume_IsTheKernels()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.transform.localScale = new Vector3(1.5f, -0.7f, 1f);
            AssertTheKernels(renderer, MakeDrawingCamera(new Vector3(0.03f, 0.05f, -0.06f), Vector3.up), "mirrored");
        }

        [Test]
        public void Picture_OfAnObliqueGrid_IsTheKernels([Values(0, 7, 21, 40)] int orientation)
        {
            VectorMm[] axes = new List<VectorMm[]>(Phantoms.Orientations())[orientation];
            var shear = new VectorMm(0.2, -0.1, 0.15);
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(Phantoms.Centred(axes[0] + shear, 1.2 * axes[1], axes[2], 40, 34, 44), 40, 34, 44));
            AssertTheKernels(renderer, MakeDrawingCamera(new Vector3(0.03f, 0.05f, -0.06f), Vector3.up), "orientation " + orientation);
        }

        [Test]
        public void Picture_OfAnOrthographicCamera_IsTheKernels()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0.03f, 0.05f, -0.06f), Vector3.up);
            camera.orthographic = true;
            camera.orthographicSize = 0.025f;
            AssertTheKernels(renderer, camera, "orthographic");
        }

        [Test]
        public void Picture_OfAnOffCentreProjection_IsTheKernels()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up, 90, 60);
            camera.projectionMatrix = Matrix4x4.Frustum(-0.0006f, 0.0003f, -0.0002f, 0.0004f, camera.nearClipPlane, camera.farClipPlane);
            AssertTheKernels(renderer, camera, "off-centre");
        }

        [Test]
        public void Picture_OfACameraWithAViewOfItsOwn_IsTheKernels()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            camera.worldToCameraMatrix = Matrix4x4.Translate(new Vector3(0.01f, -0.006f, 0.02f)) * camera.worldToCameraMatrix;
            AssertTheKernels(renderer, camera, "beside the camera's GameObject, as an eye is");
        }

        [Test]
        public void Pictures_OfTwoVolumes_AreThoseOfEach()
        {
            CarvedVolumeRenderer left = MakeVolume(Phantoms.Markers()), right = MakeVolume(Phantoms.Cube(14, "Cube"));
            left.transform.position = new Vector3(-0.025f, 0f, 0f);
            right.transform.position = new Vector3(0.025f, 0f, 0f);
            right.Light.Direction = new Vector3(-1f, 0.2f, 0.3f);
            right.Light.Color = Color.red;
            right.Quality.Step = 0.9f;
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            Color[] drawn = Draw(camera);
            Color[] expected = Over(left.Render(camera).Read(), camera), second = Over(right.Render(camera).Read(), camera);
            int ofLeft = CountDrawn(expected, camera), ofRight = CountDrawn(second, camera);
            for (int p = 0; p < expected.Length; p++)
                if (p % 96 >= 48)
                    expected[p] = second[p];
            Assert.That(CountDrawn(expected, camera), Is.EqualTo(ofLeft + ofRight), "one volume lies left of the other");
            Assert.That(Mathf.Min(ofLeft, ofRight), Is.GreaterThan(200));
            AssertAlike(drawn, expected, AllowedShare, "two volumes");
        }

        [Test]
        public void Picture_FromInside_IsTheKernels()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0.002f, 0.001f, -0.011f), Vector3.up);
            camera.transform.rotation = Quaternion.LookRotation(new Vector3(0.1f, 0.3f, 1f));
            AssertTheKernels(renderer, camera, "from inside");
        }

        [Test]
        public void Picture_WithPlanesThroughTheVolume_IsTheKernels()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.05f), Vector3.up);
            camera.nearClipPlane = 0.045f;
            camera.farClipPlane = 0.055f;
            Color[] drawn = Draw(camera);
            Assert.That(CountDrawn(drawn, camera), Is.GreaterThan(100), "the far plane cuts the box's back away, and what is in front stays");
            AssertAlike(drawn, Over(renderer.Render(camera).Read(), camera), AllowedShare, "between planes");
        }

        static void AssertTheKernels(CarvedVolumeRenderer renderer, Camera camera, string what)
        {
            Color[] drawn = Draw(camera);
            Assert.That(CountDrawn(drawn, camera), Is.GreaterThan(200), "something is seen");
            AssertAlike(drawn, Over(renderer.Render(camera).Read(), camera), AllowedShare, what);
        }
    }
}
