using System.Collections.Generic;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Drawing
{
    /// <summary>The eye shader's picture against the kernel's for matrices that no plain camera has, and for extreme scales and distances.</summary>
    sealed class CameraMatrixTests : DrawnScene
    {
        const double AllowedShare = 0.005;

        static readonly Vector3 From = new Vector3(0.03f, 0.05f, -0.06f);

        CarvedVolumeRenderer volume;
        Camera viewer;

        [SetUp]
        public void MakeScene()
        {
            volume = MakeVolume(Phantoms.Markers());
            viewer = MakeDrawingCamera(From, Vector3.up);
        }

        static readonly string[] Changes = { "moved aside", "moved ahead", "rolled", "stretched" };

        [Test]
        public void Picture_OfAProjectionWithAViewInIt_IsTheKernels([ValueSource(nameof(Changes))] string change)
        {
            viewer.projectionMatrix *= Change(change);
            AssertTheKernels();
        }

        [Test]
        public void Picture_OfAViewOfItsOwn_IsTheKernels([ValueSource(nameof(Changes))] string change)
        {
            viewer.worldToCameraMatrix = Change(change) * viewer.worldToCameraMatrix;
            AssertTheKernels();
        }

        [Test]
        public void Picture_OfAScaledView_IsTheKernels()
        {
            viewer.worldToCameraMatrix = Matrix4x4.Scale(3f * Vector3.one) * viewer.worldToCameraMatrix;
            AssertTheKernels();
        }

        [Test]
        public void Picture_OfAProjectionWithPlanesOfItsOwn_IsTheKernels()
        {
            viewer.projectionMatrix = Matrix4x4.Perspective(40f, 1f, 0.08f, 0.09f);
            AssertTheKernels();
        }

        [Test]
        public void Picture_OfSlantedParallelRays_IsTheKernels()
        {
            viewer.orthographic = true;
            viewer.orthographicSize = 0.03f;
            Matrix4x4 p = viewer.projectionMatrix;
            p.m02 = 3f;
            p.m03 = 0.24f;
            viewer.projectionMatrix = p;
            AssertTheKernels();
        }

        [Test]
        public void Picture_OfAParallelCameraThatSeesBehindItself_IsTheKernels()
        {
            Look(new Vector3(0.001f, 0.002f, -0.004f), Vector3.zero);
            viewer.orthographic = true;
            viewer.orthographicSize = 0.02f;
            viewer.nearClipPlane = -0.05f;
            AssertTheKernels();
        }

        [Test]
        public void ObliqueNearPlane_CutsTheVolumeInTheEyeShader()
        {
            Color[] whole = Draw(viewer);
            Look(From, Vector3.zero);
            Matrix4x4 worldToCamera = viewer.worldToCameraMatrix;
            Vector3 point = worldToCamera.MultiplyPoint(Vector3.zero), normal = worldToCamera.MultiplyVector(new Vector3(-1f, -0.3f, 0.6f)).normalized;
            viewer.projectionMatrix = Oblique(viewer.projectionMatrix, new Vector4(normal.x, normal.y, normal.z, -Vector3.Dot(point, normal)));
            int cut = CountDrawn(Draw(viewer), viewer);
            Assert.That(cut, Is.GreaterThan(200).And.LessThan(CountDrawn(whole, viewer) - 200));
        }

        [Test]
        public void Picture_OfAScaledVolume_IsTheKernels([Values(1e-4f, 1e-3f, 100f, 1e4f, -1e-4f, -1e4f)] float scale)
        {
            float size = Mathf.Abs(scale);
            volume.transform.localScale = scale * Vector3.one;
            viewer.nearClipPlane = 0.001f * size;
            viewer.farClipPlane = 10f * size;
            Look(From * size, Vector3.zero);
            AssertTheKernels();
        }

        [Test]
        public void Picture_OfAVolumeFarFromTheOrigin_IsTheKernels([Values(10f, 100f)] float away)
        {
            volume.transform.position = new Vector3(away, -away, away);
            Look(From, volume.transform.position);
            AssertTheKernels();
        }

        [Test]
        public void Picture_BetweenExtremePlanes_IsTheKernels()
        {
            viewer.nearClipPlane = 1e-6f;
            viewer.farClipPlane = 1e6f;
            AssertTheKernels();
        }

        [Test]
        public void Picture_OfAnExtremeFieldOfView_IsTheKernels([Values(0.01f, 170f)] float degrees)
        {
            Look(degrees < 1f ? From * 3000f : new Vector3(0f, 0f, -0.022f), Vector3.zero);
            viewer.fieldOfView = degrees;
            viewer.farClipPlane = 1000f;
            viewer.nearClipPlane = degrees < 1f ? 1f : 0.001f;
            AssertTheKernels(20);
        }

        /// <summary>What a projection may hold besides itself: its w depends on the depth alone.</summary>
        static Matrix4x4 Change(string change)
        {
            switch (change)
            {
                case "moved aside": return Matrix4x4.Translate(new Vector3(0.01f, -0.004f, 0f));
                case "moved ahead": return Matrix4x4.Translate(new Vector3(0f, 0f, -0.01f));
                case "rolled": return Matrix4x4.Rotate(Quaternion.Euler(0f, 0f, 30f));
                default: return Matrix4x4.Scale(new Vector3(1.2f, 0.8f, 1f));
            }
        }

        void Look(Vector3 offset, Vector3 target)
        {
            viewer.transform.position = target + offset;
            viewer.transform.rotation = Quaternion.LookRotation(-(offset * 1e4f).normalized, Vector3.up);
        }

        void AssertTheKernels(int leastPixels = 200)
        {
            Color[] drawn = Draw(viewer);
            Assert.That(CountDrawn(drawn, viewer), Is.GreaterThan(leastPixels), "something is seen");
            AssertAlike(drawn, Over(volume.Render(viewer).Read(), viewer), AllowedShare, TestContext.CurrentContext.Test.Name);
        }

        /// <summary>A projection whose near plane is another one (Lengyel, "Oblique View Frustum Depth Projection and Clipping", 2005).</summary>
        static Matrix4x4 Oblique(Matrix4x4 projection, Vector4 plane)
        {
            Vector4 corner = projection.inverse * new Vector4(Mathf.Sign(plane.x), Mathf.Sign(plane.y), 1f, 1f);
            projection.SetRow(2, plane * (2f / Vector4.Dot(plane, corner)) - projection.GetRow(3));
            return projection;
        }
    }
}
