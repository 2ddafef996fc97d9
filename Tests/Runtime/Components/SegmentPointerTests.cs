using System.Collections;
using System.Collections.Generic;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>The pointer finds what the picture shows, and works on the active sphere's mask.</summary>
    sealed class SegmentPointerTests : PlayModeScene
    {
        static readonly string[] TransferFunctions = { "400:0,600:1", "0:0.004,1000:0.15", "0:0,1000:0.4" };

        [Test]
        public void Point_AlongThePicturesRays_FindsWhatThePictureShows([Values(0, 1, 2)] int view, [ValueSource(nameof(TransferFunctions))] string transferFunction)
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.TransferFunction = OpacityTransferFunction.Parse(transferFunction);
            Transform volume = renderer.transform;
            volume.position = new Vector3(0.1f, -0.2f, 0.3f);
            volume.rotation = Quaternion.Euler(10f, 20f, 30f);
            volume.localScale = new Vector3(2f, 2f, 2f);
            renderer.Stack.SetActive(volume.TransformPoint(new Vector3(0f, 0.003f, -0.01f)), 0.012f);
            renderer.Stack.ToggleSegment(Phantoms.Body);
            SegmentPointer pointer = Make("Pointer").AddComponent<SegmentPointer>();
            pointer.Target = renderer;
            PictureRays rays = View(renderer.Volume, view);
            var tally = new RayTally(renderer.Field, renderer.RaySettings);
            tally.Compare(renderer.Render(rays).Read(), rays, ray => pointer.Point(WorldRay(renderer, ray)));
            TestContext.WriteLine(tally);
            Assert.That(tally.Hits, Is.GreaterThan(50));
            Assert.That(tally.Wrong, Is.EqualTo(0), tally.ToString());
            Assert.That(tally.Undecided, Is.LessThanOrEqualTo(0.01 * tally.Rays), tally + "; observed: 0");
            Assert.That(tally.WorstDepthMm, Is.LessThanOrEqualTo(0.01), tally + "; observed: 0.002");
        }

        [UnityTest]
        public IEnumerator Pointer_EachFrame_PointsAlongItsForwardAxis()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            SegmentPointer pointer = Make("Pointer").AddComponent<SegmentPointer>();
            pointer.Target = renderer;
            pointer.transform.position = new Vector3(0f, 0f, -0.1f);
            var changes = new List<int>();
            pointer.Changed += hit => changes.Add(hit.Segment);
            yield return null;
            yield return null;
            Assert.That(pointer.Current.Segment, Is.EqualTo(Phantoms.Anterior));
            Assert.That(pointer.CurrentSegment.Name, Is.EqualTo("Anterior"));
            Assert.That(pointer.CurrentPosition.z, Is.EqualTo(-0.018f).Within(0.001f));
            pointer.transform.rotation = Quaternion.LookRotation(Vector3.back);
            yield return null;
            yield return null;
            Assert.That(pointer.Current.Hit, Is.False);
            Assert.That(changes, Is.EqualTo(new[] { Phantoms.Anterior, -1 }));
        }

        [Test]
        public void Toggle_PointedSegment_TurnsRedAndGreen()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            SegmentPointer pointer = Make("Pointer").AddComponent<SegmentPointer>();
            pointer.Target = renderer;
            renderer.Stack.SetActive(new Vector3(1f, 1f, 1f), 0.01f);
            pointer.Point(new Ray(new Vector3(0f, 0f, -0.1f), Vector3.forward));
            Assert.That(pointer.WillBeClipped, Is.True, "a sphere clips all at first");
            Assert.That(pointer.ToggleSegment(), Is.True);
            Assert.That(pointer.WillBeClipped, Is.False);
            Assert.That(renderer.Stack.Carving.Active.Mask[Phantoms.Anterior], Is.False);
            pointer.ResetMask();
            Assert.That(pointer.WillBeClipped, Is.True);
        }

        [Test]
        public void Point_BeyondTheMaximumDistance_FindsNothing()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            renderer.transform.localScale = new Vector3(2f, 2f, 2f);
            SegmentPointer pointer = Make("Pointer").AddComponent<SegmentPointer>();
            pointer.Target = renderer;
            var ray = new Ray(new Vector3(0f, 0f, -1f), Vector3.forward);
            pointer.MaxDistance = 0.95f;
            Assert.That(pointer.Point(ray).Hit, Is.False, "the nearest matter is 0.964 away");
            pointer.MaxDistance = 0.98f;
            Assert.That(pointer.Point(ray).Segment, Is.EqualTo(Phantoms.Anterior));
        }

        [Test]
        public void Point_AfterAnEdit_FindsWhatLiesBehind()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            SegmentPointer pointer = Make("Pointer").AddComponent<SegmentPointer>();
            pointer.Target = renderer;
            var ray = new Ray(new Vector3(0f, 0f, -0.1f), Vector3.forward);
            Assert.That(pointer.Point(ray).Segment, Is.EqualTo(Phantoms.Anterior));
            renderer.Stack.SetActive(new Vector3(0f, 0f, -0.014f), 0.006f);
            Assert.That(pointer.Point(ray).Segment, Is.EqualTo(Phantoms.Body));
        }

        [Test]
        public void Point_AtADisabledRenderer_FindsNothing()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            SegmentPointer pointer = Make("Pointer").AddComponent<SegmentPointer>();
            pointer.Target = renderer;
            var ray = new Ray(new Vector3(0f, 0f, -0.1f), Vector3.forward);
            Assert.That(pointer.Point(ray).Hit, Is.True);
            renderer.enabled = false;
            Assert.That(pointer.Point(ray).Hit, Is.False, "nothing is shown");
        }

        [Test]
        public void Point_WithoutATargetOrVolume_FindsNothing()
        {
            SegmentPointer pointer = Make("Pointer").AddComponent<SegmentPointer>();
            Assert.That(pointer.Point(new Ray(Vector3.zero, Vector3.forward)).Hit, Is.False);
            pointer.Target = Make("Empty").AddComponent<CarvedVolumeRenderer>();
            Assert.That(pointer.Point(new Ray(Vector3.zero, Vector3.forward)).Hit, Is.False);
            Assert.That(pointer.ToggleSegment(), Is.False);
        }

        static PictureRays View(SegmentedVolume volume, int view)
        {
            PointMm centre = volume.Geometry.CentreLps;
            switch (view)
            {
                case 0: return FrontView(volume, 40);
                case 1: return PictureRays.Perspective(centre + new VectorMm(50, -40, 60), centre, new VectorMm(0, 0, 1), 45, 40, 32);
                default: return PictureRays.Orthographic(centre + new VectorMm(-60, -10, 5), centre, new VectorMm(0, 0.2, 1), 42, 40, 40);
            }
        }

        static Ray WorldRay(CarvedVolumeRenderer renderer, RayMm ray)
        {
            VolumeGeometry geometry = renderer.Volume.Geometry;
            Vector3 origin = renderer.transform.TransformPoint(VolumeSpace.LpsToLocal(geometry, ray.Origin));
            Vector3 target = renderer.transform.TransformPoint(VolumeSpace.LpsToLocal(geometry, ray.At(100)));
            return new Ray(origin, target - origin);
        }
    }
}
