using System.Collections.Generic;
using AnatomyCarve.Desktop;
using AnatomyCarve.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>What menu entries and drops make.</summary>
    sealed class VolumeObjectsTests
    {
        readonly List<Object> made = new List<Object>();

        [TearDown]
        public void DestroyObjects()
        {
            foreach (Object o in made)
                if (o != null)
                    Object.DestroyImmediate(o);
            made.Clear();
            Selection.activeObject = null;
        }

        [Test]
        public void Volume_OfAnAsset_LoadsItAndHasItsName()
        {
            GameObject volume = Volume(Asset("Head"), null);
            Assert.That(volume.name, Is.EqualTo("Head"));
            Assert.That(volume.activeSelf, Is.True);
            Assert.That(volume.GetComponent<VolumeLoader>().Asset, Is.SameAs(made[0]));
            Assert.That(volume.GetComponent<CarvedVolumeRenderer>().Loader, Is.SameAs(volume.GetComponent<VolumeLoader>()));
            Assert.That(volume.GetComponent<CarvedVolumeRenderer>().Stack, Is.SameAs(volume.GetComponent<ClipSphereStack>()));
            Assert.That(Selection.activeGameObject, Is.SameAs(volume));
        }

        [Test]
        public void Volume_OfNoAsset_IsThereToBeFilled()
        {
            GameObject volume = Volume(null, null);
            Assert.That(volume.name, Is.EqualTo("Carved Volume"));
            Assert.That(volume.GetComponent<VolumeLoader>().Asset == null, Is.True);
        }

        [Test]
        public void Volumes_BelowOneParent_HaveNamesOfTheirOwn()
        {
            GameObject parent = Own(new GameObject("parent"));
            GameObject first = Volume(null, parent), second = Volume(null, parent);
            Assert.That(first.transform.parent, Is.SameAs(parent.transform));
            Assert.That(second.name, Is.Not.EqualTo(first.name));
        }

        [Test]
        public void Volume_ThatIsUndone_IsGone()
        {
            Undo.IncrementCurrentGroup();
            GameObject volume = Volume(null, null);
            Undo.PerformUndo();
            Assert.That(volume == null, Is.True);
        }

        [Test]
        public void Pointer_BelowAVolume_PointsAtIt()
        {
            GameObject volume = Volume(null, null);
            var pointer = Own(VolumeObjects.CreatePointer(volume)).GetComponent<SegmentPointer>();
            Assert.That(pointer.Target, Is.SameAs(volume.GetComponent<CarvedVolumeRenderer>()));
            Assert.That(Selection.activeGameObject, Is.SameAs(pointer.gameObject));
        }

        [Test]
        public void MouseCamera_LooksAtTheVolumeAndHoldsWhatCarvesIt()
        {
            GameObject volume = Volume(null, null);
            volume.transform.position = new Vector3(0.1f, 0.2f, 0.3f);
            GameObject camera = Own(VolumeObjects.CreateMouseCamera(volume.GetComponent<CarvedVolumeRenderer>()));
            Assert.That(camera.GetComponent<OrbitView>().Target, Is.SameAs(volume.transform));
            Assert.That(camera.GetComponent<MouseSphere>().Stack, Is.SameAs(volume.GetComponent<ClipSphereStack>()));
            Assert.That(camera.GetComponent<MouseSphere>().View, Is.SameAs(camera.GetComponent<Camera>()));
            Assert.That(camera.GetComponent<MousePointer>().Pointer.Target, Is.SameAs(volume.GetComponent<CarvedVolumeRenderer>()));
            Vector3 seen = camera.GetComponent<Camera>().WorldToViewportPoint(volume.transform.position);
            Assert.That(((Vector2)seen - new Vector2(0.5f, 0.5f)).magnitude, Is.LessThan(1e-4f), "in the middle of the picture");
            Assert.That(seen.z, Is.GreaterThan(0.1f), "in front");
        }

        [Test]
        public void MouseCamera_WithoutAVolume_IsThereToBeWired() =>
            Assert.That(Own(VolumeObjects.CreateMouseCamera(null)).GetComponent<OrbitView>().Target == null, Is.True);

        GameObject Volume(VolumeAsset asset, GameObject parent) => Own(VolumeObjects.CreateVolume(asset, parent));

        VolumeAsset Asset(string name)
        {
            var asset = ScriptableObject.CreateInstance<VolumeAsset>();
            asset.name = name;
            made.Add(asset);
            return asset;
        }

        GameObject Own(GameObject o)
        {
            made.Add(o);
            return o;
        }
    }
}
