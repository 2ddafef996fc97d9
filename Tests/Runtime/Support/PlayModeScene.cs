using System;
using System.Collections;
using System.Collections.Generic;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests
{
    /// <summary>A play-mode test's own objects, destroyed when it ends; tests share a scene.</summary>
    abstract class PlayModeScene
    {
        readonly List<Object> made = new List<Object>();

        [UnityTearDown]
        public IEnumerator DestroyObjects()
        {
            foreach (Object o in made)
                if (o != null)
                    Object.Destroy(o);
            made.Clear();
            yield return null; // the objects go
            yield return null; // what they held goes
        }

        protected GameObject Make(string name, params Type[] components)
        {
            var o = new GameObject(name, components);
            made.Add(o);
            return o;
        }

        /// <summary>Has an object destroyed when the test ends.</summary>
        protected T Own<T>(T o) where T : Object
        {
            made.Add(o);
            return o;
        }

        /// <summary>A volume with all three components, shown with a transfer function that makes matter opaque.</summary>
        protected CarvedVolumeRenderer MakeVolume(SegmentedVolume volume)
        {
            GameObject o = Make("Volume", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer));
            o.GetComponent<VolumeLoader>().SetVolume(volume);
            var renderer = o.GetComponent<CarvedVolumeRenderer>();
            renderer.TransferFunction = Opaque();
            return renderer;
        }

        /// <summary>A camera that looks at the origin and renders only when asked.</summary>
        protected Camera MakeCamera(Vector3 position, Vector3 up)
        {
            var camera = Make("Camera").AddComponent<Camera>();
            camera.enabled = false;
            camera.aspect = 1f;
            camera.fieldOfView = 40f;
            camera.nearClipPlane = 0.001f;
            camera.farClipPlane = 10f;
            camera.transform.position = position;
            camera.transform.rotation = Quaternion.LookRotation(-position, up);
            return camera;
        }

        protected static OpacityTransferFunction Opaque() => OpacityTransferFunction.Parse("400:0,600:1");

        /// <summary>A patient who is looked at from the front: the viewer stands at the nose's side.</summary>
        protected static PictureRays FrontView(SegmentedVolume volume, int pixels = 48) => PictureRays.Perspective(
            volume.Geometry.CentreLps + new VectorMm(0, -80, 0), volume.Geometry.CentreLps, new VectorMm(0, 0, 1), 40, pixels, pixels);

        protected static int Count(PictureData picture, int segment)
        {
            int count = 0;
            foreach (ushort s in picture.Segments)
                count += s == segment ? 1 : 0;
            return count;
        }

        /// <summary>The mean pixel of those that show a segment, in pixels from the lower left corner.</summary>
        protected static Vector2 MeanPixel(PictureData picture, int segment)
        {
            Vector2 sum = Vector2.zero;
            int count = 0;
            for (int p = 0; p < picture.Segments.Length; p++)
                if (picture.Segments[p] == segment)
                {
                    sum += new Vector2(p % picture.Width + 0.5f, p / picture.Width + 0.5f);
                    count++;
                }
            Assert.That(count, Is.GreaterThan(0), $"segment {segment} is not in the picture");
            return sum / count;
        }

        protected static void AssertSamePicture(PictureData expected, PictureData actual)
        {
            Assert.That(actual.Segments, Is.EqualTo(expected.Segments), "segments");
            Assert.That(actual.DepthMm, Is.EqualTo(expected.DepthMm), "depth");
            Assert.That(actual.Color, Is.EqualTo(expected.Color), "colour");
        }

        /// <summary>What the package holds on the GPU.</summary>
        protected static int CountGpuObjects()
        {
            int count = 0;
            foreach (Texture texture in Resources.FindObjectsOfTypeAll<Texture>())
                count += texture.name.StartsWith("AnatomyCarve", StringComparison.Ordinal) ? 1 : 0;
            return count;
        }
    }
}
