using System;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Tests.Kernels;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine.Experimental.Rendering;
using Random = System.Random;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>
    /// The same volume, carving and rays twice: the same bytes in every volume on the GPU and the same picture. Other numbers of threads: Headless~/Tests.
    /// </summary>
    sealed class DeterminismTests : StressScene
    {
        [Test]
        public void VolumesAndPicture_MadeTwice_AreTheSameBytes([Values(1, 2, 3, 4)] int seed, [Values] CutMode cut)
        {
            var random = new Random(seed);
            CarvedVolumeRenderer renderer = MakeRamp(RandomMatter.Volume(random, SegmentCount, 14, 34));
            renderer.Quality = new RenderQuality { CutMode = cut };
            CutOpen(renderer, new VectorMm(0, -1, 0));
            PictureRays rays = RandomMatter.Rays(renderer.Volume.Geometry, random, 48);
            PictureData first = renderer.Render(rays).Read();
            byte[][] volumes = Volumes();
            LeaveTextures();
            renderer.ReleaseResources();
            PictureData second = renderer.Render(rays).Read();
            byte[][] again = Volumes();
            AssertSamePicture(first, second);
            Assert.That(CountSeen(first), Is.GreaterThan(0));
            Assert.That(volumes.Length, Is.GreaterThanOrEqualTo(4), "opacity, anti-aliased opacity, normals, skip map");
            Assert.That(again.Length, Is.EqualTo(volumes.Length));
            for (int n = 0; n < volumes.Length; n++)
                Assert.That(volumes[n].SequenceEqual(again[n]), "volume " + n);
        }

        byte[][] Volumes() => VolumeTextures().Select(texture => texture.graphicsFormat == GraphicsFormat.R32_UInt
            ? KernelRig.Read<uint>(texture).SelectMany(BitConverter.GetBytes).ToArray() : KernelRig.Read<byte>(texture)).ToArray();
    }
}
