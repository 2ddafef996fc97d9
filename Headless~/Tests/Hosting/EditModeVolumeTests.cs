using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using AnatomyCarve.Headless.Tests.Layout;
using NUnit.Framework;
using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Hosting
{
    /// <summary>The demo's scene in an Editor that does not play: opened, looked at, changed in the Inspector, closed.</summary>
    public sealed class EditModeVolumeTests
    {
        const int PatienceFrames = 20_000;

        static readonly string Scene = Path.Combine(PackageTree.OfRepository().Root, "Samples~/DemoHead/DemoHead.unity");

        readonly List<string> complaints = [];
        UnityHost host;

        [SetUp]
        public void Open()
        {
            complaints.Clear();
            host = UnityHost.Start(new HostOptions
            {
                PlayMode = false,
                ScreenWidth = 64,
                ScreenHeight = 36,
                Log = (type, message, _) =>
                {
                    if (type != LogType.Log)
                        complaints.Add(message);
                },
            });
            host.LoadScene(Scene);
            Assert.That(host.RunUntil(() => Head.Volume != null, PatienceFrames), Is.True, "it is loaded without Play");
        }

        [TearDown]
        public void Close()
        {
            host.UnloadScene();
            host.Step();
            host.Dispose();
            Assert.That(host.Report.LeakCount, Is.Zero, host.Report.ToString());
            Assert.That(complaints, Is.Empty);
        }

        static CarvedVolumeRenderer Head => Object.FindFirstObjectByType<CarvedVolumeRenderer>();

        [Test]
        public void Camera_ShowsTheHead_AndTheMouseDoesNothing()
        {
            Assert.That(DrawnPixels(), Is.GreaterThan(500));
            Vector3 before = Camera.transform.position;
            using var desk = new HostInput();
            desk.Press(UnityEngine.InputSystem.LowLevel.MouseButton.Right);
            desk.MoveTo(500, 300);
            host.Step();
            Assert.That(Camera.transform.position, Is.EqualTo(before));
        }

        [Test]
        public void Mesh_AndMaterial_AreNotSavedWithTheScene()
        {
            Draw();
            Assert.That(Head.GetComponent<MeshFilter>().sharedMesh.hideFlags, Is.EqualTo(HideFlags.HideAndDontSave));
            Assert.That(Head.GetComponent<MeshRenderer>().sharedMaterial.hideFlags, Is.EqualTo(HideFlags.HideAndDontSave));
            Head.enabled = false;
            Assert.That(Head.GetComponent<MeshFilter>().sharedMesh, Is.Null);
            Assert.That(Head.GetComponent<MeshRenderer>().sharedMaterial, Is.Null);
        }

        [Test]
        public void Inspector_ChangesOfTheStartCarving_AreShownAtOnce()
        {
            int carved = DrawnPixels();
            host.SetSerializedField(Head.Stack, "startFile", null);
            host.Step();
            Assert.That(Head.Stack.Carving.Spheres, Is.Empty);
            Assert.That(DrawnPixels(), Is.GreaterThan(carved), "the whole head");
        }

        [Test]
        public void Inspector_ChangesOfTheAsset_LoadAndUnload()
        {
            var asset = Head.Loader.Asset;
            host.SetSerializedField(Head.Loader, "asset", null);
            host.Step();
            Assert.That(Head.Volume, Is.Null);
            Assert.That(DrawnPixels(), Is.Zero);
            host.SetSerializedField(Head.Loader, "asset", asset);
            Assert.That(host.RunUntil(() => Head.Volume != null, PatienceFrames), Is.True);
            Assert.That(DrawnPixels(), Is.GreaterThan(500));
        }

        [Test]
        public void Asset_ImportedAnew_IsLoadedAnew()
        {
            SegmentedVolume before = Head.Volume;
            host.Step();
            Assert.That(Head.Volume, Is.SameAs(before), "the same asset is the same volume");
            VolumeAsset asset = Head.Loader.Asset;
            host.SetSerializedField(asset, "checksum", 4711L); // what another file's import would leave there
            Assert.That(host.RunUntil(() => Head.Volume != null && Head.Volume != before, PatienceFrames), Is.True);
            Assert.That(Head.Loader.Asset, Is.SameAs(asset));
        }

        [Test]
        public void Inspector_ChangesThatDoNotTouchTheLooks_ComputeNothing()
        {
            Draw();
            int dispatches = Head.Statistics.VolumeDispatches;
            host.SetSerializedField(Head, "shading.ambient", 0.4f);
            host.SetSerializedField(Head, "quality.step", 0.7f);
            Draw();
            Assert.That(Head.Statistics.VolumeDispatches, Is.EqualTo(dispatches), "light and step are the rays' alone");
            host.SetSerializedField(Head, "quality.antiAliasing", 0.5f);
            Draw();
            Assert.That(Head.Statistics.VolumeDispatches, Is.GreaterThan(dispatches));
        }

        [Test]
        public void Components_ThatAreFoundBeside_AreNotWrittenIntoTheScene()
        {
            var volume = new GameObject("Volume", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer), typeof(SegmentPointer));
            var renderer = volume.GetComponent<CarvedVolumeRenderer>();
            var pointer = volume.GetComponent<SegmentPointer>();
            Assert.That((renderer.Loader, renderer.Stack.Loader), Is.EqualTo((volume.GetComponent<VolumeLoader>(), volume.GetComponent<VolumeLoader>())));
            Assert.That(pointer.Target, Is.SameAs(renderer));
            Assert.That((Saved(renderer, "loader"), Saved(renderer, "stack"), Saved(renderer.Stack, "loader"), Saved(pointer, "target")),
                Is.EqualTo(((object)null, (object)null, (object)null, (object)null)));
            Object.DestroyImmediate(volume);
        }

        [Test]
        public void Inspector_ChangesOfTheLooks_AreShown()
        {
            int before = DrawnPixels();
            host.SetSerializedField(Head, "appearance.customTransferFunction", false);
            Assert.That(Head.Appearance.TransferFunction, Is.Null);
            Assert.That(DrawnPixels(), Is.GreaterThan(0));
            host.SetSerializedField(Head, "drawInCameras", false);
            Assert.That(DrawnPixels(), Is.Zero);
            host.SetSerializedField(Head, "drawInCameras", true);
            host.SetSerializedField(Head, "appearance.customTransferFunction", true);
            Assert.That(DrawnPixels(), Is.EqualTo(before));
        }

        static object Saved(Component component, string field) =>
            component.GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).GetValue(component);

        static Camera Camera => Object.FindFirstObjectByType<Camera>();

        static Color32[] Draw()
        {
            var target = new RenderTexture(64, 64, 32);
            Camera.targetTexture = target;
            Camera.Render();
            Camera.targetTexture = null;
            var request = UnityEngine.Rendering.AsyncGPUReadback.Request(target, 0);
            request.WaitForCompletion();
            Color32[] pixels = request.GetData<Color32>().ToArray();
            Object.DestroyImmediate(target);
            return pixels;
        }

        static int DrawnPixels() => Draw().Count(p => p.r > 0x30);
    }
}
