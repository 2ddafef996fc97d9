using System;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>Command buffers that draw.</summary>
    public sealed class CommandDrawingTests : DrawTest
    {
        const int Middle = Size / 2;

        static readonly Matrix4x4 s_View = Matrix4x4.TRS(new Vector3(0, 0, -5), Quaternion.identity, new Vector3(1, 1, -1)).inverse;
        static readonly Matrix4x4 s_Projection = Matrix4x4.Perspective(60, 1, 0.5f, 50);

        [Test]
        public void DrawMesh_HasTheMatricesThatWereSet()
        {
            var target = Target();
            var commands = Into(target);
            commands.DrawMesh(Cube, Matrix4x4.Translate(new Vector3(0, 1.5f, 0)), Red());
            Draw.ExecuteCommandBuffer(commands);
            var covered = Enumerable.Range(0, Size * Size).Where(i => Pixels(target)[i].r > 0).ToList();
            Assert.That(covered, Is.Not.Empty);
            Assert.That(covered.All(i => i / Size > Middle), Is.True, "above the middle");
            Assert.That(Depths(target)[covered[covered.Count / 2]], Is.Positive);
        }

        [Test]
        public void Commands_RunEachTimeTheyAreExecuted_WithWhatTheMaterialHasThen()
        {
            var target = Target();
            var material = Red();
            var commands = Into(target);
            commands.DrawMesh(Cube, Matrix4x4.identity, material);
            Draw.ExecuteCommandBuffer(commands);
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.red));
            material.SetColor("_Color", Color.blue);
            Draw.ExecuteCommandBuffer(commands);
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.blue));
            commands.Clear();
            material.SetColor("_Color", Color.green);
            Draw.ExecuteCommandBuffer(commands);
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.blue));
        }

        [Test]
        public void DrawRenderer_TakesItsPlaceMeshAndBlock()
        {
            var target = Target();
            var material = Red();
            var renderer = Object(Cube, material, new Vector3(-1, 0, 0)).GetComponent<Renderer>();
            var block = new MaterialPropertyBlock();
            block.SetColor("_Color", Color.green);
            renderer.SetPropertyBlock(block);
            var commands = Into(target);
            commands.DrawRenderer(renderer, material);
            Draw.ExecuteCommandBuffer(commands);
            var colors = Pixels(target);
            Assert.That(colors.Where((c, i) => c.a > 0 && i % Size >= Middle), Is.Empty);
            Assert.That(colors.Where(c => c.a > 0), Is.Not.Empty.And.All.EqualTo(Color.green));
        }

        [Test]
        public void DrawProcedural_MakesVerticesOfTheirNumbers()
        {
            var target = Target();
            var material = Material("Procedural");
            material.SetBuffer("_Corners", Buffer(new[] { new Vector4(-1, -1, 0.5f, 1), new Vector4(-1, 3, 0.5f, 1), new Vector4(3, -1, 0.5f, 1) }));
            var commands = Into(target);
            commands.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, 3, 2);
            Draw.ExecuteCommandBuffer(commands);
            Assert.That(Pixels(target), Has.All.EqualTo(new Color(1, 0.5f, 0, 1)), "the second instance over the first");
        }

        [Test]
        public void TemporaryTextures_AreKnownByTheirNames()
        {
            var target = Target();
            var name = UnityEngine.Shader.PropertyToID("_Between");
            var commands = new CommandBuffer { name = "two steps" };
            commands.GetTemporaryRT(name, new RenderTextureDescriptor(Size, Size, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.D32_SFloat));
            commands.SetRenderTarget(name);
            commands.ClearRenderTarget(true, true, Color.clear);
            commands.SetViewProjectionMatrices(s_View, s_Projection);
            commands.DrawMesh(Cube, Matrix4x4.identity, Red());
            commands.Blit(name, target);
            commands.ReleaseTemporaryRT(name);
            Draw.ExecuteCommandBuffer(commands);
            Assert.That(Pixel(target, Middle, Middle), Is.EqualTo(Color.red));
            Assert.That(Pixel(target, 0, 0).a, Is.Zero);
        }

        [Test]
        public void ViewportAndScissor_LimitWhatIsDrawn()
        {
            var target = Target();
            var commands = Into(target);
            commands.SetViewport(new Rect(16, 0, 16, 16));
            commands.EnableScissorRect(new Rect(16, 0, 8, 32));
            commands.DrawMesh(Quad, Matrix4x4.Scale(Vector3.one * 100), Red());
            commands.DisableScissorRect();
            Draw.ExecuteCommandBuffer(commands);
            var covered = Enumerable.Range(0, Size * Size).Where(i => Pixels(target)[i].r > 0).ToList();
            Assert.That(covered, Has.Count.EqualTo(8 * 16));
            Assert.That(covered.All(i => i % Size is >= 16 and < 24 && i / Size < 16), Is.True);
        }

        [Test]
        public void SeveralTargets_AreBoundTogether()
        {
            var (first, second) = (Target(), Target());
            var commands = new CommandBuffer();
            commands.SetRenderTarget(new RenderTargetIdentifier[] { first, second }, first);
            commands.ClearRenderTarget(true, true, Color.blue);
            Draw.ExecuteCommandBuffer(commands);
            Assert.That((Pixel(first, 0, 0), Pixel(second, 0, 0)), Is.EqualTo((Color.blue, Color.blue)));
        }

        [Test]
        public void InvertCulling_ShowsTheOtherFaces()
        {
            var target = Target();
            var material = Red();
            var commands = Into(target);
            commands.SetInvertCulling(true);
            commands.DrawMesh(Quad, Matrix4x4.Scale(Vector3.one * 4), material);
            commands.SetInvertCulling(false);
            Draw.ExecuteCommandBuffer(commands);
            Assert.That(Pixel(target, Middle, Middle).a, Is.Zero, "the quad faces the camera");
        }

        [Test]
        public void GlobalKeywordsAndColours_AreSetInTurn()
        {
            var target = Target();
            var material = Material("Values");
            var commands = new CommandBuffer();
            commands.EnableShaderKeyword("IS_GREEN");
            commands.Blit(Texture2D.whiteTexture, target, material, material.FindPass("KEYWORDS"));
            commands.DisableShaderKeyword("IS_GREEN");
            Draw.ExecuteCommandBuffer(commands);
            Assert.That(Pixel(target, 0, 0).g, Is.EqualTo(1));
            Assert.That(UnityEngine.Shader.IsKeywordEnabled("IS_GREEN"), Is.False);
        }

        [Test]
        public void NullMeshesAndMaterials_AreRefusedAtOnce()
        {
            var commands = new CommandBuffer();
            Assert.That(() => commands.DrawMesh(null, Matrix4x4.identity, Red()), Throws.TypeOf<ArgumentNullException>());
            Assert.That(() => commands.DrawMesh(Cube, Matrix4x4.identity, null), Throws.TypeOf<ArgumentNullException>());
            Assert.That(() => commands.DrawRenderer(null, Red()), Throws.TypeOf<ArgumentNullException>());
        }

        [Test]
        public void PassThatIsNotThere_IsAnError()
        {
            var commands = Into(Target());
            commands.DrawMesh(Cube, Matrix4x4.identity, Red(), 0, 7);
            LogAssert.Expect(LogType.Error, new Regex("7"));
            Draw.ExecuteCommandBuffer(commands);
        }

        Material Red()
        {
            var material = Material("Box");
            material.SetColor("_Color", Color.red);
            return material;
        }

        static CommandBuffer Into(RenderTexture target)
        {
            var commands = new CommandBuffer();
            commands.SetRenderTarget(target);
            commands.ClearRenderTarget(true, true, Color.clear);
            commands.SetViewProjectionMatrices(s_View, s_Projection);
            return commands;
        }
    }
}
