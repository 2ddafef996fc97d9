using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>The package's prefab of a volume.</summary>
    public sealed class CarvedVolumePrefabTests
    {
        const string Path = "Runtime/Prefabs/CarvedVolume.prefab";

        UnityHost m_Host;

        [SetUp]
        public void StartHost() => m_Host = UnityHost.Start();

        [TearDown]
        public void EndHost() => m_Host.Dispose();

        [Test]
        public void Prefab_HasAllThatAVolumeNeeds() => Assert.That(
            m_Host.InstantiatePrefab(Path).GetComponents<Component>().Select(c => c.GetType()),
            Is.EquivalentTo(new[]
            {
                typeof(Transform), typeof(MeshFilter), typeof(MeshRenderer), typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer),
            }));

        [Test]
        public void Components_OfAnInstance_AreWiredToEachOther()
        {
            GameObject volume = m_Host.InstantiatePrefab(Path);
            var renderer = volume.GetComponent<CarvedVolumeRenderer>();
            Assert.That(renderer.Loader, Is.SameAs(volume.GetComponent<VolumeLoader>()));
            Assert.That(renderer.Stack, Is.SameAs(volume.GetComponent<ClipSphereStack>()));
            Assert.That(renderer.Stack.Loader, Is.SameAs(renderer.Loader));
        }

        /// <summary>What the prefab's file does not say is as the scripts have it.</summary>
        [Test]
        public void Settings_OfAnInstance_AreThoseOfNewComponents()
        {
            var instance = m_Host.InstantiatePrefab(Path).GetComponent<CarvedVolumeRenderer>();
            var made = new GameObject("made", typeof(VolumeLoader), typeof(ClipSphereStack), typeof(CarvedVolumeRenderer)).GetComponent<CarvedVolumeRenderer>();
            Assert.That(instance.Quality.Step, Is.EqualTo(made.Quality.Step));
            Assert.That(instance.DrawInCameras, Is.EqualTo(made.DrawInCameras));
            Assert.That(instance.Layout, Is.EqualTo(made.Layout));
            Assert.That(instance.Appearance.TransferFunction, Is.Null);
            Assert.That(instance.Stack.ActiveRadiusFactor, Is.EqualTo(made.Stack.ActiveRadiusFactor));
            Assert.That(instance.GetComponent<MeshRenderer>().shadowCastingMode, Is.EqualTo(made.GetComponent<MeshRenderer>().shadowCastingMode));
        }
    }
}
