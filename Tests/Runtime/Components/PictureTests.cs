using System;
using System.Collections;
using System.Threading.Tasks;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Pictures: one per camera, of several volumes, read back, hidden by the scene.</summary>
    sealed class PictureTests : PlayModeScene
    {
        [Test]
        public void Render_OfACameraWithoutAPixel_GivesNoPicture()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            camera.rect = new Rect(0f, 0f, 0f, 1f);
            Assert.That(renderer.Render(camera), Is.Null);
            Assert.That(renderer.Problem, Is.Null);
        }

        [Test]
        public void Cameras_Two_HavePicturesOfTheirOwn()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera front = MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up), top = MakeCamera(new Vector3(0f, 0.08f, 0f), Vector3.forward);
            CarvedPicture ofFront = renderer.Render(front, 32, 32), ofTop = renderer.Render(top, 40, 40);
            Assert.That(ofTop, Is.Not.SameAs(ofFront));
            Assert.That(renderer.Render(front, 32, 32), Is.SameAs(ofFront));
            Assert.That(ofFront.Read().Segments[16 * 33], Is.EqualTo(Phantoms.Anterior));
            Assert.That(ofTop.Read().Segments[20 * 41], Is.EqualTo(Phantoms.Superior));
        }

        [Test]
        public void Volumes_Two_DoNotDisturbEachOther()
        {
            CarvedVolumeRenderer markers = MakeVolume(Phantoms.Markers()), cube = MakeVolume(Phantoms.Cube(20, "Cube"));
            markers.Stack.SetActive(new Vector3(0f, 0f, -0.014f), 0.003f);
            PictureData alone = markers.Render(FrontView(markers.Volume)).Read();
            cube.Stack.SetActive(Vector3.zero, 0.002f);
            Assert.That(Count(cube.Render(FrontView(cube.Volume)).Read(), 1), Is.GreaterThan(100));
            markers.Light.Ambient = 0.3f;
            markers.Render(FrontView(markers.Volume));
            markers.Light.Ambient = 0.25f;
            AssertSamePicture(alone, markers.Render(FrontView(markers.Volume)).Read());
        }

        [UnityTest]
        public IEnumerator Camera_Destroyed_TakesItsPictureWithIt()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera first = MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up), second = MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            renderer.Render(second, 16, 16);
            long bytes = renderer.Statistics.BytesResident;
            renderer.Render(first, 16, 16);
            Object.Destroy(first.gameObject);
            yield return null;
            renderer.Render(second, 16, 16);
            Assert.That(renderer.Statistics.BytesResident, Is.EqualTo(bytes));
        }

        [Test]
        public void Picture_OfAnotherSize_IsMadeAgain()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Render(FrontView(renderer.Volume, 16));
            CarvedPicture picture = renderer.Render(FrontView(renderer.Volume, 40));
            Assert.That(new[] { picture.Width, picture.Height, picture.ColorTexture.width, picture.SegmentTexture.height }, Is.All.EqualTo(40));
        }

        [Test]
        public void Background_OfAPicture_IsTransparentAndInfinitelyFar()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            PictureData picture = renderer.Render(FrontView(renderer.Volume)).Read();
            Assert.That(picture.Segments[0], Is.EqualTo(PictureData.NoSegment));
            Assert.That(picture.DepthMm[0], Is.EqualTo(float.PositiveInfinity));
            Assert.That(picture.Color[0], Is.EqualTo(new Color(0f, 0f, 0f, 0f)));
        }

        [Test]
        public void Depth_OfTheFace_IsItsDistanceFromTheEye()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(80));
            PictureData picture = renderer.Render(FrontView(renderer.Volume, 49)).Read();
            Assert.That(picture.DepthMm[24 * 50], Is.EqualTo(80f - 18f).Within(0.5f), "the anterior marker's nearest point lies 18 mm before the centre");
        }

        [UnityTest]
        public IEnumerator ReadAsync_SomeFramesLater_IsWhatReadGives()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            CarvedPicture picture = renderer.Render(FrontView(renderer.Volume));
            Task<PictureData> reading = picture.ReadAsync();
            while (!reading.IsCompleted)
                yield return null;
            AssertSamePicture(picture.Read(), reading.Result);
        }

        [Test]
        public void Samples_WhereCounted_AreFewerWithLongerSteps()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Assert.That(renderer.Render(FrontView(renderer.Volume)).ReadSampleCount(), Is.EqualTo(-1), "not counted");
            renderer.CountSamples = true;
            long half = renderer.Render(FrontView(renderer.Volume)).ReadSampleCount();
            renderer.Quality.Step = 1f;
            long whole = renderer.Render(FrontView(renderer.Volume)).ReadSampleCount();
            Assert.That(whole, Is.GreaterThan(0));
            Assert.That(half, Is.EqualTo(2 * whole).Within(20).Percent);
        }

        [UnityTest]
        public IEnumerator Cameras_AllDestroyed_TakeTheirPicturesWithThem()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Render(FrontView(renderer.Volume, 16));
            long bytes = renderer.Statistics.BytesResident;
            Camera camera = MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            renderer.Render(camera, 16, 16);
            Object.Destroy(camera.gameObject);
            yield return null;
            yield return null;
            Assert.That(renderer.Statistics.BytesResident, Is.EqualTo(bytes), "nothing has to be rendered for that");
        }

        [Test]
        public void Png_OfAPicture_IsAPngOfItsSize()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            byte[] png = renderer.Render(FrontView(renderer.Volume, 32)).Read().EncodeToPng(Color.black);
            Assert.That(new[] { png[1], png[2], png[3] }, Is.EqualTo(new[] { (byte)'P', (byte)'N', (byte)'G' }));
            Assert.That(new[] { png[19], png[23] }, Is.All.EqualTo(32), "width and height of the header");
        }

        [Test]
        public void Background_InSrgb_IsTheColourThatWasAskedFor()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            byte[] srgb = renderer.Render(FrontView(renderer.Volume, 32)).Read().ToSrgb(new Color32(10, 100, 200, 255));
            Assert.That(new[] { srgb[0], srgb[1], srgb[2], srgb[3] }, Is.EqualTo(new byte[] { 10, 100, 200, 255 }));
        }

        [Test]
        public void Read_BeforeTheFirstRendering_IsRefused()
        {
            using (var picture = new CarvedPicture())
                Assert.That(() => picture.Read(), Throws.InvalidOperationException);
        }
    }
}
