using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>A camera's picture in the Built-in pipeline, one eye.</summary>
    public sealed class CameraDrawingTests : DrawTest
    {
        const int Middle = Size / 2;

        [Test]
        public void Box_InFrontOfACamera_HasItsColourInTheMiddleOnly()
        {
            var target = Target();
            var material = Material("Box");
            Object(Cube, material, Vector3.zero);
            Camera(target).Render();
            var expected = new Color(1, 0.5f, 0.25f).linear;
            var pixel = Pixel(target, Middle, Middle);
            Assert.That(pixel.g, Is.EqualTo(expected.g).Within(1e-5));
            Assert.That(Pixel(target, 1, 1), Is.EqualTo(new Color(0, 0, 0, 0)));
        }

        [Test]
        public void Picture_OfAnObjectAboveTheAxis_IsInTheUpperRows()
        {
            var target = Target();
            Object(Cube, Material("Box"), new Vector3(1, 1.5f, 0));
            Camera(target).Render();
            var covered = Pixels(target).Select((c, i) => (c, x: i % Size, y: i / Size)).Where(p => p.c.r > 0).ToList();
            Assert.That(covered, Is.Not.Empty);
            Assert.That(covered.All(p => p.y > Middle && p.x > Middle), Is.True, "row 0 is the bottom, column 0 the left");
        }

        [Test]
        public void DepthBuffer_HoldsReversedDepth()
        {
            var target = Target();
            var camera = Camera(target);
            Object(Cube, Material("Box"), Vector3.zero);
            camera.Render();
            var depths = Depths(target);
            Assert.That(EyeDistance(depths[Middle * Size + Middle], camera), Is.EqualTo(4.5f).Within(1e-3), "the cube's face");
            Assert.That(depths[0], Is.Zero, "nothing there: the far plane");
        }

        [Test]
        public void Depth_ThatAShaderWrites_HidesWhatIsBehindIt()
        {
            var target = Target();
            var camera = Camera(target);
            var claims = Material("Box");
            claims.SetFloat("_Distance", 2f);
            claims.SetColor("_Color", Color.green);
            Object(Cube, claims, new Vector3(0, 0, 3));
            Object(Cube, Material("Box"), Vector3.zero, 0.5f);
            camera.Render();
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.green), "drawn at 7.5, but claims to be at 2");
            Assert.That(EyeDistance(Depths(target)[Middle * Size + Middle], camera), Is.EqualTo(2f).Within(1e-3));
        }

        [TestCase(0f, 4.5f)]
        [TestCase(1f, 5.5f)]
        [TestCase(2f, 4.5f)]
        public void Cull_OfACube_LeavesFrontOrBack(float cull, float distance)
        {
            var target = Target();
            var camera = Camera(target);
            var material = Material("Box");
            material.SetFloat("_Cull", cull);
            Object(Cube, material, Vector3.zero);
            camera.Render();
            Assert.That(EyeDistance(Depths(target)[Middle * Size + Middle], camera), Is.EqualTo(distance).Within(1e-3));
        }

        [Test]
        public void Cull_OfAMirroredObject_IsTurnedRound()
        {
            var target = Target();
            var camera = Camera(target);
            Object(Cube, Material("Box"), Vector3.zero).transform.localScale = new Vector3(-1, 1, 1);
            camera.Render();
            Assert.That(EyeDistance(Depths(target)[Middle * Size + Middle], camera), Is.EqualTo(4.5f).Within(1e-3));
        }

        [Test]
        public void RenderMesh_IsDrawnInThatFrameOnly()
        {
            var target = Target();
            var camera = Camera(target);
            var parameters = new RenderParams(Material("Box")) { camera = camera };
            Draw.RenderMesh(parameters, Cube, 0, Matrix4x4.identity);
            camera.Render();
            Assert.That(Pixel(target, Middle, Middle).r, Is.EqualTo(1f));
            GraphicsSetUp.Host.Step();
            camera.Render();
            Assert.That(Pixel(target, Middle, Middle).r, Is.Zero);
        }

        [Test]
        public void RenderMesh_AskedForInOnPreCull_IsDrawnByThatCamera()
        {
            var target = Target();
            var camera = Camera(target);
            var parameters = new RenderParams(Material("Box")) { camera = camera };
            void Ask(Camera c)
            {
                if (c == camera)
                    Draw.RenderMesh(parameters, Cube, 0, Matrix4x4.identity);
            }
            UnityEngine.Camera.onPreCull += Ask;
            camera.Render();
            UnityEngine.Camera.onPreCull -= Ask;
            Assert.That(Pixel(target, Middle, Middle).r, Is.EqualTo(1f));
        }
    }
}
