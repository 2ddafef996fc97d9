using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>A pass's fixed states: blending, masks, depth.</summary>
    public sealed class StateTests : DrawTest
    {
        const int Value = 1;

        RenderTexture m_Target;
        Material m_Material;

        [SetUp]
        public void MakeBoth()
        {
            m_Target = Target(width: 2, height: 2);
            m_Material = Material("Gradient");
            Draw.SetRenderTarget(m_Target);
            GL.Clear(true, true, new Color(0.5f, 0.25f, 0f, 1f), 0.5f);
        }

        Color Drawn(Vector4 value, float depth = 0.75f)
        {
            m_Material.SetVector("_Value", value);
            m_Material.SetFloat("_Depth", depth);
            Draw.Blit(null, m_Material, Value);
            return Pixel(m_Target, 1, 1);
        }

        [TestCase(BlendMode.One, BlendMode.OneMinusSrcAlpha, 0.75f, 0.5f)]
        [TestCase(BlendMode.SrcAlpha, BlendMode.OneMinusSrcAlpha, 0.5f, 0.3125f)]
        [TestCase(BlendMode.One, BlendMode.One, 1f, 0.625f)]
        [TestCase(BlendMode.DstColor, BlendMode.Zero, 0.25f, 0.09375f)]
        public void Blend_CombinesSourceAndTarget(BlendMode source, BlendMode target, float red, float green)
        {
            m_Material.SetFloat("_SrcBlend", (float)source);
            m_Material.SetFloat("_DstBlend", (float)target);
            var pixel = Drawn(new Vector4(0.5f, 0.375f, 0f, 0.5f));
            Assert.That((pixel.r, pixel.g), Is.EqualTo((red, green)));
        }

        [TestCase(ColorWriteMask.Red, 1f, 0.25f, 1f)]
        [TestCase(ColorWriteMask.Green | ColorWriteMask.Alpha, 0.5f, 1f, 0f)]
        [TestCase((ColorWriteMask)0, 0.5f, 0.25f, 1f)]
        public void ColorMask_LetsThroughItsChannelsOnly(ColorWriteMask mask, float red, float green, float alpha)
        {
            m_Material.SetInt("_Mask", (int)mask);
            var pixel = Drawn(new Vector4(1, 1, 1, 0));
            Assert.That((pixel.r, pixel.g, pixel.a), Is.EqualTo((red, green, alpha)));
        }

        [TestCase(CompareFunction.Less, true, false, false)]
        [TestCase(CompareFunction.LessEqual, true, true, false)]
        [TestCase(CompareFunction.Equal, false, true, false)]
        [TestCase(CompareFunction.GreaterEqual, false, true, true)]
        [TestCase(CompareFunction.Greater, false, false, true)]
        [TestCase(CompareFunction.NotEqual, true, false, true)]
        [TestCase(CompareFunction.Always, true, true, true)]
        [TestCase(CompareFunction.Never, false, false, false)]
        public void ZTest_ComparesInUnitysSense(CompareFunction function, bool nearer, bool equal, bool farther)
        {
            m_Material.SetInt("_ZTest", (int)function);
            m_Material.SetInt("_ZWrite", 0);
            // The buffer holds 0.5; in it a greater value is nearer.
            var drawn = new[] { 0.75f, 0.5f, 0.25f }.Select(depth =>
            {
                GL.Clear(false, true, Color.clear);
                return Drawn(Vector4.one, depth).r == 1f;
            });
            Assert.That(drawn, Is.EqualTo(new[] { nearer, equal, farther }));
        }

        [TestCase(0, 0.5f)]
        [TestCase(1, 0.75f)]
        public void ZWrite_ChangesTheDepthOrNot(int write, float expected)
        {
            m_Material.SetInt("_ZWrite", write);
            Drawn(Vector4.one);
            Assert.That(Depths(m_Target), Has.All.EqualTo(expected));
        }
    }
}
