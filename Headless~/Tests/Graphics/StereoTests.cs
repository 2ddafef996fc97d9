using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using EyeOf = UnityEngine.Camera.MonoOrStereoscopicEye;
using Side = UnityEngine.Camera.StereoscopicEye;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>Both eyes of a headset: drawn in turn, in one draw of two instances, in one draw of two views; in both pipelines.</summary>
    [TestFixtureSource(nameof(Modes))]
    public sealed class StereoTests : DrawTest
    {
        const int Eye = 32;
        const int Middle = Eye / 2;

        readonly StereoMode m_Mode;
        readonly PipelineKind m_Pipeline;

        public StereoTests(string mode, string pipeline)
        {
            m_Mode = System.Enum.Parse<StereoMode>(mode);
            m_Pipeline = System.Enum.Parse<PipelineKind>(pipeline);
        }

        bool IsInTurn => m_Mode == StereoMode.MultiPass;

        static IEnumerable<object[]> Modes() =>
            from mode in new[] { "MultiPass", "SinglePassInstanced", "Multiview" }
            from pipeline in new[] { "BuiltIn", "Universal" }
            select new object[] { mode, pipeline };

        [SetUp]
        public void PutOnHeadset()
        {
            ProjectPipeline.Choose(m_Pipeline);
            (Headset.Mode, Headset.EyeWidth, Headset.EyeHeight, Headset.Separation) = (m_Mode, Eye, Eye, 0.5f);
            Headset.Left = new FrustumPlanes { left = -0.7f, right = 0.5f, bottom = -0.6f, top = 0.6f };
            Headset.Right = new FrustumPlanes { left = -0.5f, right = 0.7f, bottom = -0.6f, top = 0.6f };
        }

        [TearDown]
        public void TakeOffHeadset()
        {
            Headset.Forget();
            ProjectPipeline.Forget();
            UnityEngine.Rendering.RenderPipelineManager.Forget();
            UnityEngine.Camera.onPreCull = UnityEngine.Camera.onPreRender = UnityEngine.Camera.onPostRender = null;
        }

        [Test]
        public void Eyes_AreToldApart_InBothStages()
        {
            var camera = Camera(null);
            Object(Cube, Material("Eyes"), Vector3.zero);
            camera.Render();
            for (var eye = 0; eye < 2; eye++)
            {
                var pixel = At(eye, Column(eye), Middle);
                Assert.That(pixel.r, Is.EqualTo(ToldPlace(eye == 0 ? 0.25f : 0.75f)).Within(0.01f), "the eye's position");
                Assert.That(pixel.g, Is.EqualTo(eye).Within(0.01f), "the eye's index");
                Assert.That(pixel.b, Is.EqualTo(1f).Within(0.01f), "the fragment stage means the same eye");
            }
        }

        [Test]
        public void Picture_IsWhatACameraWithTheEyesMatricesSees()
        {
            var camera = Camera(null);
            Object(Cube, Material("Eyes"), new Vector3(0.3f, 0.8f, 0));
            Object(Cube, Material("Eyes"), new Vector3(-0.9f, -0.4f, 1), 0.7f);
            camera.Render();
            for (var eye = 0; eye < 2; eye++)
            {
                var target = Target(width: Eye, height: Eye);
                var alone = Camera(target);
                alone.worldToCameraMatrix = camera.GetStereoViewMatrix((Side)eye);
                alone.projectionMatrix = camera.GetStereoProjectionMatrix((Side)eye);
                alone.Render();
                var expected = Pixels(target).Select(c => c.b > 0).ToArray();
                var actual = Shown(eye).Select(c => c.b > 0).ToArray();
                Assert.That(actual, Is.EqualTo(expected), "covered pixels of eye " + eye);
                Assert.That(expected, Has.Some.True.And.Some.False);
            }
        }

        [Test]
        public void Draws_AreOnePerObject_UnlessEyesTakeTurns()
        {
            var camera = Camera(null);
            for (var i = 0; i < 3; i++)
                Object(Cube, Material("Eyes"), new Vector3(i * 0.2f, 0, i));
            camera.Render();
            var (draws, triangles) = (Drawer.DrawCount, Drawer.TriangleCount);
            camera.Render();
            Assert.That(Drawer.DrawCount - draws, Is.EqualTo(IsInTurn ? 6 : 3));
            Assert.That(Drawer.TriangleCount - triangles, Is.EqualTo(m_Mode == StereoMode.Multiview ? 36 : 72), "views are no instances");
        }

        [Test]
        public void Events_ComeOncePerPicture()
        {
            var camera = Camera(null);
            var events = new List<string>();
            UnityEngine.Camera.onPreCull += c => events.Add("cull " + c.stereoActiveEye);
            UnityEngine.Camera.onPreRender += c => events.Add("render " + c.stereoActiveEye);
            UnityEngine.Rendering.RenderPipelineManager.beginCameraRendering += (_, c) => events.Add("begin " + c.stereoActiveEye);
            camera.Render();
            var expected = (m_Pipeline, IsInTurn) switch
            {
                (PipelineKind.BuiltIn, true) => new[] { "cull Left", "render Left", "render Right" },
                (PipelineKind.BuiltIn, false) => new[] { "cull Left", "render Left" },
                (_, true) => new[] { "begin Left", "begin Right" },
                _ => new[] { "begin Left" },
            };
            Assert.That(events, Is.EqualTo(expected));
        }

        [Test]
        public void Culling_KeepsWhatEitherEyeSees()
        {
            var camera = Camera(null);
            // Right of what the left eye sees at that distance, and the other way round.
            Object(Cube, Material("Eyes"), new Vector3(3.4f, 0, 0), 0.4f);
            Object(Cube, Material("Eyes"), new Vector3(-3.4f, 0, 0), 0.4f);
            Object(Cube, Material("Eyes"), new Vector3(9f, 0, 0), 0.4f);
            var before = Drawer.DrawCount;
            camera.Render();
            Assert.That(Drawer.DrawCount - before, Is.EqualTo(IsInTurn ? 4 : 2));
            Assert.That(Covered(0), Is.GreaterThan(0), "the left eye sees what is left");
            Assert.That(Covered(1), Is.GreaterThan(0));
            int Covered(int eye) => Shown(eye).Count(c => c.b > 0);
        }

        [Test]
        public void DepthTexture_HasEachEyesOwnDepth()
        {
            var camera = Camera(null);
            camera.depthTextureMode = DepthTextureMode.Depth;
            var opaque = Own(new Material(UnityEngine.Shader.Find(m_Pipeline == PipelineKind.BuiltIn ? "Unlit/Color" : "Universal Render Pipeline/Unlit")));
            // Off the axis: at the same pixel one eye sees it, the other one does not.
            Object(Cube, opaque, new Vector3(0, 0.9f, 2));
            var material = Material("SceneDepth");
            material.SetFloat("_Unit", 50);
            Object(Quad, material, new Vector3(0, 0, -3), 4f);
            camera.Render();
            for (var eye = 0; eye < 2; eye++)
            {
                var pixels = Shown(eye);
                for (var x = 1; x < Eye; x += 2)
                {
                    // The ray of the pixel through the plane of the box's face at z = 1.5.
                    var ray = camera.ViewportPointToRay(new Vector3((x + 0.5f) / Eye, 20.5f / Eye, 1), (EyeOf)eye);
                    var hit = ray.GetPoint((1.5f - ray.origin.z) / ray.direction.z);
                    if (Mathf.Abs(Mathf.Abs(hit.x) - 0.5f) < 0.2f)
                        continue;
                    var inside = Mathf.Abs(hit.x) < 0.5f && hit.y > 0.4f && hit.y < 1.4f;
                    Assert.That(50 * pixels[20 * Eye + x].r, Is.EqualTo(inside ? 6.5f : 50f).Within(0.4f), $"eye {eye}, column {x}, y {hit.y}");
                }
            }
        }

        [Test]
        public void BuiltInShaders_DrawBothEyes([Values("lit", "unlit", "error")] string kind)
        {
            var builtIn = m_Pipeline == PipelineKind.BuiltIn;
            var name = kind == "error" ? "Hidden/InternalErrorShader" : (builtIn, kind) switch
            {
                (true, "lit") => "Standard",
                (true, _) => "Unlit/Color",
                (_, "lit") => "Universal Render Pipeline/Lit",
                _ => "Universal Render Pipeline/Unlit",
            };
            Object(Cube, Own(new Material(UnityEngine.Shader.Find(name))), Vector3.zero);
            Camera(null).Render();
            for (var eye = 0; eye < 2; eye++)
                Assert.That(At(eye, Column(eye), Middle).r, Is.GreaterThan(0.02f), "eye " + eye);
        }

        [Test]
        public void CameraWithATarget_IsMono_AndSoIsOneForNoEye()
        {
            var camera = Camera(Target());
            Assert.That(camera.stereoEnabled, Is.False);
            Assert.That(camera.stereoActiveEye, Is.EqualTo(EyeOf.Mono));
            camera.targetTexture = null;
            Assert.That(camera.stereoEnabled, Is.True);
            Assert.That((camera.pixelWidth, camera.pixelHeight), Is.EqualTo((Eye, Eye)));
            camera.stereoTargetEye = StereoTargetEyeMask.None;
            Assert.That(camera.stereoEnabled, Is.False);
            Assert.That(camera.pixelWidth, Is.EqualTo(Screen.width));
        }

        [Test]
        public void CameraForOneEye_DrawsThatOneOnly()
        {
            var camera = Camera(null);
            camera.backgroundColor = Color.white;
            camera.Render();
            camera.stereoTargetEye = StereoTargetEyeMask.Right;
            camera.backgroundColor = Color.black;
            Object(Cube, Material("Eyes"), Vector3.zero);
            camera.Render();
            Assert.That(At(0, Middle, Middle), Is.EqualTo(Color.white));
            Assert.That(At(1, Column(1), Middle).r, Is.EqualTo(ToldPlace(0.75f, true)).Within(0.01f));
        }

        [Test]
        public void Matrices_SetByHand_Stick_UntilReset()
        {
            var camera = Camera(null);
            var own = camera.GetStereoViewMatrix(Side.Right);
            Assert.That(own.inverse.GetColumn(3).x, Is.EqualTo(0.25f).Within(1e-6f), "half the separation");
            camera.SetStereoViewMatrix(Side.Right, Matrix4x4.Translate(new Vector3(-0.4f, 0, 0)) * camera.worldToCameraMatrix);
            Object(Cube, Material("Eyes"), Vector3.zero);
            camera.Render();
            Assert.That(At(1, Column(1), Middle).r, Is.EqualTo(ToldPlace(0.9f)).Within(0.01f));
            camera.ResetStereoViewMatrices();
            Assert.That(camera.GetStereoViewMatrix(Side.Right), Is.EqualTo(own));
            camera.Render();
            Assert.That(At(0, 1, 1).b, Is.Not.EqualTo(1).Within(0.2f), "the cube does not reach the corner");
            Matrix4x4 longLens = Matrix4x4.Perspective(2, 1, 0.5f, 50) * Matrix4x4.Translate(new Vector3(-0.25f, 0, 0));
            camera.SetStereoProjectionMatrix(Side.Left, longLens);
            camera.Render();
            Assert.That(At(0, 1, 1).b, Is.EqualTo(1).Within(0.01f), "seen through a long lens it does");
            Assert.That(camera.GetStereoProjectionMatrix(Side.Left), Is.EqualTo(longLens));
            camera.ResetStereoProjectionMatrices();
            Assert.That(camera.GetStereoProjectionMatrix(Side.Left).m02, Is.LessThan(0), "off-centre again");
        }

        [Test]
        public void Points_AreInTheEyesPicture()
        {
            var camera = Camera(null);
            var point = new Vector3(0.4f, 0.3f, 1);
            foreach (var eye in new[] { EyeOf.Left, EyeOf.Right })
            {
                var seen = camera.WorldToViewportPoint(point, eye);
                Assert.That((camera.ViewportToWorldPoint(seen, eye) - point).magnitude, Is.LessThan(1e-4f));
                var ray = camera.ViewportPointToRay(seen, eye);
                Assert.That(Vector3.Cross(ray.direction, point - ray.origin).magnitude, Is.LessThan(1e-4f));
            }
            Assert.That(camera.WorldToViewportPoint(point, EyeOf.Left).x,
                Is.GreaterThan(camera.WorldToViewportPoint(point, EyeOf.Right).x));
        }

        /// <summary>What the fixture shows as the eye's place; URP says of eyes in turn where the camera is.</summary>
        float ToldPlace(float eye, bool ofOneEye = false) => (IsInTurn || ofOneEye) && m_Pipeline == PipelineKind.Universal ? 0.5f : eye;

        /// <summary>Where an eye sees the origin: eyes look outwards.</summary>
        static int Column(int eye) => eye == 0 ? Middle + 4 : Middle - 4;

        static Color At(int eye, int x, int y) => Shown(eye)[y * Eye + x];

        /// <summary>An eye's picture as shaders wrote it, row by row from the bottom.</summary>
        static Color[] Shown(int eye)
        {
            var bytes = Headset.Read(eye);
            return Enumerable.Range(0, Eye * Eye).Select(i => ((Color)new Color32(bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2], bytes[4 * i + 3])).linear)
                .ToArray();
        }
    }
}
