using System;
using System.Collections;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Desktop.Tests
{
    /// <summary>The active sphere in world space, and the box of its volume.</summary>
    sealed class WorldSphereTests : DesktopScene
    {
        [Test]
        public void Sphere_WithoutAVolume_IsNone()
        {
            Assert.That(WorldSphere.TryGet(null, out _), Is.False);
            Assert.That(WorldSphere.TryGet(Make("Empty", typeof(VolumeLoader), typeof(ClipSphereStack)).GetComponent<ClipSphereStack>(), out _), Is.False);
        }

        [Test]
        public void Sphere_InAVolumeOfScaleZero_IsNone()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            volume.transform.localScale = new Vector3(1f, 0f, 1f);
            Assert.That(WorldSphere.TryGet(volume.Stack, out _), Is.False);
        }

        [Test]
        public void MoveTo_InATurnedAndScaledVolume_LiesThere_AndKeepsItsRadius()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            volume.transform.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(20f, 130f, -40f));
            volume.transform.localScale = new Vector3(2f, 2f, 2f);
            Vector3 place = volume.transform.TransformPoint(new Vector3(0.01f, -0.005f, 0.008f));
            WorldSphere sphere = Of(volume);
            Assert.That(sphere.Exists, Is.False);
            Assert.That(Vector3.Distance(sphere.Centre, volume.transform.position), Is.LessThan(1e-6f));
            sphere.MoveTo(place);
            Assert.That(sphere.Exists, Is.True);
            Assert.That(Vector3.Distance(sphere.Centre, place), Is.LessThan(1e-6f));
            Assert.That(sphere.Radius, Is.EqualTo(2f * 0.04f / 6f).Within(1e-6f));
            double radius = sphere.Carving.Active.RadiusMm;
            for (int n = 0; n < 100; n++)
                sphere.MoveTo(place + new Vector3(0.0001f * n, 0f, 0f));
            Assert.That(sphere.Carving.Active.RadiusMm, Is.EqualTo(radius), "moving rounds nothing");
        }

        [Test]
        public void Scale_BackAndForth_KeepsTheCentre_AndTheLimits()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            WorldSphere sphere = Of(volume);
            sphere.MoveTo(new Vector3(0.003f, 0.004f, 0.005f));
            PointMm centre = sphere.Carving.Active.CentreLps;
            sphere.Scale(1e-9);
            Assert.That(sphere.Carving.Active.RadiusMm, Is.EqualTo(WorldSphere.SmallestRadiusMm));
            sphere.Scale(1e9);
            Assert.That(sphere.Carving.Active.RadiusMm, Is.EqualTo(40 * Math.Sqrt(3)).Within(1e-9), "covers the volume from any corner");
            Assert.That(sphere.Carving.Active.CentreLps, Is.EqualTo(centre));
        }

        [Test]
        public void Scale_WithoutASphere_MakesOneInTheMiddle()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            Of(volume).Scale(1);
            Assert.That(volume.Stack.Carving.Active.CentreLps, Is.EqualTo(volume.Volume.Geometry.CentreLps));
            Assert.That(volume.Stack.Carving.Active.RadiusMm, Is.EqualTo(40 / 6.0).Within(1e-9));
        }

        [TestCase(0f, 0f, true, 0.19f)]
        [TestCase(0.009f, 0f, true, 0.1956f)]
        [TestCase(0.011f, 0f, false, 0f)]
        public void TryEnter_ARay_FindsWhereItMeetsTheSphere(float x, float y, bool meets, float distance)
        {
            CarvedVolumeRenderer volume = MakeVolume();
            volume.Stack.SetActive(Vector3.zero, 0.01f);
            Assert.That(Of(volume).TryEnter(new Ray(new Vector3(x, y, -0.2f), Vector3.forward), out float found), Is.EqualTo(meets));
            if (meets)
                Assert.That(found, Is.EqualTo(distance).Within(1e-4f));
        }

        [Test]
        public void TryEnter_FromInsideOrFromBehind_IsZeroOrNone()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            volume.Stack.SetActive(Vector3.zero, 0.01f);
            Assert.That(Of(volume).TryEnter(new Ray(new Vector3(0f, 0f, 0.005f), Vector3.forward), out float found), Is.True);
            Assert.That(found, Is.Zero);
            Assert.That(Of(volume).TryEnter(new Ray(new Vector3(0f, 0f, 0.2f), Vector3.forward), out _), Is.False);
        }

        [Test]
        public void Bounds_OfAVolume_HoldItsOuterCorners()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            Bounds bounds = VolumeBounds.Of(volume.Loader);
            Assert.That(Vector3.Distance(bounds.size, new Vector3(0.04f, 0.04f, 0.04f)), Is.LessThan(1e-6f));
            Assert.That(bounds.center.magnitude, Is.LessThan(1e-6f));
            volume.transform.SetPositionAndRotation(new Vector3(1f, 0f, 0f), Quaternion.Euler(0f, 45f, 0f));
            bounds = VolumeBounds.Of(volume.Loader);
            Assert.That(bounds.size.x, Is.EqualTo(0.04f * Mathf.Sqrt(2f)).Within(1e-5f));
            Assert.That(bounds.size.y, Is.EqualTo(0.04f).Within(1e-5f));
            Assert.That(bounds.center.x, Is.EqualTo(1f).Within(1e-5f));
        }

        [Test]
        public void Bounds_OfNothing_AreRefused()
        {
            Assert.That(() => VolumeBounds.Of(null), Throws.ArgumentNullException);
            VolumeLoader empty = Make("Empty").AddComponent<VolumeLoader>();
            Assert.That(() => VolumeBounds.Of(empty), Throws.InvalidOperationException.With.Message.Contains("Empty"));
        }

        [UnityTest]
        public IEnumerator View_ThatFramesAVolume_ShowsAllOfIt()
        {
            CarvedVolumeRenderer volume = MakeVolume();
            Camera camera = MakeCamera();
            OrbitView view = Add<OrbitView>(camera.gameObject, v =>
            {
                v.Controls = Controls;
                v.Target = volume.transform;
                v.SmoothTime = 0f;
            });
            view.Frame(VolumeBounds.Of(volume.Loader));
            yield return Pass();
            PictureData picture = volume.Render(camera, 64, Mathf.RoundToInt(64 / camera.aspect)).Read();
            int seen = 0, atTheRim = 0;
            for (int p = 0; p < picture.Segments.Length; p++)
            {
                int x = p % picture.Width, y = p / picture.Width;
                bool shows = picture.DepthMm[p] < float.PositiveInfinity;
                seen += shows ? 1 : 0;
                atTheRim += shows && (x == 0 || y == 0 || x == picture.Width - 1 || y == picture.Height - 1) ? 1 : 0;
            }
            Assert.That(seen, Is.GreaterThan(100));
            Assert.That(atTheRim, Is.Zero);
        }

        static WorldSphere Of(CarvedVolumeRenderer volume)
        {
            Assert.That(WorldSphere.TryGet(volume.Stack, out WorldSphere sphere), Is.True);
            return sphere;
        }
    }
}
