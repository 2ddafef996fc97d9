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

        [TestCase(GraphicsFormat.R16_UNorm)]
        [TestCase(GraphicsFormat.R8_UInt)]
        [TestCase(GraphicsFormat.R8_UNorm)]
        [TestCase(GraphicsFormat.R8G8_UNorm)]
        [TestCase(GraphicsFormat.R16G16B16A16_SFloat)]
        public void Render_WithoutAFormat_SaysWhichOnce(GraphicsFormat denied)
        {
            errors.Clear();
            var options = new HostOptions { DeniedFormats = [denied], Log = Remember };
            using (UnityHost host = UnityHost.Start(options))
            {
                SegmentedVolume volume = Block();
                CarvedVolumeRenderer renderer = Show(volume);
                Assert.That(renderer.Render(View(volume)), Is.Null);
                host.Step();
                Assert.That(renderer.Render(View(volume)), Is.Null);
                UnityEngine.Object.DestroyImmediate(renderer.gameObject);
            }
            Assert.That(errors, Has.Count.EqualTo(1));
            Assert.That(errors[0], Does.Contain(denied.ToString()).And.Contain("cannot be shown"));
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
