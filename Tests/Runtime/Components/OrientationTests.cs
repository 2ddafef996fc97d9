using System.Collections;
using System.Collections.Generic;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>The patient is never mirrored, however the image is stored and wherever the camera stands.</summary>
    sealed class OrientationTests : PlayModeScene
    {
        const int Pixels = 48;

        [Test]
        public void Viewer_LookingAlongZ_SeesThePatientsRightOnTheLeft()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            PictureData picture = renderer.Render(MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up), Pixels, Pixels).Read();
            Assert.That(MeanPixel(picture, Phantoms.Right).x, Is.LessThan(0.3f * Pixels));
            Assert.That(MeanPixel(picture, Phantoms.Left).x, Is.GreaterThan(0.7f * Pixels));
            Assert.That(MeanPixel(picture, Phantoms.Superior).y, Is.GreaterThan(0.7f * Pixels), "row 0 is the bottom row");
            Assert.That(MeanPixel(picture, Phantoms.Inferior).y, Is.LessThan(0.3f * Pixels));
            Assert.That(picture.Segments[Pixels / 2 * (Pixels + 1)], Is.EqualTo(Phantoms.Anterior), "the face is in front");
        }

        [Test]
        public void Viewer_BehindThePatient_SeesThePatientsRightOnTheRight()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            PictureData picture = renderer.Render(MakeCamera(new Vector3(0f, 0f, 0.08f), Vector3.up), Pixels, Pixels).Read();
            Assert.That(MeanPixel(picture, Phantoms.Right).x, Is.GreaterThan(0.7f * Pixels));
            Assert.That(picture.Segments[Pixels / 2 * (Pixels + 1)], Is.EqualTo(Phantoms.Posterior));
        }

        [Test]
        public void Camera_AndRaysOfThePatient_AgreeOnTheFrontView()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            PictureData ofCamera = renderer.Render(MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up), Pixels, Pixels).Read();
            AssertAgree(renderer.Render(FrontView(renderer.Volume, Pixels)).Read(), ofCamera, "front view");
        }

        [Test]
        public void Picture_OfEachOf48Orientations_IsTheSame()
        {
            PictureData expected = null;
            int number = 0;
            foreach (VectorMm[] axes in Phantoms.Orientations())
            {
                const int size = 32;
                const double spacing = 1.25;
                SegmentedVolume volume = Phantoms.Markers(
                    Phantoms.Centred(axes[0] * spacing, axes[1] * spacing, axes[2] * spacing, size, size, size), size, size, size);
                CarvedVolumeRenderer renderer = MakeVolume(volume);
                renderer.Stack.SetActive(new Vector3(0.004f, 0f, -0.016f), 0.008f);
                PictureData picture = renderer.Render(Oblique(volume)).Read();
                expected ??= picture;
                AssertAgree(expected, picture, volume.Geometry.OrientationCode);
                renderer.ReleaseResources();
                number++;
            }
            Assert.That(number, Is.EqualTo(48));
        }

        [Test]
        public void Picture_OfAnObliqueGrid_ShowsTheSamePatient()
        {
            SegmentedVolume straight = Phantoms.Markers(64);
            Quaternion turn = Quaternion.Euler(25f, -40f, 15f);
            VectorMm Axis(Vector3 v) => new VectorMm(v.x, v.y, v.z) * 0.7;
            SegmentedVolume oblique = Phantoms.Markers(
                Phantoms.Centred(Axis(turn * Vector3.right), Axis(turn * Vector3.up), Axis(turn * Vector3.forward), 80, 80, 80), 80, 80, 80);
            PictureData a = MakeVolume(straight).Render(FrontView(straight, Pixels)).Read();
            PictureData b = MakeVolume(oblique).Render(FrontView(oblique, Pixels)).Read();
            for (int segment = Phantoms.Right; segment <= Phantoms.Inferior; segment++)
                if (segment != Phantoms.Posterior)
                    Assert.That((MeanPixel(a, segment) - MeanPixel(b, segment)).magnitude, Is.LessThan(0.6f), $"segment {segment}");
        }

        static PictureRays Oblique(SegmentedVolume volume) => PictureRays.Perspective(
            volume.Geometry.CentreLps + new VectorMm(31, -67, 43), volume.Geometry.CentreLps, new VectorMm(0.1, 0.2, 1), 38, Pixels, Pixels);

        /// <summary>The same but for rounding: axes in another order are summed in another order.</summary>
        static void AssertAgree(PictureData expected, PictureData actual, string what)
        {
            var wrong = new List<int>();
            for (int p = 0; p < expected.Segments.Length; p++)
                if (expected.Segments[p] != actual.Segments[p]
                    || (expected.Segments[p] != PictureData.NoSegment && Mathf.Abs(expected.DepthMm[p] - actual.DepthMm[p]) > 0.05f))
                    wrong.Add(p);
            Assert.That(wrong.Count, Is.LessThanOrEqualTo(expected.Segments.Length / 100), what);
        }
    }
}
