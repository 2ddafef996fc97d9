using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace AnatomyCarve.Headless.Tests.Devices
{
    /// <summary>On a device that lacks a texture format the renderer says so once, clearly, and shows nothing.</summary>
    public class UnsupportedDeviceTests
    {
        readonly List<string> errors = [];

        [TestCase(GraphicsFormat.R16_UInt)]
        [TestCase(GraphicsFormat.R32_UInt)]
        [TestCase(GraphicsFormat.R32_SFloat)]
        [TestCase(GraphicsFormat.R32G32B32A32_SFloat)]
        [TestCase(GraphicsFormat.R16G16B16A16_SFloat)]
        public void Render_WithoutAFormatThatIsNeeded_SaysWhichOnce(GraphicsFormat denied)
        {
            Assert.That(Render([denied], out _), Is.Null);
            Assert.That(errors, Has.Count.EqualTo(1));
            Assert.That(errors[0], Does.Contain(denied.ToString()).And.Contain("cannot be"));
        }

        [TestCase(GraphicsFormat.R8_UInt)]
        [TestCase(GraphicsFormat.R8_UNorm)]
        [TestCase(GraphicsFormat.R8G8_UNorm)]
        [TestCase(GraphicsFormat.R16_UNorm)]
        [TestCase(GraphicsFormat.R8G8B8A8_UNorm)]
        public void Render_WithoutAFormatThatHasAnother_ShowsTheSame(GraphicsFormat denied)
        {
            PictureData expected = Render([], out _), picture = Render([denied], out _);
            Assert.That(errors, Is.Empty);
            Assert.That(picture.Segments, Is.EqualTo(expected.Segments));
            for (int p = 0; p < expected.Color.Length; p++)
                Assert.That(((Vector4)picture.Color[p] - (Vector4)expected.Color[p]).magnitude, Is.LessThan(1 / 255f), "pixel " + p);
        }

        [TestCase(GraphicsFormat.R8_UNorm)]
        [TestCase(GraphicsFormat.R8G8_UNorm)]
        public void Layout_OfADeviceThatCannotWriteBytes_IsPortable(GraphicsFormat denied)
        {
            Assert.That(Render([denied], out TextureLayout layout), Is.Not.Null);
            Assert.That(layout, Is.EqualTo(TextureLayout.Portable));
        }

        [Test]
        public void Layout_OfADeviceThatCan_IsCompact()
        {
            Assert.That(Render([], out TextureLayout layout), Is.Not.Null);
            Assert.That(layout, Is.EqualTo(TextureLayout.Compact));
        }

        [Test]
        public void Layout_ThatIsAskedForAndCannotBe_IsRefusedClearly()
        {
            Assert.That(Render([GraphicsFormat.R8_UNorm], out _, TextureLayout.Compact), Is.Null);
            Assert.That(errors, Has.Count.EqualTo(1));
            Assert.That(errors[0], Does.Contain("R8_UNorm"));
        }

        [Test]
        public void Host_AfterARenderersEnd_HoldsNothing()
        {
            errors.Clear();
            UnityHost host = UnityHost.Start(new HostOptions { Log = Remember });
            SegmentedVolume volume = Block();
            CarvedVolumeRenderer renderer = Show(volume);
            Assert.That(renderer.Render(View(volume)).Read().Segments[8 * 17], Is.Zero);
            UnityEngine.Object.Destroy(renderer.gameObject);
            host.Step();
            host.Step();
            host.Dispose();
            Assert.That(host.Report.LeakCount, Is.Zero, host.Report.ToString());
            Assert.That(errors, Is.Empty);
        }

        /// <summary>The picture of a device that lacks formats, asked for in two frames; null where it cannot be made.</summary>
        PictureData Render(GraphicsFormat[] denied, out TextureLayout layout, TextureLayout wanted = TextureLayout.Automatic)
        {
            errors.Clear();
            using UnityHost host = UnityHost.Start(new HostOptions { DeniedFormats = denied, Log = Remember });
            SegmentedVolume volume = Block();
            CarvedVolumeRenderer renderer = Show(volume);
            renderer.Layout = wanted;
            CarvedPicture first = renderer.Render(View(volume));
            host.Step();
            CarvedPicture second = renderer.Render(View(volume));
            Assert.That(second == null, Is.EqualTo(first == null));
            Assert.That(renderer.Problem == null, Is.EqualTo(first != null), renderer.Problem);
            layout = renderer.Statistics.Layout;
            PictureData picture = second?.Read();
            UnityEngine.Object.DestroyImmediate(renderer.gameObject);
            return picture;
        }

        static SegmentedVolume Block()
        {
            var geometry = new VolumeGeometry(12, 12, 12, Affine.Identity);
            ushort[] codes = Enumerable.Repeat((ushort)1000, 12 * 12 * 12).ToArray();
            return SegmentedVolume.Unsegmented(new IntensityVolume(geometry, codes, 0, 1, 1000));
        }

        static CarvedVolumeRenderer Show(SegmentedVolume volume)
        {
            var shown = new GameObject("Volume", typeof(VolumeLoader), typeof(CarvedVolumeRenderer));
            shown.GetComponent<VolumeLoader>().SetVolume(volume);
            var renderer = shown.GetComponent<CarvedVolumeRenderer>();
            renderer.TransferFunction = Volumes.OpacityTransferFunction.Constant(1);
            return renderer;
        }

        static PictureRays View(SegmentedVolume volume)
        {
            PointMm centre = volume.Geometry.CentreLps;
            return PictureRays.Perspective(centre + new VectorMm(0, -40, 0), centre, new VectorMm(0, 0, 1), 30, 16, 16);
        }

        void Remember(LogType type, string message, string stackTrace)
        {
            if (type is LogType.Error or LogType.Exception or LogType.Assert)
                errors.Add(message);
        }
    }
}
