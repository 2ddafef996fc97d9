using System;
using System.Collections;
using System.Runtime.CompilerServices;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>A renderer's resources: made when needed, kept, lost, freed.</summary>
    sealed class RendererLifeCycleTests : PlayModeScene
    {
        static readonly Type[] Three = { typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer) };

        [UnityTest]
        public IEnumerator Components_AddedInAnyOrder_NeedNoWiring([Values(0, 1, 2, 3, 4, 5)] int order)
        {
            int first = order % 3, second = (first + 1 + order / 3) % 3, third = 3 - first - second;
            GameObject o = Make("Volume");
            o.AddComponent(Three[first]);
            o.AddComponent(Three[second]);
            o.AddComponent(Three[third]);
            SegmentedVolume volume = Phantoms.Markers();
            o.GetComponent<VolumeLoader>().SetVolume(volume);
            yield return null;
            CarvedPicture picture = o.GetComponent<CarvedVolumeRenderer>().Render(FrontView(volume));
            Assert.That(Count(picture.Read(), Phantoms.Anterior), Is.GreaterThan(0));
            Assert.That(o.GetComponent<ClipSphereStack>().Carving.SegmentCount, Is.EqualTo(volume.Segments.Count));
        }

        [Test]
        public void Render_WithoutAStack_ShowsTheWholeVolume()
        {
            GameObject o = Make("Volume", typeof(VolumeLoader), typeof(CarvedVolumeRenderer));
            SegmentedVolume volume = Phantoms.Markers();
            o.GetComponent<VolumeLoader>().SetVolume(volume);
            Assert.That(Count(o.GetComponent<CarvedVolumeRenderer>().Render(FrontView(volume)).Read(), Phantoms.Left), Is.GreaterThan(0));
        }

        [Test]
        public void Render_WithoutAVolume_GivesNoPicture()
        {
            var renderer = Make("Volume").AddComponent<CarvedVolumeRenderer>();
            Assert.That(renderer.Render(FrontView(Phantoms.Cube(8, "Cube"))), Is.Null);
        }

        [Test]
        public void Render_OfADisabledRenderer_GivesNoPicture()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.enabled = false;
            Assert.That(renderer.Render(FrontView(renderer.Volume)), Is.Null);
        }

        [UnityTest]
        public IEnumerator Renderer_DisabledAndEnabled_ShowsTheSame()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Stack.SetActive(new Vector3(0f, 0f, -0.014f), 0.003f);
            PictureData before = renderer.Render(FrontView(renderer.Volume)).Read();
            renderer.enabled = false;
            yield return null;
            renderer.enabled = true;
            AssertSamePicture(before, renderer.Render(FrontView(renderer.Volume)).Read());
        }

        [UnityTest]
        public IEnumerator Renderer_Disabled_FreesItsTextures()
        {
            int before = CountGpuObjects();
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Render(FrontView(renderer.Volume));
            Assert.That(CountGpuObjects(), Is.GreaterThan(before));
            renderer.enabled = false;
            yield return null;
            Assert.That(CountGpuObjects(), Is.EqualTo(before));
            Assert.That(renderer.Statistics.BytesResident, Is.Zero);
        }

        [UnityTest]
        public IEnumerator GameObject_Destroyed_FreesItsTextures()
        {
            int before = CountGpuObjects();
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Render(MakeCamera(new Vector3(0f, 0f, -0.08f), Vector3.up), 16, 16);
            Object.Destroy(renderer.gameObject);
            yield return null;
            yield return null;
            Assert.That(CountGpuObjects(), Is.EqualTo(before));
        }

        [UnityTest]
        public IEnumerator Components_ThatAreDisabled_HoldNoVolumeThatWasUnloaded()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Cube(8, "Cube"));
            WeakReference volume = UseAndUnload(renderer);
            for (int frame = 0; frame < 5 && volume.IsAlive; frame++)
            {
                yield return null;
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
            if (IsExact(GC.MaxGeneration))
                Assert.That(volume.IsAlive, Is.False);
            Assert.That(renderer.Stack.Carving, Is.Null);
        }

        [MethodImpl(MethodImplOptions.NoInlining)] // so that no variable of the caller holds the volume
        static WeakReference UseAndUnload(CarvedVolumeRenderer renderer)
        {
            renderer.Segments = renderer.Volume.Segments.WithOpacity(1, 0.5f);
            renderer.Stack.SetActive(Vector3.zero, 0.002f);
            renderer.Render(FrontView(renderer.Volume));
            Assert.That(renderer.Field, Is.Not.Null);
            renderer.Stack.enabled = renderer.enabled = false;
            var volume = new WeakReference(renderer.Volume);
            renderer.Loader.Unload();
            return volume;
        }

        /// <summary>Unity's collector (one generation) is conservative: an old word on the stack may hold the volume.</summary>
        static bool IsExact(int generations) => generations > 0;

        [UnityTest]
        public IEnumerator Volume_Unloaded_FreesItsTextures()
        {
            int before = CountGpuObjects();
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Render(FrontView(renderer.Volume));
            renderer.Loader.Unload();
            yield return null;
            yield return null;
            Assert.That(CountGpuObjects(), Is.EqualTo(before));
        }

        [Test]
        public void Volume_Replaced_IsShown()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Render(FrontView(renderer.Volume));
            SegmentedVolume cube = Phantoms.Cube(24, "Cube");
            renderer.Loader.SetVolume(cube);
            PictureData picture = renderer.Render(FrontView(cube)).Read();
            Assert.That(Count(picture, 1), Is.GreaterThan(100));
            Assert.That(renderer.Segments, Is.SameAs(cube.Segments));
        }

        [Test]
        public void RenderTextures_LostByTheDevice_AreFilledAgain()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            PictureData before = renderer.Render(FrontView(renderer.Volume)).Read();
            foreach (RenderTexture texture in Resources.FindObjectsOfTypeAll<RenderTexture>())
                if (texture.name.StartsWith("AnatomyCarve", StringComparison.Ordinal))
                    texture.Release();
            AssertSamePicture(before, renderer.Render(FrontView(renderer.Volume)).Read());
        }

        [Test]
        public void Textures_DestroyedBySomebodyElse_AreMadeAgain()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            PictureData before = renderer.Render(FrontView(renderer.Volume)).Read();
            foreach (Texture texture in Resources.FindObjectsOfTypeAll<Texture>())
                if (texture.name.StartsWith("AnatomyCarve", StringComparison.Ordinal))
                    Object.DestroyImmediate(texture);
            AssertSamePicture(before, renderer.Render(FrontView(renderer.Volume)).Read());
        }

        [Test]
        public void Resources_Resident_AreListedByName()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.Render(FrontView(renderer.Volume));
            Assert.That(renderer.Statistics.BytesResident, Is.GreaterThan(7L * renderer.Volume.Geometry.VoxelCount),
                "intensity 2, labels 1, opacities 2, normals 2 bytes a voxel");
            foreach (ResourceSize resource in renderer.Statistics.Resources)
                Assert.That(resource.Name, Does.StartWith("AnatomyCarve"));
        }
    }
}
