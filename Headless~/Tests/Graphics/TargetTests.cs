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
    /// <summary>What drawing goes into: formats, slices, mip levels, samples, several targets, clears, parts.</summary>
    public sealed class TargetTests : DrawTest
    {
        const int Value = 1, Texture = 2, TwoTargets = 3;

        static RenderTexture Created(RenderTexture texture)
        {
            Assert.That(texture.Create(), Is.True);
            return texture;
        }

        [Test]
        public void Clear_OfColourAndDepth_FillsBoth()
        {
            var target = Target();
            RenderTexture.active = target;
            GL.Clear(true, true, new Color(0.25f, 0.5f, 0.75f, 1));
            Assert.That(Pixels(target), Has.All.EqualTo(new Color(0.25f, 0.5f, 0.75f, 1)));
            Assert.That(Depths(target), Has.All.Zero, "far is 0 in the buffer");
            GL.Clear(true, false, Color.red, 0.25f);
            Assert.That(Depths(target), Has.All.EqualTo(0.75f));
            Assert.That(Pixel(target, 0, 0).r, Is.EqualTo(0.25f), "the colour was left alone");
        }

        [Test]
        public void Clear_WithinAViewport_LeavesTheRest()
        {
            var target = Target();
            RenderTexture.active = target;
            GL.Clear(true, true, Color.black);
            GL.Viewport(new Rect(0, 0, 8, 4));
            GL.Clear(false, true, Color.red);
            var red = Enumerable.Range(0, Size * Size).Where(i => Pixels(target)[i].r == 1f).ToList();
            Assert.That(red, Is.EqualTo(Enumerable.Range(0, 4).SelectMany(y => Enumerable.Range(y * Size, 8))), "8 columns from the left, 4 rows from below");
        }

        [Test]
        public void Blit_OfATexture_CopiesIt()
        {
            var source = Own(new Texture2D(2, 2, TextureFormat.RGBAFloat, false) { filterMode = FilterMode.Point });
            var colors = new[] { Color.red, Color.green, Color.blue, Color.white };
            source.SetPixels(colors);
            source.Apply();
            var target = Target(width: 2, height: 2);
            Draw.Blit(source, target);
            Assert.That(Pixels(target), Is.EqualTo(colors));
            Assert.That(RenderTexture.active, Is.EqualTo(target), "Unity leaves it so");
        }

        [Test]
        public void Blit_WithAMaterial_DrawsItsPass()
        {
            var material = Material("Gradient");
            material.SetVector("_Value", new Vector4(1, 2, 3, 4));
            var target = Target();
            Draw.SetRenderTarget(target);
            GL.Clear(true, false, Color.clear);
            Draw.Blit(null, target, material, Value);
            Assert.That(Pixels(target), Has.All.EqualTo(new Color(1, 2, 3, 4)));
            Assert.That(Depths(target), Has.All.EqualTo(0.5f));
        }

        [Test]
        public void Blit_IntoTheScreen_IsTheRightWayUp()
        {
            var material = Material("Gradient");
            Draw.Blit(null, null, material, 0);
            var bytes = GraphicsSetUp.Host.ReadScreen();
            var (w, h) = (Screen.width, Screen.height);
            Assert.That(bytes, Has.Length.EqualTo(w * h * 4));
            Assert.That(bytes[1], Is.LessThan(20), "v is 0 below");
            Assert.That(bytes[(h - 1) * w * 4 + 1], Is.GreaterThan(240), "and 1 above");
            Assert.That(bytes[(w - 1) * 4], Is.GreaterThan(240), "u is 1 at the right");
        }

        [Test]
        public void Screen_ReadByReadPixels_IsAsReadByTheHost()
        {
            Draw.Blit(null, null, Material("Gradient"), 0);
            RenderTexture.active = null;
            var picture = Own(new Texture2D(4, 6, TextureFormat.RGBA32, false));
            picture.ReadPixels(new Rect(10, 20, 4, 6), 0, 0);
            var bytes = GraphicsSetUp.Host.ReadScreen();
            var expected = Enumerable.Range(0, 6).SelectMany(y => bytes.Skip(((20 + y) * Screen.width + 10) * 4).Take(16));
            Assert.That(picture.GetRawTextureData(), Is.EqualTo(expected));
        }

        [Test]
        public void SrgbTarget_StoresLinearColoursAsSrgb()
        {
            var target = Target(GraphicsFormat.R8G8B8A8_SRGB);
            var material = Material("Gradient");
            material.SetInt("_ZTest", (int)CompareFunction.Always);
            material.SetVector("_Value", new Vector4(0.214f, 0, 1, 1));
            Draw.Blit(null, target, material, Value);
            Assert.That(Read<Color32>(target)[0], Is.EqualTo(new Color32(127, 0, 255, 255)).Using<Color32>((a, b) =>
                Mathf.Abs(a.r - b.r) <= 1 && a.g == b.g && a.b == b.b && a.a == b.a));
        }

        [Test]
        public void SrgbWrite_SwitchedOff_StoresColoursAsTheyAre()
        {
            var target = Target(GraphicsFormat.R8G8B8A8_SRGB);
            var material = Material("Gradient");
            material.SetInt("_ZTest", (int)CompareFunction.Always);
            material.SetVector("_Value", new Vector4(0.2f, 0.4f, 1, 1));
            RenderTexture.active = target;
            GL.sRGBWrite = false;
            Draw.Blit(null, material, Value);
            Assert.That(Read<Color32>(target)[0], Is.EqualTo(new Color32(51, 102, 255, 255)));
            RenderTexture.active = target;
            Assert.That(GL.sRGBWrite, Is.True, "a target that is set switches it on");
        }

        [Test]
        public void Slice_OfAnArray_IsDrawnAlone()
        {
            var target = Created(Own(new RenderTexture(new RenderTextureDescriptor(4, 4, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.D32_SFloat)
            {
                dimension = TextureDimension.Tex2DArray,
                volumeDepth = 3,
            })));
            for (var slice = 0; slice < 3; slice++)
            {
                Draw.SetRenderTarget(target, 0, CubemapFace.Unknown, slice);
                GL.Clear(true, true, new Color(slice, 0, 0, 0));
            }
            var values = Read<Vector4>(target);
            Assert.That(Enumerable.Range(0, 3).Select(s => values[s * 16 + 5].x), Is.EqualTo(new[] { 0f, 1f, 2f }));
            Draw.SetRenderTarget(target, 0, CubemapFace.Unknown, -1);
            GL.Clear(true, true, new Color(9, 0, 0, 0));
            Assert.That(Read<Vector4>(target).Select(v => v.x), Has.All.EqualTo(9f));
        }

        [Test]
        public void MipLevel_IsDrawnAlone()
        {
            var target = Created(Own(new RenderTexture(new RenderTextureDescriptor(4, 4, GraphicsFormat.R32G32B32A32_SFloat, 0) { useMipMap = true })));
            Draw.SetRenderTarget(target, 0);
            GL.Clear(false, true, Color.red);
            Draw.SetRenderTarget(target, 1);
            GL.Clear(false, true, Color.blue);
            var request = AsyncGPUReadback.Request(target, 1);
            request.WaitForCompletion();
            Assert.That(request.GetData<Color>().ToArray(), Is.EqualTo(Enumerable.Repeat(Color.blue, 4)));
            Assert.That(Pixel(target, 0, 0), Is.EqualTo(Color.red));
        }

        [Test]
        public void TwoTargets_AreWrittenAtOnce()
        {
            var (first, second) = (Target(), Target());
            var material = Material("Gradient");
            material.SetVector("_Value", new Vector4(1, 2, 3, 4));
            material.mainTexture = Own(new Texture2D(3, 5, TextureFormat.RGBA32, false));
            Draw.SetRenderTarget(new[] { first.colorBuffer, second.colorBuffer }, first.depthBuffer);
            Draw.Blit(material.mainTexture, material, TwoTargets);
            Assert.That(Pixel(first, 3, 3), Is.EqualTo(new Color(1, 2, 3, 4)));
            Assert.That(Pixel(second, 3, 3), Is.EqualTo(new Color(3, 5, Size, Size)), "texel size and screen size");
        }

        [Test]
        public void ColourOfOne_AndDepthOfAnother_CanBeDrawnTogether()
        {
            var (color, depth) = (Target(), Target());
            RenderTexture.active = depth;
            GL.Clear(true, true, Color.clear);
            Draw.SetRenderTarget(color.colorBuffer, depth.depthBuffer);
            var material = Material("Gradient");
            material.SetVector("_Value", Vector4.one);
            Draw.Blit(null, material, Value);
            Assert.That(Depths(depth), Has.All.EqualTo(0.5f));
            Assert.That(Pixel(color, 0, 0), Is.EqualTo(Color.white));
            Assert.That(Pixel(depth, 0, 0), Is.EqualTo(Color.clear));
        }

        [Test]
        public void DepthTexture_CanBeReadByShaders()
        {
            var depth = Created(Own(new RenderTexture(Size, Size, GraphicsFormat.None, GraphicsFormat.D32_SFloat)));
            Assert.That((depth.format, depth.depth), Is.EqualTo((RenderTextureFormat.Depth, 32)));
            Draw.SetRenderTarget(depth);
            GL.Clear(true, false, Color.clear, 0.25f);
            var material = Material("Gradient");
            var target = Target();
            Draw.Blit(depth, target, material, Texture);
            Assert.That(Pixel(target, 7, 9).r, Is.EqualTo(0.75f));
        }

        [Test]
        public void DepthElement_OfATexture_CanBeReadByShaders()
        {
            var source = Target();
            Draw.SetRenderTarget(source);
            GL.Clear(true, true, Color.red, 0.5f);
            var material = Material("Gradient");
            material.SetTexture("_MainTex", source, RenderTextureSubElement.Depth);
            var target = Target();
            Draw.Blit(null, target, material, Texture);
            Assert.That(Pixel(target, 7, 9).r, Is.EqualTo(0.5f));
        }

        [TestCase(16, GraphicsFormat.D16_UNorm)]
        [TestCase(24, GraphicsFormat.D24_UNorm_S8_UInt)]
        [TestCase(32, GraphicsFormat.D32_SFloat_S8_UInt)]
        public void DepthBits_ChooseAFormatOfTheDevice(int bits, GraphicsFormat expected)
        {
            var target = Created(Own(new RenderTexture(4, 4, bits, RenderTextureFormat.ARGBFloat)));
            Assert.That((target.depthStencilFormat, target.depth), Is.EqualTo((expected, bits)));
            Draw.SetRenderTarget(target);
            GL.Clear(true, true, Color.clear);
            var material = Material("Gradient");
            material.SetVector("_Value", Vector4.one);
            material.SetFloat("_Depth", 0.5f);
            Draw.Blit(null, material, Value);
            material.SetFloat("_Depth", 0.25f);
            material.SetVector("_Value", Vector4.zero);
            Draw.Blit(null, material, Value);
            Assert.That(Pixel(target, 1, 1).r, Is.EqualTo(1f), "farther than what is there");
        }

        [Test]
        public void Samples_AreResolvedToTheMeanOfTheirColours()
        {
            var descriptor = new RenderTextureDescriptor(Size, Size, GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormat.D32_SFloat) { msaaSamples = 4 };
            Assert.That(SystemInfo.GetRenderTextureSupportedMSAASampleCount(descriptor), Is.EqualTo(4));
            var target = Created(Own(new RenderTexture(descriptor)));
            var camera = Camera(target);
            var box = Object(Cube, Material("Box"), Vector3.zero);
            box.transform.rotation = Quaternion.Euler(0, 0, 30);
            camera.Render();
            var levels = Pixels(target).Select(p => p.r).Distinct().OrderBy(r => r).ToArray();
            Assert.That(levels, Has.Length.GreaterThan(2).And.SubsetOf(new[] { 0f, 0.25f, 0.5f, 0.75f, 1f }));
        }

        [Test]
        public void Samples_OfANumberThatTheDeviceLacks_AreRefused()
        {
            var descriptor = new RenderTextureDescriptor(4, 4, GraphicsFormat.R8G8B8A8_UNorm, 0) { msaaSamples = 8 };
            Assume.That(SystemInfo.GetRenderTextureSupportedMSAASampleCount(descriptor), Is.LessThan(8));
            var target = Own(new RenderTexture(descriptor));
            LogAssert.Expect(LogType.Error, new Regex("8 samples per texel are not supported here, 4 are"));
            Assert.That(target.Create(), Is.False);
        }

        [Test]
        public void Release_OfTheActiveTarget_MakesTheScreenActive()
        {
            var target = Target();
            RenderTexture.active = target;
            target.Release();
            Assert.That(RenderTexture.active == null, Is.True);
        }

        [Test]
        public void Texture_ThatIsDrawnInto_CannotBeReadAtOnce()
        {
            var target = Target();
            LogAssert.Expect(LogType.Error, new Regex("'test target' is read while it is drawn into"));
            Draw.Blit(target, target, Material("Gradient"), Texture);
        }
    }
}
