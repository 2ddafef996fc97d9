using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>What a camera draws, in which order, into which part of which target.</summary>
    public sealed class CameraOrderTests : FlatTest
    {
        [TearDown]
        public void ForgetCallbacks() => UnityEngine.Camera.onPreCull = UnityEngine.Camera.onPreRender = UnityEngine.Camera.onPostRender = null;

        [Test]
        public void OpaqueObjects_AreDrawnFrontToBack()
        {
            // Without a depth test the last one stays.
            Object(Cube, Flat(Color.red, 2000), new Vector3(0, 0, 2));
            Object(Cube, Flat(Color.green, 2000), Vector3.zero);
            Assert.That(Seen(), Is.EqualTo(Color.red));
        }

        [Test]
        public void TransparentObjects_AreDrawnBackToFront()
        {
            Object(Cube, Flat(Color.green, 3000), Vector3.zero);
            Object(Cube, Flat(Color.red, 3000), new Vector3(0, 0, 2));
            Assert.That(Seen(), Is.EqualTo(Color.green));
        }

        [Test]
        public void Queues_ComeBeforeDistance()
        {
            Object(Cube, Flat(Color.green, 3001), new Vector3(0, 0, 2));
            Object(Cube, Flat(Color.red, 3000), Vector3.zero);
            Object(Cube, Flat(Color.blue, 2600), new Vector3(0, 0, -1));
            Assert.That(Seen(), Is.EqualTo(Color.green));
        }

        [Test]
        public void SortingOrder_ComesBeforeQueues()
        {
            Object(Cube, Flat(Color.green, 3001), Vector3.zero);
            Object(Cube, Flat(Color.red, 3000), Vector3.zero).GetComponent<Renderer>().sortingOrder = 1;
            Assert.That(Seen(), Is.EqualTo(Color.red));
        }

        [Test]
        public void Layers_AreChosenByTheMask()
        {
            Object(Cube, Flat(Color.red, 2000), Vector3.zero).layer = 8;
            var target = Target();
            var camera = Camera(target);
            camera.cullingMask = ~(1 << 8);
            camera.Render();
            Assert.That(Pixel(target, Middle, Middle).a, Is.Zero);
            camera.cullingMask = 1 << 8;
            camera.Render();
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.red));
        }

        [Test]
        public void Culling_LeavesOutWhatIsOutside()
        {
            var positions = new[] { new Vector3(0, 0, -7), new Vector3(0, 0, 60), new Vector3(40, 0, 0), new Vector3(0, -40, 0), Vector3.zero };
            var renderers = positions.Select(p => Object(Cube, Flat(Color.red, 2000), p).GetComponent<Renderer>()).ToList();
            var camera = Camera(Target());
            var before = Drawer.DrawCount;
            camera.Render();
            Assert.That(Drawer.DrawCount - before, Is.EqualTo(1));
            Assert.That(renderers.Select(r => r.isVisible), Is.EqualTo(new[] { false, false, false, false, true }));
            Assert.That(Drawer.TriangleCount, Is.GreaterThanOrEqualTo(12));
        }

        [Test]
        public void Bounds_DecideWhatIsCulled_AlsoThoseSetByHand()
        {
            var renderer = Object(Cube, Flat(Color.red, 2000), Vector3.zero).GetComponent<Renderer>();
            var camera = Camera(Target());
            renderer.bounds = new Bounds(new Vector3(100, 0, 0), Vector3.one);
            var before = Drawer.DrawCount;
            camera.Render();
            Assert.That(Drawer.DrawCount, Is.EqualTo(before));
            renderer.ResetBounds();
            renderer.localBounds = new Bounds(Vector3.zero, new Vector3(8, 2, 2));
            Assert.That(renderer.bounds.size, Is.EqualTo(new Vector3(8, 2, 2)));
            camera.Render();
            Assert.That(Drawer.DrawCount, Is.EqualTo(before + 1));
        }

        [TestCase("disabled")]
        [TestCase("inactive")]
        [TestCase("forced off")]
        [TestCase("shadows only")]
        [TestCase("no mesh")]
        public void Renderer_ThatIsOff_IsNotDrawn(string how)
        {
            var o = Object(Cube, Flat(Color.red, 2000), Vector3.zero);
            var renderer = o.GetComponent<Renderer>();
            switch (how)
            {
                case "disabled": renderer.enabled = false; break;
                case "inactive": o.SetActive(false); break;
                case "forced off": renderer.forceRenderingOff = true; break;
                case "shadows only": renderer.shadowCastingMode = ShadowCastingMode.ShadowsOnly; break;
                default: o.GetComponent<MeshFilter>().sharedMesh = null; break;
            }
            Assert.That(Seen().a, Is.Zero);
        }

        [Test]
        public void NoMaterial_IsMagenta()
        {
            Object(Cube, null, Vector3.zero);
            Assert.That(Seen(), Is.EqualTo(Color.magenta));
        }

        [Test]
        public void ClearFlags_SayWhatIsCleared()
        {
            var target = Target();
            Draw.SetRenderTarget(target);
            GL.Clear(true, true, Color.red);
            var camera = Camera(target);
            camera.backgroundColor = Color.blue;
            camera.clearFlags = CameraClearFlags.Nothing;
            camera.Render();
            Assert.That(Pixel(target, 1, 1), Is.EqualTo(Color.red));
            Object(Cube, Flat(Color.green, 2000), Vector3.zero);
            camera.clearFlags = CameraClearFlags.Depth;
            camera.Render();
            Assert.That((Pixel(target, 1, 1), Depths(target)[0]), Is.EqualTo((Color.red, 0f)));
            camera.clearFlags = CameraClearFlags.Skybox;
            camera.Render();
            Assert.That(Pixel(target, 1, 1), Is.EqualTo(Color.blue), "there is no skybox");
        }

        [Test]
        public void Background_IsSeenAsItIsWritten()
        {
            var target = Target();
            var camera = Camera(target);
            camera.backgroundColor = new Color(0.5f, 0.25f, 1, 0.5f);
            camera.Render();
            Assert.That(Pixel(target, 0, 0).r, Is.EqualTo(Mathf.GammaToLinearSpace(0.5f)).Within(1e-5));
            Assert.That(Pixel(target, 0, 0).a, Is.EqualTo(0.5f));
        }

        [Test]
        public void Rect_IsThePartThatIsDrawnAndCleared()
        {
            var target = Target();
            Draw.SetRenderTarget(target);
            GL.Clear(true, true, Color.red);
            var camera = Camera(target);
            camera.rect = new Rect(0.5f, 0.5f, 0.5f, 0.25f);
            camera.backgroundColor = Color.blue;
            Object(Cube, Flat(Color.green, 2000), Vector3.zero);
            camera.Render();
            Assert.That(camera.aspect, Is.EqualTo(2));
            Assert.That(Pixel(target, 15, 17), Is.EqualTo(Color.red));
            Assert.That(Pixel(target, 17, 25), Is.EqualTo(Color.red));
            Assert.That(Pixel(target, 16, 16), Is.EqualTo(Color.blue));
            Assert.That(Pixel(target, 24, 20), Is.EqualTo(Color.green), "the middle of the part");
        }

        [Test]
        public void Screen_ShowsCamerasInOrderOfDepth_TheRightWayUp()
        {
            (Screen.width, Screen.height) = (32, 16);
            try
            {
                var (back, front) = (Camera(null), Camera(null));
                (back.depth, front.depth) = (-1, 5);
                back.backgroundColor = Color.blue;
                front.clearFlags = CameraClearFlags.Depth;
                front.cullingMask = 1 << 6;
                Object(Cube, Flat(Color.red, 2000), new Vector3(1.5f, 1.5f, 0));
                Object(Cube, Flat(Color.green, 2000), new Vector3(1.5f, 1.5f, 2)).layer = 6;
                (front.enabled, back.enabled) = (true, true);
                GraphicsSetUp.Host.Step();
                var bytes = GraphicsSetUp.Host.ReadScreen();
                Color32 At(int x, int y) => new(bytes[4 * (y * 32 + x)], bytes[4 * (y * 32 + x) + 1], bytes[4 * (y * 32 + x) + 2], bytes[4 * (y * 32 + x) + 3]);
                Assert.That(bytes, Has.Length.EqualTo(4 * 32 * 16));
                Assert.That(At(0, 0), Is.EqualTo((Color32)Color.blue));
                var green = Enumerable.Range(0, 512).Where(i => At(i % 32, i / 32).g == 255).ToList();
                Assert.That(green, Is.Not.Empty);
                Assert.That(green.All(i => i / 32 > 8 && i % 32 > 16), Is.True, "right of and above the middle");
            }
            finally
            {
                (Screen.width, Screen.height) = (1280, 720);
            }
        }

        [Test]
        public void Callbacks_ComeInOrder_WithTheCameraAsTheCurrentOne()
        {
            var events = new List<string>();
            var camera = Camera(Target());
            void Note(string name, Camera c) => events.Add($"{name} {c == camera} {UnityEngine.Camera.current == camera}");
            UnityEngine.Camera.onPreCull += c => Note("cull", c);
            UnityEngine.Camera.onPreRender += c => Note("render", c);
            UnityEngine.Camera.onPostRender += c => Note("post", c);
            camera.Render();
            Assert.That(events, Is.EqualTo(new[] { "cull True True", "render True True", "post True True" }));
            Assert.That(UnityEngine.Camera.current == null, Is.True);
        }

        [Test]
        public void WhatIsMovedInOnPreCull_IsDrawnThere()
        {
            var o = Object(Cube, Flat(Color.red, 2000), new Vector3(100, 0, 0));
            UnityEngine.Camera.onPreCull += _ => o.transform.position = Vector3.zero;
            Assert.That(Seen(), Is.EqualTo(Color.red));
        }

        [Test]
        public void Picture_DoesNotChangeTheActiveTarget()
        {
            var target = Target();
            RenderTexture.active = target;
            Camera(Target()).Render();
            Assert.That(RenderTexture.active, Is.EqualTo(target));
        }

        [Test]
        public void Light_AndAmbient_ReachTheLitShader()
        {
            var cube = Own(GameObject.CreatePrimitive(PrimitiveType.Cube));
            Assert.That(cube.GetComponent<Renderer>().sharedMaterial.name, Is.EqualTo("Default-Material"));
            var ambient = RenderSettings.ambientLight.linear;
            Assert.That(Seen().g, Is.EqualTo(ambient.g).Within(1e-4));
            var light = Own(new GameObject("light")).AddComponent<Light>();
            light.type = LightType.Directional;
            light.intensity = 0.5f;
            light.transform.rotation = Quaternion.Euler(60, 0, 0);
            Assert.That(Seen().g, Is.EqualTo(ambient.g + 0.5f * 0.5f).Within(1e-4), "half of its light at 60 degrees");
            light.enabled = false;
            Assert.That(Seen().g, Is.EqualTo(ambient.g).Within(1e-4));
        }
    }
}
