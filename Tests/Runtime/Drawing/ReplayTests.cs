using System;
using System.Collections;
using System.Collections.Generic;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Drawing
{
    /// <summary>Pictures do not depend on what happened before: objects lost, components switched off and on, volumes loaded and unloaded.</summary>
    sealed class ReplayTests : DrawnScene
    {
        const int Cycles = 100;

        static readonly Type[] Kinds = { typeof(Texture3D), typeof(RenderTexture), typeof(Texture2D), typeof(Material), typeof(Mesh) };

        [Test]
        public void GpuObjects_OfOneKindDestroyed_AreMadeAgain([ValueSource(nameof(Kinds))] Type kind)
        {
            Camera camera = MakeCarved(out CarvedVolumeRenderer renderer);
            Color[] before = Draw(camera);
            int destroyed = DestroyOwned(kind);
            Assert.That(destroyed, Is.GreaterThan(0), "the renderer has such objects");
            Assert.That(Draw(camera), Is.EqualTo(before));
            Assert.That(renderer.Problem, Is.Null);
        }

        [Test]
        public void GpuObjects_AllDestroyed_AreMadeAgain()
        {
            Camera camera = MakeCarved(out _);
            Color[] before = Draw(camera);
            foreach (Type kind in Kinds)
                DestroyOwned(kind);
            Assert.That(Draw(camera), Is.EqualTo(before));
        }

        [Test]
        public void RenderTextures_LostByTheDevice_AreFilledAgain()
        {
            Camera camera = MakeCarved(out _);
            Color[] before = Draw(camera);
            foreach (RenderTexture texture in Owned(typeof(RenderTexture)))
                texture.Release();
            Assert.That(Draw(camera), Is.EqualTo(before));
        }

        [UnityTest]
        public IEnumerator Components_SwitchedOffAndOn_DrawTheSame([Values("renderer", "stack", "loader", "object")] string what)
        {
            Camera camera = MakeCarved(out CarvedVolumeRenderer renderer);
            Color[] before = Draw(camera);
            void Switch(bool on)
            {
                switch (what)
                {
                    case "renderer": renderer.enabled = on; break;
                    case "stack": renderer.Stack.enabled = on; break;
                    case "loader": renderer.Loader.enabled = on; break;
                    default: renderer.gameObject.SetActive(on); break;
                }
            }
            Switch(false);
            yield return null;
            Switch(true);
            yield return null;
            Assert.That(Draw(camera), Is.EqualTo(before));
        }

        [UnityTest]
        public IEnumerator Volumes_LoadedCarvedAndUnloaded_LeaveNothing()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(16));
            renderer.Loader.Unload();
            Camera camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up, 16, 16);
            var counts = new Dictionary<Type, int>();
            for (int cycle = 0; cycle < Cycles; cycle++)
            {
                renderer.Loader.SetVolume(Phantoms.Markers(16 + cycle % 3));
                renderer.Stack.SetActive(new Vector3(0f, 0f, -0.014f), 0.006f);
                renderer.Stack.FixActive();
                Draw(camera);
                renderer.Render(camera);
                renderer.Loader.Unload();
                yield return null; // the renderer lets go in LateUpdate
                yield return null;
                if (cycle == 0)
                    foreach (Type kind in Kinds)
                        counts[kind] = Owned(kind).Count;
            }
            Assert.That(renderer.Statistics.BytesResident, Is.Zero);
            foreach (Type kind in Kinds)
            {
                Assert.That(Owned(kind).Count, Is.EqualTo(counts[kind]), kind.Name);
                Assert.That(counts[kind], Is.Zero, kind.Name);
            }
        }

        Camera MakeCarved(out CarvedVolumeRenderer renderer)
        {
            renderer = MakeVolume(Phantoms.Markers());
            renderer.Stack.SetActive(new Vector3(0f, 0.002f, -0.014f), 0.004f);
            renderer.Stack.FixActive();
            renderer.Segments = renderer.Volume.Segments.WithOpacity(Phantoms.Left, 0.3f);
            return MakeDrawingCamera(new Vector3(0.02f, 0.03f, -0.07f), Vector3.up);
        }

        /// <summary>Objects that the package made: their names say so.</summary>
        static List<Object> Owned(Type kind)
        {
            var owned = new List<Object>();
            foreach (Object o in Resources.FindObjectsOfTypeAll(kind))
                if (o.name.StartsWith("AnatomyCarve ", StringComparison.Ordinal))
                    owned.Add(o);
            return owned;
        }

        static int DestroyOwned(Type kind)
        {
            List<Object> owned = Owned(kind);
            foreach (Object o in owned)
                Object.DestroyImmediate(o);
            return owned.Count;
        }
    }
}
