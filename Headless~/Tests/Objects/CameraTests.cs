using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools.Utils;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class CameraTests : SceneTests
    {
        static readonly Vector3EqualityComparer s_Near = new(1E-5f);

        /// <summary>At (0,0,-10), looking at the origin, 90 degrees, square.</summary>
        static Camera Square()
        {
            var camera = Make<Camera>("camera");
            camera.transform.position = new Vector3(0f, 0f, -10f);
            camera.fieldOfView = 90f;
            camera.aspect = 1f;
            camera.nearClipPlane = 1f;
            return camera;
        }

        [Test]
        public void WorldToCamera_PutsPointsInFrontAtNegativeZ() =>
            Assert.That(Square().worldToCameraMatrix.MultiplyPoint3x4(new Vector3(1f, 2f, 0f)), Is.EqualTo(new Vector3(1f, 2f, -10f)).Using(s_Near));

        [Test]
        public void ViewportPointToRay_StartsOnTheNearPlane() =>
            Assert.That(Square().ViewportPointToRay(new Vector3(1f, 0.5f)).origin, Is.EqualTo(new Vector3(1f, 0f, -9f)).Using(s_Near));

        [Test]
        public void ViewportPointToRay_PointsThroughThePicture() =>
            Assert.That(Square().ViewportPointToRay(new Vector3(1f, 0.5f)).direction, Is.EqualTo(new Vector3(0.70710678f, 0f, 0.70710678f)).Using(s_Near));

        [Test]
        public void ViewportPointToRay_OfOrthographicCamera_IsParallel()
        {
            var camera = Square();
            camera.orthographic = true;
            camera.orthographicSize = 3f;
            var ray = camera.ViewportPointToRay(new Vector3(1f, 0f));
            Assert.That(ray.origin, Is.EqualTo(new Vector3(3f, -3f, -9f)).Using(s_Near));
            Assert.That(ray.direction, Is.EqualTo(Vector3.forward).Using(s_Near));
        }

        [Test]
        public void ViewportToWorldPoint_TakesZAsDistance() =>
            Assert.That(Square().ViewportToWorldPoint(new Vector3(1f, 1f, 10f)), Is.EqualTo(new Vector3(10f, 10f, 0f)).Using(s_Near));

        [Test]
        public void WorldToViewportPoint_UndoesViewportToWorldPoint() =>
            Assert.That(Square().WorldToViewportPoint(new Vector3(10f, 10f, 0f)), Is.EqualTo(new Vector3(1f, 1f, 10f)).Using(s_Near));

        [Test]
        public void ScreenPointToRay_OfTheCentre_IsForward()
        {
            var camera = Square();
            var ray = camera.ScreenPointToRay(new Vector3(camera.pixelWidth / 2f, camera.pixelHeight / 2f));
            Assert.That(ray.direction, Is.EqualTo(Vector3.forward).Using(s_Near));
        }

        [Test]
        public void ProjectionMatrix_SetByHand_SticksUntilReset()
        {
            var camera = Square();
            camera.projectionMatrix = Matrix4x4.identity;
            camera.fieldOfView = 20f;
            var stuck = camera.projectionMatrix.isIdentity;
            camera.ResetProjectionMatrix();
            Assert.That((stuck, camera.projectionMatrix.isIdentity), Is.EqualTo((true, false)));
        }

        [Test]
        public void EnabledCameras_RenderByDepth()
        {
            var order = new System.Collections.Generic.List<string>();
            void Note(Camera c) => order.Add(c.name);
            var back = Make<Camera>("back");
            var front = Make<Camera>("front");
            back.depth = 1f;
            front.depth = 2f;
            Make<Camera>("off").enabled = false;
            Make<Camera>("first").depth = -1f;
            Camera.onPreRender += Note;
            Frame();
            Camera.onPreRender -= Note;
            Assert.That(order, Is.EqualTo(new[] { "first", "back", "front" }));
        }

        [Test]
        public void Render_OfDisabledCamera_RaisesTheCallbacks()
        {
            var camera = Square();
            camera.enabled = false;
            Camera seen = null;
            void Note(Camera c) => seen = c;
            Camera.onPostRender += Note;
            camera.Render();
            Camera.onPostRender -= Note;
            Assert.That(seen, Is.EqualTo(camera));
        }

        [Test]
        public void Main_IsTheEnabledCameraWithTheTag()
        {
            Make<Camera>("other");
            var camera = Make<Camera>("main");
            camera.tag = "MainCamera";
            Assert.That(Camera.main, Is.EqualTo(camera));
        }

        [TestCase(0f, 0f, true)]
        [TestCase(12f, 0f, false)]
        [TestCase(0f, -15f, false)]
        public void TestPlanesAabb_TellsWhatTheCameraSees(float x, float z, bool expected)
        {
            var planes = GeometryUtility.CalculateFrustumPlanes(Square());
            Assert.That(GeometryUtility.TestPlanesAABB(planes, new Bounds(new Vector3(x, 0f, z), Vector3.one)), Is.EqualTo(expected));
        }
    }
}
