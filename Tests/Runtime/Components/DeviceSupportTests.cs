using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>Which sizes of volumes a device takes. Nothing is made here.</summary>
    sealed class DeviceSupportTests
    {
        static int Largest => Mathf.Min(SystemInfo.maxTexture3DSize, DeviceSupport.MaxVolumeSize);

        [Test]
        public void Size_OfTheDevicesTextures_IsAccepted_AndOneMoreIsNot([Values(0, 1, 2)] int axis)
        {
            Assert.That(Missing(axis, Largest), Is.Null);
            Assert.That(Missing(axis, Largest + 1), Does.Contain($"{Largest + 1}").And.Contain($"allows {Largest} along an axis"));
        }

        [Test]
        public void Voxels_OfMoreThanATextureHolds_AreRefused()
        {
            Assert.That(Missing(1024, 1024, 1023), Is.Null);
            Assert.That(Missing(1024, 1024, 1024), Does.Contain("1024 x 1024 x 1024").And.Contain("of them at most"));
        }

        static string Missing(int axis, int size) => Missing(axis == 0 ? size : 2, axis == 1 ? size : 2, axis == 2 ? size : 2);

        static string Missing(int i, int j, int k) => DeviceSupport.Missing(new VolumeGeometry(i, j, k, Affine.Identity), TextureLayout.Portable);
    }
}
