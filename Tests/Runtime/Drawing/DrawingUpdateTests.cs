using System;
using System.Collections;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace AnatomyCarve.Tests.Drawing
{
    /// <summary>What cameras cause to be computed, when, and what they draw.</summary>
    sealed class DrawingUpdateTests : DrawnScene
    {
        [UnityTest]
        public IEnumerator Frames_InWhichNothingChanged_ComputeNothing()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera first = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up), second = MakeDrawingCamera(new Vector3(0f, 0.08f, 0f), Vector3.forward);
            first.enabled = second.enabled = true;
            yield return null;
            yield return null;
            int dispatches = renderer.Statistics.VolumeDispatches;
            Assert.That(dispatches, Is.EqualTo(7), "ClearBricks, three stages and three of the skip structure, each once, for both cameras");
            for (int frame = 0; frame < 3; frame++)
                yield return null;
            Assert.That(renderer.Statistics.VolumeDispatches, Is.EqualTo(dispatches));
            Assert.That(renderer.Statistics.Raymarch.Dispatches, Is.Zero, "cameras draw with the eye shader");
        }

        [Test]
        public void Sphere_MovedBeforeAPicture_IsSeenInIt()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            int whole = CountDrawn(Draw(camera), camera);
            renderer.Stack.SetActive(Vector3.zero, 1f);
            Assert.That(CountDrawn(Draw(camera), camera), Is.Zero, "everything is clipped");
            renderer.Stack.Undo();
            Assert.That(CountDrawn(Draw(camera), camera), Is.EqualTo(whole));
        }

        [UnityTest]
        public IEnumerator Sphere_MovedByACallbackBeforeRendering_IsSeenInTheSameFrame()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            camera.enabled = true;
            yield return null;
            yield return null;
            Assert.That(CountDrawn(Read(camera.targetTexture), camera), Is.GreaterThan(100));
            int carvedFrame = -1;
            void Carve()
            {
                // After all updates, as poses of a headset come in.
                renderer.Stack.SetActive(Vector3.zero, 1f);
                carvedFrame = Time.frameCount;
                Application.onBeforeRender -= Carve;
            }
            Application.onBeforeRender += Carve;
            yield return null;
            Assert.That(carvedFrame, Is.EqualTo(Time.frameCount - 1), "one picture was drawn since");
            Assert.That(CountDrawn(Read(camera.targetTexture), camera), Is.Zero);
        }

        [UnityTest]
        public IEnumerator Renderer_EndedByAnEarlierListener_LeavesNothing([Values("disable", "destroy")] string deed)
        {
            CarvedVolumeRenderer renderer = null;
            void End(Camera camera)
            {
                if (deed == "disable")
                    renderer.enabled = false;
                else
                    UnityEngine.Object.DestroyImmediate(renderer);
            }
            Camera.onPreCull += End; // before the renderer's own
            try
            {
                renderer = MakeVolume(Phantoms.Markers());
                Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
                MeshFilter filter = renderer.GetComponent<MeshFilter>();
                yield return null;
                Assert.That(CountDrawn(Draw(camera), camera), Is.Zero);
                Assert.That(filter.sharedMesh == null, Is.True);
                Assert.That(CountGpuObjects(), Is.Zero);
            }
            finally
            {
                Camera.onPreCull -= End;
            }
        }

        [Test]
        public void Resources_ReleasedAfterTheVolumeWasPlaced_AreNotDrawnWith()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            void Release(Camera camera) => renderer.ReleaseResources();
            Camera.onPreCull += Release; // after the renderer's own
            try
            {
                Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
                Assert.That(CountDrawn(Draw(camera), camera), Is.Zero);
            }
            finally
            {
                Camera.onPreCull -= Release;
            }
        }

        [Test]
        public void Resources_ReleasedBetweenCullingAndDrawing_DoNoHarm()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            int whole = CountDrawn(Draw(camera), camera);
            void Disable(Camera c) => renderer.enabled = false;
            Camera.onPreRender += Disable;
            try
            {
                Draw(camera); // with what was culled, or without it
            }
            finally
            {
                Camera.onPreRender -= Disable;
            }
            Assert.That(CountDrawn(Draw(camera), camera), Is.Zero);
            renderer.enabled = true;
            Assert.That(CountDrawn(Draw(camera), camera), Is.EqualTo(whole));
        }

        /// <summary>The textures that the camera was about to draw with go, as other voxels are stored now.</summary>
        [Test]
        public void Textures_MadeAnewBetweenCullingAndDrawing_AreDrawn()
        {
            SegmentedVolume volume = Phantoms.Markers(64);
            CarvedVolumeRenderer renderer = MakeVolume(volume);
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            int whole = CountDrawn(Draw(camera), camera);
            long stored = renderer.Statistics.StoredVoxels.Value.VoxelCount;
            void ShowOne(Camera c)
            {
                SegmentTable table = volume.Segments;
                for (int s = 0; s < table.Count; s++)
                    table = s == Phantoms.Anterior ? table : table.WithOpacity(s, 0);
                renderer.Segments = table;
                renderer.Render(FrontView(volume, 8));
            }
            Camera.onPreRender += ShowOne;
            try
            {
                Assert.That(CountDrawn(Draw(camera), camera), Is.InRange(1, whole - 1));
            }
            finally
            {
                Camera.onPreRender -= ShowOne;
            }
            Assert.That(renderer.Statistics.StoredVoxels.Value.VoxelCount, Is.LessThan(stored / 2));
        }

        [UnityTest]
        public IEnumerator Clone_OfARendererThatGoes_DrawsWithItsOwn()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            int whole = CountDrawn(Draw(camera), camera);
            GameObject clone = Own(UnityEngine.Object.Instantiate(renderer.gameObject));
            SegmentedVolume volume = renderer.Volume;
            UnityEngine.Object.DestroyImmediate(renderer.gameObject);
            Assert.That(CountDrawn(Draw(camera), camera), Is.Zero, "it has no volume yet");
            clone.GetComponent<VolumeLoader>().SetVolume(volume);
            yield return null;
            Assert.That(CountDrawn(Draw(camera), camera), Is.EqualTo(whole));
        }

        [UnityTest]
        public IEnumerator Mesh_AndMaterial_AreThereBeforeACameraBegins()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            yield return null;
            yield return null;
            Assert.That(renderer.GetComponent<MeshFilter>().sharedMesh, Is.Not.Null, "its bounds are known when cameras cull");
            Assert.That(renderer.GetComponent<MeshRenderer>().sharedMaterial, Is.Not.Null);
            Assert.That(renderer.Statistics.BytesResident, Is.Zero, "nobody looked yet, so nothing is on the GPU");
        }

        [Test]
        public void Volume_OnALayerThatACameraDoesNotSee_IsNotDrawn()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            renderer.gameObject.layer = 1;
            camera.cullingMask = ~(1 << 1);
            Assert.That(CountDrawn(Draw(camera), camera), Is.Zero);
            Assert.That(renderer.Statistics.VolumeDispatches, Is.Zero, "nobody sees it, so nothing is computed");
            camera.cullingMask = 1 << 1;
            Assert.That(CountDrawn(Draw(camera), camera), Is.GreaterThan(100));
        }

        [Test]
        public void Volume_ThatIsNotToBeDrawn_IsNot()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            renderer.DrawInCameras = false;
            Assert.That(CountDrawn(Draw(camera), camera), Is.Zero);
            renderer.DrawInCameras = true;
            Assert.That(CountDrawn(Draw(camera), camera), Is.GreaterThan(100));
            renderer.enabled = false;
            Assert.That(CountDrawn(Draw(camera), camera), Is.Zero);
        }

        [Test]
        public void Volume_OfNoExtent_IsNotDrawn()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.transform.localScale = new Vector3(1f, 0f, 1f);
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            Assert.That(CountDrawn(Draw(camera), camera), Is.Zero);
        }

        [Test]
        public void Volume_Replaced_IsDrawnInsteadOfTheFirst()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            Draw(camera);
            renderer.Loader.SetVolume(Phantoms.Cube(16, "Cube"));
            AssertAlike(Draw(camera), Over(renderer.Render(camera).Read(), camera), 0.002, "the cube");
            renderer.Loader.Unload();
            Assert.That(CountDrawn(Draw(camera), camera), Is.Zero);
        }

        [Test]
        public void Looks_Changed_AreSeenInTheNextPicture()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
            Color[] before = Draw(camera);
            void AssertChanged(string what)
            {
                Color[] after = Draw(camera);
                Assert.That(after, Is.Not.EqualTo(before), what);
                AssertAlike(after, Over(renderer.Render(camera).Read(), camera), 0.002, what);
                before = after;
            }
            renderer.Light.Direction = new Vector3(1f, 0f, 0.2f);
            AssertChanged("the light's direction");
            renderer.Light.Color = Color.red;
            AssertChanged("the light's colour");
            renderer.Light.Ambient = 0.6f;
            AssertChanged("ambient light");
            renderer.Segments = renderer.Volume.Segments.WithColor(Phantoms.Anterior, new SegmentColor(255, 255, 255));
            AssertChanged("a segment's colour");
            renderer.Quality.FirstVisibleAlpha = 0.9f;
            renderer.Quality.Step = 2f;
            AssertChanged("the step");
            renderer.TransferFunction = OpacityTransferFunction.Constant(0.01);
            AssertChanged("the transfer function");
        }

        [Test]
        public void Callbacks_OfACamera_LeaveNoGarbage()
        {
            _ = AllocatedBytes.OfThisThread();
            long before = 0, bytes = -1;
            int cameras = 0;
            void First(Camera camera) => before = GC.GetAllocatedBytesForCurrentThread();
            void Last(Camera camera)
            {
                bytes = GC.GetAllocatedBytesForCurrentThread() - before;
                cameras++;
            }
            void FirstInContext(ScriptableRenderContext context, Camera camera) => First(camera);
            void LastInContext(ScriptableRenderContext context, Camera camera) => Last(camera);
            Camera.onPreCull += First;
            RenderPipelineManager.beginCameraRendering += FirstInContext;
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Camera.onPreCull += Last;
            RenderPipelineManager.beginCameraRendering += LastInContext;
            try
            {
                renderer.Stack.SetActive(new Vector3(0f, 0f, -0.014f), 0.004f);
                Camera viewer = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up);
                for (int frame = 0; frame < 50; frame++)
                    viewer.Render();
                Assert.That(cameras, Is.EqualTo(50));
                Assert.That(bytes, Is.Zero);
            }
            finally
            {
                Camera.onPreCull -= First;
                Camera.onPreCull -= Last;
                RenderPipelineManager.beginCameraRendering -= FirstInContext;
                RenderPipelineManager.beginCameraRendering -= LastInContext;
            }
        }
    }
}
