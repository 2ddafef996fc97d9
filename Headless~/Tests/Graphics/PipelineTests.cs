using System;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>Render pipelines: which SubShaders and passes they draw, their events, requests.</summary>
    public sealed class PipelineTests : DrawTest
    {
        const int Middle = Size / 2;

        readonly List<string> m_Events = new();

        [TearDown]
        public void BackToBuiltIn()
        {
            ProjectPipeline.Forget();
            RenderPipelineManager.Forget();
            UnityEngine.Camera.onPreCull = null;
            m_Events.Clear();
        }

        [Test]
        public void BuiltIn_DrawsTheSubShaderThatIsForAll() => Assert.That(Chosen(PipelineKind.BuiltIn), Is.EqualTo(Color.green));

        [Test]
        public void Universal_DrawsTheFirstPassOfItsSubShader() => Assert.That(Chosen(PipelineKind.Universal), Is.EqualTo(Color.red));

        [TestCase("HighDefinition")]
        [TestCase("Other")]
        public void ForeignPipelines_DrawNothingOfTheScene(string kind) =>
            Assert.That(Chosen(Enum.Parse<PipelineKind>(kind)), Is.EqualTo(new Color(0, 0, 0, 0)));

        [TestCase("BuiltIn", 2, "", null)]
        [TestCase("Universal", 0, "UniversalPipeline", "UniversalRenderPipelineAsset")]
        [TestCase("HighDefinition", 1, "HDRenderPipeline", "ForeignPipelineAsset")]
        [TestCase("Other", 2, "OtherPipeline", "ForeignPipelineAsset")]
        public void SubShader_IsThatOfThePipelinesTag(string kind, int expected, string tag, string asset)
        {
            ProjectPipeline.Choose(Enum.Parse<PipelineKind>(kind));
            var shader = Shader("Pipelines");
            Assert.That(shader.Chosen.SubShader, Is.SameAs(shader.File.SubShaders[expected]));
            Assert.That(GraphicsSettings.currentRenderPipeline == null ? "" : GraphicsSettings.currentRenderPipeline.renderPipelineShaderTag, Is.EqualTo(tag));
            Assert.That(GraphicsSettings.currentRenderPipelineAssetType?.Name, Is.EqualTo(asset));
            Assert.That(GraphicsSettings.isScriptableRenderPipelineEnabled, Is.EqualTo(asset != null));
        }

        [Test]
        public void Universal_RaisesItsEventsInOrder_AndNoneOfTheBuiltInOnes()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var camera = Camera(Target());
            Listen();
            camera.Render();
            Assert.That(m_Events, Is.EqualTo(new[] { "begin 1", "begin camera", "end camera", "end 1" }));
        }

        [Test]
        public void BuiltIn_RaisesItsOwnEventsOnly()
        {
            Listen();
            Camera(Target()).Render();
            Assert.That(m_Events, Is.EqualTo(new[] { "pre cull" }));
        }

        [Test]
        public void Frame_RendersCamerasByDepth_InOneContext()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var cameras = new[] { Camera(Target()), Camera(Target()) };
            (cameras[0].depth, cameras[1].depth) = (2, 1);
            (cameras[0].name, cameras[1].name) = ("late", "early");
            foreach (var camera in cameras)
                camera.enabled = true;
            RenderPipelineManager.beginContextRendering += (_, list) => m_Events.Add("begin " + list.Count);
            RenderPipelineManager.beginCameraRendering += (_, c) => m_Events.Add(c.name);
            GraphicsSetUp.Host.Step();
            Assert.That(m_Events, Is.EqualTo(new[] { "begin 2", "early", "late" }));
        }

        [Test]
        public void RenderMesh_AskedForAsItsCameraBegins_IsDrawn()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var target = Target();
            var parameters = new RenderParams(Material("Pipelines"));
            RenderPipelineManager.beginCameraRendering += (_, _) => Draw.RenderMesh(parameters, Cube, 0, Matrix4x4.identity);
            Camera(target).Render();
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.red));
        }

        [Test]
        public void ContextsCommands_RunBeforeTheCameraDraws()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var target = Target();
            var material = Material("Box");
            Object(Cube, material, Vector3.zero);
            var depth = UnityEngine.Shader.PropertyToID("_Distance");
            material.SetFloat(depth, 0);
            RenderPipelineManager.beginCameraRendering += (context, _) =>
            {
                var commands = new CommandBuffer();
                commands.SetRenderTarget(target);
                commands.ClearRenderTarget(false, true, Color.white);
                context.ExecuteCommandBuffer(commands);
                commands.Clear();
            };
            var camera = Camera(target);
            camera.clearFlags = CameraClearFlags.Depth;
            camera.Render();
            Assert.That(Pixel(target, 1, 1), Is.EqualTo(Color.white), "cleared by the command");
            Assert.That(Pixel(target, Middle, Middle), Is.Not.EqualTo(Color.white), "and drawn over");
        }

        [Test]
        public void HandlerThatThrows_EndsTheFrame()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var target = Target();
            Object(Cube, Material("Pipelines"), Vector3.zero);
            RenderPipelineManager.beginCameraRendering += (_, _) => throw new InvalidOperationException("handler");
            RenderPipelineManager.endContextRendering += (_, _) => m_Events.Add("end");
            LogAssert.Expect(LogType.Exception, new Regex("handler"));
            Camera(target).Render();
            Assert.That(m_Events, Is.Empty);
        }

        [Test]
        public void BuiltInShader_WithoutATag_IsDrawnByUniversal()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var target = Target();
            var material = Own(new Material(UnityEngine.Shader.Find("Unlit/Color")));
            material.color = Color.blue;
            Object(Cube, material, Vector3.zero);
            Camera(target).Render();
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.blue));
        }

        [Test]
        public void BuiltInShader_WithLight_IsMagentaInUniversal()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var target = Target();
            Object(Cube, Own(new Material(UnityEngine.Shader.Find("Standard"))), Vector3.zero);
            Camera(target).Render();
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.magenta));
        }

        [TestCase("Universal", true)]
        [TestCase("BuiltIn", false)]
        public void NumberThatNoPropertyDeclares_IsAnErrorWhereShadersAreBatched(string kind, bool isError)
        {
            ProjectPipeline.Choose(Enum.Parse<PipelineKind>(kind));
            var target = Target();
            var material = Material("Batched");
            material.SetVector("_Declared", new Vector4(0, 1, 0, 1));
            Object(Cube, material, Vector3.zero);
            Camera(target).Render();
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.green), "so far all is well");
            material.SetVector("_Undeclared", new Vector4(0, 0, 1, 0));
            if (isError)
                LogAssert.Expect(LogType.Error, new Regex("'_Undeclared' is set to the material, but the shader does not declare it"));
            Camera(target).Render();
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(new Color(0, 1, 1, 1)));
        }

        [Test]
        public void UniversalShaders_AreThereOnlyWithTheirPackage()
        {
            Assert.That(UnityEngine.Shader.Find("Universal Render Pipeline/Lit"), Is.Null);
            ProjectPipeline.Choose(PipelineKind.Universal);
            Assert.That(UnityEngine.Shader.Find("Universal Render Pipeline/Lit").isSupported, Is.True);
            Assert.That(UnityEngine.Shader.Find("Universal Render Pipeline/Unlit").isSupported, Is.True);
        }

        [Test]
        public void CreatePrimitive_HasThePipelinesMaterial_LitByTheMainLight()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var target = Target();
            var cube = Own(GameObject.CreatePrimitive(PrimitiveType.Cube));
            Assert.That(cube.GetComponent<Renderer>().sharedMaterial.shader.name, Is.EqualTo("Universal Render Pipeline/Lit"));
            var light = Own(new GameObject("light")).AddComponent<Light>();
            light.type = LightType.Directional;
            light.color = new Color(1, 0, 0);
            Camera(target).Render();
            var ambient = RenderSettings.ambientLight.linear;
            var pixel = Pixel(target, Middle, Middle);
            Assert.That(pixel.r, Is.EqualTo(1 + ambient.r).Within(1e-4), "the light shines at the face");
            Assert.That(pixel.g, Is.EqualTo(ambient.g).Within(1e-4));
        }

        [Test]
        public void Request_RendersIntoASliceAndALevel()
        {
            ProjectPipeline.Choose(PipelineKind.Universal);
            var destination = Own(new RenderTexture(new RenderTextureDescriptor(Size, Size, GraphicsFormat.R32G32B32A32_SFloat, 0)
            {
                dimension = TextureDimension.Tex2DArray,
                volumeDepth = 3,
                useMipMap = true,
                autoGenerateMips = false,
            }));
            destination.Create();
            var camera = Camera(null);
            Object(Cube, Material("Pipelines"), Vector3.zero);
            var request = new RenderPipeline.StandardRequest { destination = destination, slice = 2, mipLevel = 1 };
            Assert.That(RenderPipeline.SupportsRenderRequest(camera, request), Is.True);
            RenderPipeline.SubmitRenderRequest(camera, request);
            Assert.That(camera.targetTexture, Is.Null);
            var level = AsyncGPUReadback.Request(destination, 1);
            level.WaitForCompletion();
            Color At(int slice) => level.GetData<Color>(slice)[Size / 4 * (Size / 2) + Size / 4];
            Assert.That(At(2), Is.EqualTo(Color.red));
            Assert.That(At(1), Is.Not.EqualTo(Color.red));
        }

        [Test]
        public void Request_OfTheBuiltInPipeline_IsRefused()
        {
            LogAssert.Expect(LogType.Warning, new Regex("scriptable render pipeline"));
            RenderPipeline.SubmitRenderRequest(Camera(null), new RenderPipeline.StandardRequest { destination = Target() });
        }

        [Test]
        public void Pipeline_IsMadeWithTheFirstPicture_AndItsChangeIsAnnounced()
        {
            RenderPipelineManager.activeRenderPipelineTypeChanged += () => m_Events.Add("changed");
            RenderPipelineManager.activeRenderPipelineDisposed += () => m_Events.Add("disposed");
            ProjectPipeline.Choose(PipelineKind.Universal);
            Assert.That(RenderPipelineManager.currentPipeline, Is.Null);
            Camera(Target()).Render();
            var pipeline = RenderPipelineManager.currentPipeline;
            Assert.That(pipeline.GetType().Name, Is.EqualTo("UniversalRenderPipeline"));
            ProjectPipeline.Choose(PipelineKind.BuiltIn);
            Assert.That(pipeline.disposed, Is.True);
            Assert.That(m_Events, Is.EqualTo(new[] { "changed", "disposed", "changed" }));
        }

        Color Chosen(PipelineKind kind)
        {
            ProjectPipeline.Choose(kind);
            var target = Target();
            Object(Cube, Material("Pipelines"), Vector3.zero);
            Camera(target).Render();
            return Pixel(target, Middle, Middle);
        }

        void Listen()
        {
            RenderPipelineManager.beginContextRendering += (_, cameras) => m_Events.Add("begin " + cameras.Count);
            RenderPipelineManager.beginCameraRendering += (_, _) => m_Events.Add("begin camera");
            RenderPipelineManager.endCameraRendering += (_, _) => m_Events.Add("end camera");
            RenderPipelineManager.endContextRendering += (_, cameras) => m_Events.Add("end " + cameras.Count);
            UnityEngine.Camera.onPreCull += _ => m_Events.Add("pre cull");
        }
    }
}
