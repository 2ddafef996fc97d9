using System;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Graphics
{
    public sealed class TextureTests : GpuTest
    {
        [Test]
        public void PixelData_SetAndApplied_ReachesTheDevice()
        {
            var texture = Own(new Texture2D(3, 2, TextureFormat.R16, false));
            var data = texture.GetPixelData<ushort>(0);
            for (var i = 0; i < data.Length; i++)
                data[i] = (ushort)(i * 1000);
            texture.Apply(false);
            Assert.That(Read<ushort>(texture), Is.EqualTo(new ushort[] { 0, 1000, 2000, 3000, 4000, 5000 }));
            Assert.That(texture.GetPixel(1, 1).r, Is.EqualTo(4000 / 65535f));
        }

        [Test]
        public void Texture_MadeUnreadable_RefusesAccessAndEndsItsViews()
        {
            var texture = Own(new Texture3D(2, 2, 2, TextureFormat.R8, false) { name = "closed" });
            var view = texture.GetPixelData<byte>(0);
            texture.Apply(false, true);
            Assert.That((texture.isReadable, view.IsCreated), Is.EqualTo((false, false)));
            var error = Assert.Throws<UnityException>(() => texture.SetPixelData(new byte[8], 0));
            Assert.That(error.Message, Does.StartWith("Texture 'closed' is not readable"));
            Assert.Throws<UnityException>(() => texture.Apply());
            Assert.Throws<UnityException>(() => texture.GetPixelData<byte>(0));
        }

        [Test]
        public void PixelData_MissingOrTooShort_IsRefused()
        {
            var texture = Own(new Texture3D(2, 2, 2, TextureFormat.R16, false));
            Assert.Throws<UnityException>(() => texture.SetPixelData(Array.Empty<ushort>(), 0));
            Assert.Throws<UnityException>(() => texture.SetPixelData(new ushort[7], 0));
            Assert.Throws<UnityException>(() => texture.SetPixelData(new ushort[8], 1));
            texture.SetPixelData(new byte[17], 0, 1);
        }

        [Test]
        public void NativeData_WithAnyElementType_IsCopiedAsBytes()
        {
            var texture = Own(new Texture2D(2, 2, TextureFormat.R8, false));
            using var data = new NativeArray<uint>(new[] { 0x04030201u }, Allocator.Persistent);
            texture.SetPixelData(data, 0);
            Assert.That(texture.GetRawTextureData(), Is.EqualTo(new byte[] { 1, 2, 3, 4 }));
        }

        [Test]
        public void Mipmaps_Updated_AreMeansOfFour()
        {
            var texture = Own(new Texture2D(2, 2, TextureFormat.R8, true, true));
            Assert.That(texture.mipmapCount, Is.EqualTo(2));
            texture.SetPixelData(new byte[] { 10, 20, 30, 40 }, 0);
            texture.Apply();
            Assert.That(texture.GetPixelData<byte>(1)[0], Is.EqualTo(25));
        }

        [Test]
        public void Texture3D_WithoutMipChainFlag_HasOneLevel() =>
            Assert.That(Own(new Texture3D(4, 4, 4, GraphicsFormat.R8_UNorm, TextureCreationFlags.None)).mipmapCount, Is.EqualTo(1));

        [TestCase(true)]
        [TestCase(false)]
        public void LargeVolume_UploadedInPieces_ArrivesWhole(bool native)
        {
            const int size = 257; // 34 MB: more than two staging pieces, with rows that are no multiple of anything
            var data = new ushort[size * size * size];
            for (var i = 0; i < data.Length; i++)
                data[i] = (ushort)(i * 2654435761L >> 16);
            var texture = Own(new Texture3D(size, size, size, GraphicsFormat.R16_UNorm, TextureCreationFlags.None));
            if (native)
                data.AsSpan().CopyTo(texture.GetPixelData<ushort>(0).AsSpan());
            else
                texture.SetPixelData(data, 0);
            texture.Apply(false, true);
            foreach (var z in new[] { 0, 126, 127, 128, 256 })
            {
                var request = AsyncGPUReadback.Request(texture, 0, 0, size, 0, size, z, 1);
                request.WaitForCompletion();
                Assert.That(request.GetData<ushort>().AsReadOnlySpan().SequenceEqual(data.AsSpan(z * size * size, size * size)), $"slice {z}");
            }
        }

        [Test]
        public void TooLargeTexture_IsAFakeNullWithAnError()
        {
            LogAssert.Expect(LogType.Error, new Regex("outside 1 to 2048"));
            Assert.That(new Texture3D(2049, 1, 1, TextureFormat.R8, false) == null);
        }

        [Test]
        public void CopyTexture_OfOneSlice_LeavesTheOthers()
        {
            var source = Own(new Texture2D(2, 1, TextureFormat.R8, false, true));
            source.SetPixelData(new byte[] { 7, 8 }, 0);
            source.Apply(false);
            var target = Own(new Texture3D(2, 1, 3, TextureFormat.R8, false));
            target.SetPixelData(new byte[] { 0, 1, 2, 3, 4, 5 }, 0);
            target.Apply(false);
            UnityEngine.Graphics.CopyTexture(source, 0, target, 1);
            Assert.That(Read<byte>(target), Is.EqualTo(new byte[] { 0, 1, 7, 8, 4, 5 }));
        }

        [Test]
        public void CopyTexture_BetweenFormats_IsRefused()
        {
            LogAssert.Expect(LogType.Error, new Regex("are not compatible"));
            UnityEngine.Graphics.CopyTexture(Own(new Texture2D(1, 1, TextureFormat.R8, false, true)), Own(new Texture2D(1, 1, TextureFormat.R16, false)));
        }

        [Test]
        public void RenderTexture_Recreated_ForgetsItsContents()
        {
            var texture = Volume(2, 2, 2, GraphicsFormat.R32_SFloat);
            var bytes = Gpu.Context.Bytes;
            texture.Release();
            Assert.That(Gpu.Context.Bytes, Is.LessThan(bytes));
            Assert.That(texture.Create());
            Assert.That(Read<float>(texture), Is.All.NaN);
        }

        [Test]
        public void CreatedRenderTexture_Resized_LogsAnError()
        {
            var texture = Volume(2, 2, 2, GraphicsFormat.R32_SFloat);
            LogAssert.Expect(LogType.Error, new Regex("width of already created render texture"));
            texture.width = 4;
        }

        [Test]
        public void TemporaryTexture_Returned_IsLentAgain()
        {
            var first = RenderTexture.GetTemporary(16, 16, 0, GraphicsFormat.R32_SFloat);
            RenderTexture.ReleaseTemporary(first);
            var second = RenderTexture.GetTemporary(16, 16, 0, GraphicsFormat.R32_SFloat);
            RenderTexture.ReleaseTemporary(second);
            Assert.That(ReferenceEquals(first, second));
        }

        [Test]
        public void ReadPixels_OfActiveTexture_ConvertsItsValues()
        {
            var source = Own(new Texture2D(2, 2, TextureFormat.RFloat, false));
            source.SetPixelData(new[] { 0f, 0.2f, 0.4f, 2f }, 0);
            source.Apply(false);
            var target = Own(new RenderTexture(2, 2, 0, GraphicsFormat.R32_SFloat));
            UnityEngine.Graphics.CopyTexture(source, target);
            RenderTexture.active = target;
            var picture = Own(new Texture2D(2, 2, TextureFormat.R8, false, true));
            picture.ReadPixels(new Rect(0, 0, 2, 2), 0, 0);
            RenderTexture.active = null;
            Assert.That(picture.GetRawTextureData(), Is.EqualTo(new byte[] { 0, 51, 102, 255 }));
        }
    }
}
