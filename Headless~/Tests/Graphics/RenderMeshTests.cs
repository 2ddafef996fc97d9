using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>Things of one colour, without depth test, so that the one that is drawn last stays.</summary>
    public abstract class FlatTest : DrawTest
    {
        protected const int Middle = Size / 2;

        /// <summary>A colour without depth test.</summary>
        protected Material Flat(Color color, int queue)
        {
            var material = Own(new Material(UnityEngine.Shader.Find("Sprites/Default")));
            material.color = color;
            material.renderQueue = queue;
            return material;
        }

        /// <summary>The middle of a new camera's picture.</summary>
        protected Color Seen()
        {
            var target = Target();
            Camera(target).Render();
            // Interpolated whites may be a hair below 1.
            var c = Pixel(target, Middle, Middle);
            return new Color(Rounded(c.r), Rounded(c.g), Rounded(c.b), Rounded(c.a));

            static float Rounded(float value) => Mathf.Round(value * 1e5f) / 1e5f;
        }
    }

    /// <summary>Meshes that are asked for, for one frame.</summary>
    public sealed class RenderMeshTests : FlatTest
    {
        [Test]
        public void RenderMesh_IsForItsCameraAndLayer()
        {
            var (one, other) = (Target(), Target());
            var (a, b) = (Camera(one), Camera(other));
            b.cullingMask = ~(1 << 5);
            var material = Flat(Color.red, 2000);
            Draw.RenderMesh(new RenderParams(material) { camera = a }, Cube, 0, Matrix4x4.Translate(new Vector3(-1, 0, 0)));
            Draw.RenderMesh(new RenderParams(material) { layer = 5 }, Cube, 0, Matrix4x4.Translate(new Vector3(1, 0, 0)));
            a.Render();
            b.Render();
            Assert.That(Columns(one), Is.EqualTo("LR"), "all that is for it, or for all");
            Assert.That(Columns(other), Is.EqualTo(""), "neither another camera's, nor a layer that it does not see");
            GraphicsSetUp.Host.Step();
        }

        [Test]
        public void RenderMesh_WithBoundsOfItsOwn_IsCulledByThem()
        {
            var material = Flat(Color.red, 2000);
            Draw.RenderMesh(new RenderParams(material) { worldBounds = new Bounds(new Vector3(500, 0, 0), Vector3.one) }, Cube, 0, Matrix4x4.identity);
            Assert.That(Seen().a, Is.Zero);
            Draw.RenderMesh(new RenderParams(material), Cube, 0, Matrix4x4.identity);
            Assert.That(Seen(), Is.EqualTo(Color.red));
            GraphicsSetUp.Host.Step();
        }

        [Test]
        public void RenderMesh_HasItsBlock()
        {
            var block = new MaterialPropertyBlock();
            block.SetColor("_Color", Color.blue);
            Draw.RenderMesh(new RenderParams(Flat(Color.red, 2000)) { matProps = block }, Cube, 0, Matrix4x4.identity);
            block.SetColor("_Color", Color.green);
            Assert.That(Seen(), Is.EqualTo(Color.blue), "copied when it was asked for");
            GraphicsSetUp.Host.Step();
        }

        /// <summary>L and R: whether something is in the left and the right half.</summary>
        static string Columns(RenderTexture target)
        {
            var pixels = Pixels(target);
            var left = pixels.Where((c, i) => i % Size < Middle && c.a > 0).Any();
            var right = pixels.Where((c, i) => i % Size >= Middle && c.a > 0).Any();
            return (left ? "L" : "") + (right ? "R" : "");
        }
    }
}
