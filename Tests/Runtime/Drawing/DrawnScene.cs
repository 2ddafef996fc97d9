using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace AnatomyCarve.Tests.Drawing
{
    /// <summary>Cameras' own pictures of volumes, read back.</summary>
    abstract class DrawnScene : PlayModeScene
    {
        /// <summary>A code of an 8-bit picture: what two ways of drawing the same may differ by.</summary>
        protected const float OneCode = 1f / 255f;

        readonly List<RenderTexture> targets = new List<RenderTexture>();

        [TearDown]
        public void ReleaseTargets()
        {
            foreach (RenderTexture target in targets)
            {
                target.Release();
                UnityEngine.Object.DestroyImmediate(target);
            }
            targets.Clear();
        }

        /// <summary>A camera with a target of its own, of linear floats and a depth buffer, which clears to a colour and renders only when asked.</summary>
        protected Camera MakeDrawingCamera(Vector3 position, Vector3 up, int width = 96, int height = 96)
        {
            Camera camera = MakeCamera(position, up);
            var target = new RenderTexture(width, height, 32, GraphicsFormat.R16G16B16A16_SFloat) { name = "Target" };
            Assert.That(target.Create(), Is.True);
            targets.Add(target);
            camera.targetTexture = target;
            camera.ResetAspect();
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = new Color(0.25f, 0.3f, 0.5f, 1f);
            camera.allowHDR = true;
            camera.allowMSAA = false;
            return camera;
        }

        /// <summary>What a camera draws, linear, bottom row first.</summary>
        protected static Color[] Draw(Camera camera)
        {
            camera.Render();
            return Read(camera.targetTexture);
        }

        protected static Color[] Read(RenderTexture target)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(target, 0);
            request.WaitForCompletion();
            Assert.That(request.hasError, Is.False, "the target cannot be read back");
            return ToColors(Array.ConvertAll(request.GetData<ushort>().ToArray(), Mathf.HalfToFloat));
        }

        /// <summary>A kernel's picture over a camera's background, as the camera would have blended it.</summary>
        protected static Color[] Over(PictureData picture, Camera camera)
        {
            Color behind = camera.backgroundColor.linear;
            return Array.ConvertAll(picture.Color, c =>
                new Color(c.r + (1f - c.a) * behind.r, c.g + (1f - c.a) * behind.g, c.b + (1f - c.a) * behind.b, c.a + (1f - c.a) * behind.a));
        }

        /// <summary>Every pixel within one code of another picture's, but for a share of them.</summary>
        protected static void AssertAlike(Color[] actual, Color[] expected, double allowedShare, string what)
        {
            int different = 0;
            float largest = 0f;
            for (int p = 0; p < expected.Length; p++)
            {
                float difference = Difference(actual[p], expected[p]);
                largest = Mathf.Max(largest, difference);
                different += difference > OneCode ? 1 : 0;
            }
            TestContext.WriteLine(FormattableString.Invariant($"{what}: largest difference {largest * 255f:0.###} codes; {different} of {expected.Length} pixels above one"));
            Assert.That(different, Is.LessThanOrEqualTo(allowedShare * expected.Length), what);
        }

        protected static float Difference(Color a, Color b) =>
            Mathf.Max(Mathf.Max(Mathf.Abs(a.r - b.r), Mathf.Abs(a.g - b.g)), Mathf.Max(Mathf.Abs(a.b - b.b), Mathf.Abs(a.a - b.a)));

        /// <summary>Pixels that are not the camera's background.</summary>
        protected static int CountDrawn(Color[] pixels, Camera camera)
        {
            Color behind = camera.backgroundColor.linear;
            return Array.FindAll(pixels, p => Mathf.Abs(p.r - behind.r) + Mathf.Abs(p.g - behind.g) + Mathf.Abs(p.b - behind.b) > 0.01f).Length;
        }

        static Color[] ToColors(float[] channels)
        {
            var colors = new Color[channels.Length / 4];
            for (int p = 0; p < colors.Length; p++)
                colors[p] = new Color(channels[4 * p], channels[4 * p + 1], channels[4 * p + 2], channels[4 * p + 3]);
            return colors;
        }
    }
}
