using System;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>A material of the shader Values, of which tests draw a pass.</summary>
    public abstract class ValuesTest : DrawTest
    {
        protected Material Values { get; private set; }

        [SetUp]
        public void MakeMaterial() => Values = Material("Values");

        [TearDown]
        public void ForgetGlobals()
        {
            UnityEngine.Shader.SetGlobalVector("_Loose", Vector4.zero);
            UnityEngine.Shader.DisableKeyword("IS_GREEN");
        }

        /// <summary>What a pass shows.</summary>
        protected Color Shown(string pass)
        {
            var target = Target(width: 4, height: 4);
            Draw.SetRenderTarget(target);
            GL.Clear(true, true, Color.clear);
            var index = Values.FindPass(pass);
            Assert.That(index, Is.Not.Negative);
            Draw.Blit(null, target, Values, index);
            return Pixel(target, 0, 0);
        }
    }

    /// <summary>Keywords, tags, passes and properties of materials and shaders.</summary>
    public sealed class MaterialShaderTests : ValuesTest
    {
        [Test]
        public void Keywords_ChooseTheVariant_LocalAndGlobal()
        {
            Assert.That(Shown("KEYWORDS"), Is.EqualTo(new Color(0, 0, 1, 0)), "without one the first of a set counts");
            Values.EnableKeyword("IS_RED");
            Values.EnableKeyword("LARGE");
            UnityEngine.Shader.EnableKeyword("IS_GREEN");
            Assert.That(Shown("KEYWORDS"), Is.EqualTo(new Color(1, 1, 2, 0)));
            Assert.That(Values.shaderKeywords, Is.EquivalentTo(new[] { "IS_RED", "LARGE" }));
            Values.DisableKeyword("IS_RED");
            UnityEngine.Shader.DisableKeyword("IS_GREEN");
            Values.EnableKeyword("IS_GREEN");
            Assert.That(Shown("KEYWORDS"), Is.EqualTo(new Color(0, 1, 2, 0)), "a material can turn on a global one for itself");
            var keyword = new LocalKeyword(Values.shader, "IS_RED");
            Values.SetKeyword(keyword, true);
            Assert.That(Values.IsKeywordEnabled(keyword), Is.True);
        }

        [Test]
        public void LocalKeyword_IsNotTurnedOnGlobally()
        {
            UnityEngine.Shader.EnableKeyword("IS_RED");
            var shown = Shown("KEYWORDS");
            UnityEngine.Shader.DisableKeyword("IS_RED");
            Assert.That(shown.r, Is.Zero);
        }

        [Test]
        public void KeywordThatTheShaderLacks_IsWarnedOf()
        {
            LogAssert.Expect(LogType.Warning, new Regex("declares no keyword 'IS_RAD'"));
            Values.EnableKeyword("IS_RAD");
        }

        [Test]
        public void Tags_QueueAndPasses_AreTheShaders_UntilTheyAreSet()
        {
            Assert.That(Values.renderQueue, Is.EqualTo(3005));
            Assert.That(Values.rawRenderQueue, Is.EqualTo(-1));
            Values.renderQueue = 1000;
            Assert.That(Values.renderQueue, Is.EqualTo(1000));
            Values.renderQueue = -1;
            Assert.That(Values.renderQueue, Is.EqualTo(3005));
            Assert.That(Values.GetTag("RenderType", false), Is.EqualTo("Custom"));
            Values.SetOverrideTag("RenderType", "Mine");
            Assert.That(Values.GetTag("RenderType", false), Is.EqualTo("Mine"));
            Assert.That(Values.GetTag("Nothing", false, "else"), Is.EqualTo("else"));
            Assert.That((Values.passCount, Values.FindPass("volume"), Values.GetPassName(1)), Is.EqualTo((12, 6, "NUMBERS")));
        }

        [Test]
        public void Shader_TellsItsProperties()
        {
            var shader = Values.shader;
            Assert.That(shader.name, Is.EqualTo("Tests/Values"));
            Assert.That(shader.GetPropertyCount(), Is.EqualTo(12));
            var ranged = shader.FindPropertyIndex("_Ranged");
            Assert.That((shader.GetPropertyType(ranged), shader.GetPropertyRangeLimits(ranged), shader.GetPropertyDescription(ranged)),
                Is.EqualTo((ShaderPropertyType.Range, new Vector2(-1, 3), "Ranged")));
            var volume = shader.FindPropertyIndex("_Volume");
            Assert.That(shader.GetPropertyTextureDimension(volume), Is.EqualTo(TextureDimension.Tex3D));
            Assert.That(shader.GetPropertyType(volume), Is.EqualTo(ShaderPropertyType.Texture));
            Assert.That(shader.GetPropertyTextureDefaultName(shader.FindPropertyIndex("_Picture")), Is.EqualTo("black"));
            Assert.That(shader.FindPropertyIndex("_Nothing"), Is.EqualTo(-1));
            Assert.That(() => shader.GetPropertyName(12), Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(shader.isSupported, Is.True);
        }
    }
}
