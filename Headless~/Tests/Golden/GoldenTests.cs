using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Golden
{
    /// <summary>
    /// Twelve scenes through the package's components against the pictures that are kept of them. ANATOMYCARVE_GOLDEN=write makes the pictures anew, for
    /// the driver at hand; look at them before they are committed.
    /// </summary>
    sealed class GoldenTests
    {
        static readonly Color Background = new(0.1f, 0.1f, 0.12f);

        readonly List<string> errors = [];
        UnityHost host;
        GoldenStore store;

        static IReadOnlyList<GoldenScene> Scenes => GoldenScene.All;

        [OneTimeSetUp]
        public void StartHost()
        {
            host = UnityHost.Start(new HostOptions { Log = Remember });
            store = new GoldenStore(GoldenStore.DriverName(SystemInfo.graphicsDeviceName, SystemInfo.graphicsDeviceVersion));
        }

        [OneTimeTearDown]
        public void EndHost() => host.Dispose();

        [TestCaseSource(nameof(Scenes))]
        public void Scene_IsThePictureThatIsKept(GoldenScene scene)
        {
            byte[] png = Draw(scene);
            if (store.IsWriting)
            {
                store.Write(scene.Name, png);
                Assert.Pass("written");
            }
            Assert.That(store.HasGoldens, "No picture is kept for any driver: ANATOMYCARVE_GOLDEN=write makes them.");
            double decibels = store.Compare(scene.Name, png);
            string driver = store.IsSameDriver ? "the driver that made it" : "another driver";
            string figures = FormattableString.Invariant($"{decibels:f1} dB, last {store.LastFigure(scene.Name):f1} (999: identical), on {driver}");
            TestContext.Out.WriteLine(figures);
            Assert.That(decibels, Is.GreaterThanOrEqualTo(store.LimitDecibels), figures + "; see Headless~/out/golden");
        }

        [Test]
        public void Scenes_HaveNamesOfTheirOwn() => Assert.That(Scenes.Select(scene => scene.Name), Is.Unique.And.Exactly(12).Items);

        void Remember(LogType type, string message, string stackTrace)
        {
            if (type is LogType.Error or LogType.Exception or LogType.Assert)
                errors.Add(message);
        }

        byte[] Draw(GoldenScene scene)
        {
            var o = new GameObject(scene.Name, typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer));
            try
            {
                var renderer = o.GetComponent<CarvedVolumeRenderer>();
                renderer.Loader.SetVolume(scene.Volume());
                scene.Prepare(renderer);
                CarvedPicture picture = renderer.Render(scene.Rays(renderer.Volume));
                Assert.That(picture, Is.Not.Null, renderer.Problem);
                PictureData data = picture.Read();
                Assert.That(errors, Is.Empty);
                Assert.That(data.Segments.Count(segment => segment != PictureData.NoSegment), Is.GreaterThan(GoldenScene.Pixels), "what is seen");
                return data.EncodeToPng(Background);
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(o);
                host.Step();
            }
        }
    }
}
