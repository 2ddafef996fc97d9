using System;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Draw = UnityEngine.Graphics;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    /// <summary>Materials: values by all their roads into shaders, defaults, copies, complaints.</summary>
    public sealed class MaterialTests : ValuesTest
    {
        [Test]
        public void Defaults_AreThoseOfTheFile()
        {
            Assert.That(Shown("NUMBERS"), Is.EqualTo(new Color(1.5f, 2, 5, 3)));
            Assert.That(Shown("DIRECTION"), Is.EqualTo(new Color(1, 2, 3, 4)));
            Assert.That(Shown("TINT").r, Is.EqualTo(Mathf.GammaToLinearSpace(0.5f)).Within(1e-5), "colours are seen, shaders compute");
            Assert.That(Shown("TINT").a, Is.EqualTo(0.5f), "alpha is no colour");
            Assert.That(Shown("PICTURE"), Is.EqualTo(new Color(0, 0, 0, 0)));
            Assert.That(Values.GetColor("_Tint"), Is.EqualTo(new Color(0.5f, 0.25f, 1, 0.5f)), "as it was written");
            Assert.That((Values.GetFloat("_Number"), Values.GetInteger("_Whole"), Values.GetInt("_Old")), Is.EqualTo((1.5f, 5, 3)));
        }

        [Test]
        public void Values_ReachTheShader()
        {
            Values.SetFloat("_Number", -2.5f);
            Values.SetInteger("_Whole", -7);
            Values.SetInt("_Old", 11);
            Values.SetFloat("_Ranged", 3);
            Assert.That(Shown("NUMBERS"), Is.EqualTo(new Color(-2.5f, 3, -7, 11)));
            Values.SetVector("_Direction", new Vector4(9, 8, 7, 6));
            Assert.That(Shown("DIRECTION"), Is.EqualTo(new Color(9, 8, 7, 6)));
            Values.SetColor("_Direction", new Color(0.5f, 0, 0, 1));
            Assert.That(Shown("DIRECTION").r, Is.EqualTo(Mathf.GammaToLinearSpace(0.5f)).Within(1e-5), "SetColor converts, whatever the property is");
            Values.color = Color.green;
            Assert.That(Shown("TINT"), Is.EqualTo(Color.green), "the property with [MainColor]");
            Values.SetMatrix("_Turn", Matrix4x4.TRS(new Vector3(1, 2, 3), Quaternion.Euler(0, 0, 90), Vector3.one));
            Assert.That(((Vector4)Shown("MATRIX") - new Vector4(1, 3, 3, 1)).magnitude, Is.LessThan(1e-5f), "M * v");
        }

        [Test]
        public void Arrays_ReachTheShader()
        {
            Values.SetVectorArray("_Rows", new[] { Vector4.zero, Vector4.one, new Vector4(5, 6, 0, 0) });
            Values.SetFloatArray("_Steps", new[] { 1f, 2f, 3f, 4f });
            Assert.That(Shown("ARRAYS"), Is.EqualTo(new Color(5, 6, 2, 4)));
            Assert.That(Values.GetFloatArray("_Steps"), Is.EqualTo(new[] { 1f, 2f, 3f, 4f }));
        }

        [Test]
        public void Textures_ReachTheShader_WithScaleAndOffset()
        {
            var picture = Own(new Texture2D(2, 1, TextureFormat.RGBAFloat, false) { filterMode = FilterMode.Point, wrapMode = TextureWrapMode.Clamp });
            picture.SetPixels(new[] { Color.red, Color.blue });
            picture.Apply();
            Values.mainTexture = picture;
            Assert.That(Shown("PICTURE"), Is.EqualTo(Color.red), "the pixel at the lower left");
            Values.mainTextureScale = Vector2.zero;
            Values.mainTextureOffset = new Vector2(0.75f, 0.5f);
            Assert.That(Shown("PICTURE"), Is.EqualTo(Color.blue));
            Assert.That(Values.GetTextureOffset("_Picture"), Is.EqualTo(new Vector2(0.75f, 0.5f)));
            Values.mainTexture = null;
            Assert.That(Shown("PICTURE"), Is.EqualTo(new Color(0, 0, 0, 0)), "the default again");
        }

        [Test]
        public void Textures_OfOtherDimensions_ReachTheShader()
        {
            var volume = Own(new Texture3D(1, 1, 2, TextureFormat.RGBAFloat, false) { filterMode = FilterMode.Point });
            volume.SetPixelData(new[] { 1f, 0, 0, 1, 0.25f, 0.5f, 0, 0 }, 0);
            volume.Apply();
            var layers = Own(new Texture2DArray(1, 1, 2, TextureFormat.RGBAFloat, false));
            layers.SetPixelData(new[] { 0f, 0, 0, 0 }, 0, 0);
            layers.SetPixelData(new[] { 0.75f, 1, 0, 0 }, 0, 1);
            layers.Apply();
            Values.SetTexture("_Volume", volume);
            Values.SetTexture("_Layers", layers);
            Assert.That(Shown("VOLUME"), Is.EqualTo(new Color(0.25f, 0.5f, 0.75f, 1)));
        }

        [Test]
        public void Textures_ThatAreNotSet_HaveTheirDefaults()
        {
            LogAssert.Expect(LogType.Warning, new Regex("texture '_Missing' is neither a property of the shader nor set"));
            var shown = Shown("DEFAULTS");
            Assert.That(shown.r, Is.EqualTo(1));
            Assert.That(shown.g, Is.EqualTo(0.216f).Within(0.005f), "half as bright for people");
            Assert.That(shown.b, Is.EqualTo(1).Within(0.01f), "a normal that points outwards");
            Assert.That(shown.a, Is.EqualTo(0.216f).Within(0.005f));
            Assert.That(Shown("VOLUME").r, Is.EqualTo(0.216f).Within(0.005f), "volumes and arrays have grey ones too");
        }

        [Test]
        public void DestroyedTexture_CountsAsUnset()
        {
            var picture = new Texture2D(1, 1);
            Values.SetTexture("_Picture", picture);
            UnityEngine.Object.DestroyImmediate(picture);
            Assert.That(Shown("PICTURE"), Is.EqualTo(new Color(0, 0, 0, 0)));
            Assert.That(Values.GetTexture("_Picture") == null, Is.True);
        }

        [Test]
        public void WrongDimension_IsAnErrorOnce_AndReadsTheDefault()
        {
            Values.SetTexture("_Picture", Own(new Texture3D(1, 1, 1, TextureFormat.RGBA32, false)));
            LogAssert.Expect(LogType.Error, new Regex(@"'_Picture' has mismatching texture dimension \(expected 2, got 3\)"));
            Assert.That(Shown("PICTURE").a, Is.EqualTo(0.5f).Within(0.01f));
            Shown("PICTURE");
        }

        [Test]
        public void WrongNumbers_AreAnErrorOnce()
        {
            Values.SetTexture("_Codes", Own(new Texture2D(2, 1, TextureFormat.RGBA32, false)));
            LogAssert.Expect(LogType.Error, new Regex("'_Codes' is of UInt, but"));
            Assert.That(Shown("WHOLE TEXTURE").r, Is.Zero);
            Shown("WHOLE TEXTURE");
        }

        [Test]
        public void WholeTexture_IsReadAsItIs()
        {
            var codes = Own(new Texture2D(2, 1, GraphicsFormat.R16_UInt, TextureCreationFlags.None));
            codes.SetPixelData(new ushort[] { 1, 40000 }, 0);
            codes.Apply();
            Values.SetTexture("_Codes", codes);
            Assert.That(Shown("WHOLE TEXTURE").r, Is.EqualTo(40000));
        }

        [Test]
        public void Buffers_ReachTheShader()
        {
            Values.SetBuffer("_List", Buffer(new[] { Vector4.zero, new Vector4(1, 2, 3, 4) }));
            Values.SetConstantBuffer("Block", Buffer(new[] { Vector4.zero, new Vector4(10, 20, 30, 40) }, GraphicsBuffer.Target.Constant), 0, 32);
            Assert.That(Shown("BUFFER"), Is.EqualTo(new Color(11, 22, 33, 44)));
        }

        [Test]
        public void BufferThatIsNotSet_SkipsTheDraw()
        {
            LogAssert.Expect(LogType.Error, new Regex("'_List' to be bound, but none provided. Skipping draw calls"));
            var before = Drawer.DrawCount;
            Shown("BUFFER");
            Shown("BUFFER");
            Assert.That(Drawer.DrawCount, Is.EqualTo(before));
        }

        [Test]
        public void BufferOfAnotherStride_SkipsTheDraw()
        {
            Values.SetBuffer("_List", Buffer(new[] { 1f, 2f }));
            LogAssert.Expect(LogType.Error, new Regex("stride of 4 bytes; the shader reads 16 bytes"));
            Shown("BUFFER");
        }

        [Test]
        public void Globals_CountForWhatIsNoProperty_AndMaterialsComeFirst()
        {
            UnityEngine.Shader.SetGlobalVector("_Loose", new Vector4(1, 2, 3, 4));
            UnityEngine.Shader.SetGlobalVector("_Direction", new Vector4(9, 9, 9, 9));
            Assert.That(Shown("LOOSE"), Is.EqualTo(new Color(1, 2, 3, 4)));
            Assert.That(Shown("DIRECTION"), Is.EqualTo(new Color(1, 2, 3, 4)), "the property's default comes first");
            Values.SetVector("_Loose", Vector4.one);
            Assert.That(Shown("LOOSE"), Is.EqualTo(Color.white));
            UnityEngine.Shader.SetGlobalVector("_Direction", Vector4.zero);
        }

        [Test]
        public void UnknownProperty_IsWarnedOfOnce_AndAnErrorWhenRead()
        {
            LogAssert.Expect(LogType.Warning, new Regex("no property '_Nomber'"));
            Values.SetFloat("_Nomber", 1);
            Values.SetFloat("_Nomber", 2);
            LogAssert.Expect(LogType.Error, new Regex("doesn't have a float or range property '_Namber'|doesn't have a .*'_Namber'"));
            Assert.That(Values.GetFloat("_Namber"), Is.Zero);
            Assert.That((Values.HasProperty("_Number"), Values.HasProperty("_Namber")), Is.EqualTo((true, false)));
            Assert.That((Values.HasFloat("_Number"), Values.HasFloat("_Tint"), Values.HasColor("_Tint"), Values.HasTexture("_Picture")),
                Is.EqualTo((true, false, true, true)));
        }

        [Test]
        public void Copy_HasTheValues_AndIsItsOwn()
        {
            Values.SetFloat("_Number", 4);
            Values.EnableKeyword("IS_RED");
            Values.renderQueue = 2222;
            var copy = Own(new Material(Values));
            Values.SetFloat("_Number", 5);
            Values.DisableKeyword("IS_RED");
            Assert.That((copy.GetFloat("_Number"), copy.IsKeywordEnabled("IS_RED"), copy.renderQueue), Is.EqualTo((4f, true, 2222)));
            var clone = Own(UnityEngine.Object.Instantiate(copy));
            Assert.That((clone.GetFloat("_Number"), clone.shader), Is.EqualTo((4f, copy.shader)));
            Values.CopyPropertiesFromMaterial(copy);
            Assert.That(Values.GetFloat("_Number"), Is.EqualTo(4));
        }

        [Test]
        public void Shader_CanBeReplaced_AndSharedValuesStay()
        {
            var material = Material("Box");
            material.SetColor("_Color", Color.cyan);
            material.shader = Shader("Gradient");
            Assert.That(material.GetColor("_Color"), Is.EqualTo(Color.cyan));
            Assert.That(material.GetFloat("_Depth"), Is.EqualTo(0.5f), "and new ones have their defaults");
        }

        [Test]
        public void NoShader_IsRefused()
        {
            Assert.That(() => new Material((Shader)null), Throws.TypeOf<ArgumentNullException>());
            Assert.That(() => new Material((Material)null), Throws.TypeOf<ArgumentNullException>());
        }

        [Test]
        public void Block_ComesBeforeTheMaterial_AndIsCopied()
        {
            var target = Target();
            var renderer = Object(Quad, Values, Vector3.zero, 20f).GetComponent<Renderer>();
            for (var i = 0; i < Values.passCount; i++)
                Values.SetShaderPassEnabled(Values.GetPassName(i), false);
            var block = new MaterialPropertyBlock();
            block.SetVector("_Direction", new Vector4(7, 7, 7, 7));
            renderer.SetPropertyBlock(block);
            block.SetVector("_Direction", Vector4.zero);
            var read = new MaterialPropertyBlock();
            renderer.GetPropertyBlock(read);
            Assert.That(read.GetVector("_Direction"), Is.EqualTo(new Vector4(7, 7, 7, 7)));
            var commands = new CommandBuffer();
            commands.SetRenderTarget(target);
            commands.DrawMesh(Quad, Matrix4x4.Scale(Vector3.one * 100), Values, 0, Values.FindPass("DIRECTION"), read);
            Draw.ExecuteCommandBuffer(commands);
            Assert.That(Pixel(target, 3, 3), Is.EqualTo(new Color(7, 7, 7, 7)));
            renderer.SetPropertyBlock(null);
            Assert.That(renderer.HasPropertyBlock(), Is.False);
        }

        [Test]
        public void Block_RefusesNullTextures() =>
            Assert.That(() => new MaterialPropertyBlock().SetTexture("_Picture", null), Throws.TypeOf<ArgumentNullException>());
    }
}
