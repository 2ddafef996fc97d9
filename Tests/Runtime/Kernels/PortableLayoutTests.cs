using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using Random = System.Random;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>Every kernel in the portable layout against itself in the compact one: the same bytes, the same pictures.</summary>
    public sealed class PortableLayoutTests
    {
        /// <summary>Devices round code / 255 differently when they read an 8-bit texture: 6e-8 was seen in a colour, nothing in depths.</summary>
        const float ColorRounding = 1e-5f, DepthRounding = 1e-4f;

        /// <summary>Sizes along k that end in each part of a texel, and one that ends a brick.</summary>
        static readonly int[] Depths = { 1, 2, 3, 4, 5, 8, 17, 22 };

        [Test]
        public void ClipVoxels_PortableLayout_WritesTheSameOpacities([ValueSource(nameof(Depths))] int depth, [Values(false, true)] bool smooth)
        {
            var random = new Random(depth);
            CarveScene carve = CarveScene.Opaque(KernelGrid.Aligned(13, 9, depth, 1, 0.7, 1.9), 7, random);
            carve.MakeTranslucent(random);
            carve.SmoothCut = smooth;
            for (int s = 0; s < 5; s++)
                carve.AddRandomSphere(random);
            byte[] Run(bool portable)
            {
                using (KernelRig rig = KernelRig.ClipVoxels(portable))
                {
                    carve.Bind(rig);
                    return Written(rig, "_OpacityOut", carve.Grid, 1);
                }
            }
            byte[] compact = Run(false);
            Assert.That(compact, Has.Some.GreaterThan(0), "the scene is not empty");
            Assert.That(Run(true), Is.EqualTo(compact));
        }

        [Test]
        public void AntiAlias_PortableLayout_WritesTheSameOpacities([ValueSource(nameof(Depths))] int depth)
        {
            var random = new Random(depth);
            KernelGrid grid = KernelGrid.Aligned(13, 9, depth);
            byte[] codes = OpacityFields.Balls(grid, random);
            byte[] Run(bool portable)
            {
                using (KernelRig rig = KernelRig.AntiAlias(portable))
                {
                    rig.Set(grid);
                    rig.Set("_AntiAlias", new Vector4(0.0625f, 0.125f, 0.06f, 1f));
                    rig.SetOpacities("_Opacity", grid, codes);
                    return Written(rig, "_OpacityAAOut", grid, 1);
                }
            }
            byte[] compact = Run(false);
            Assert.That(compact, Has.Some.GreaterThan(0), "the field is not empty");
            Assert.That(Run(true), Is.EqualTo(compact));
        }

        [Test]
        public void SobelNormals_PortableLayout_WritesTheSameCodes([ValueSource(nameof(Depths))] int depth)
        {
            var random = new Random(depth);
            KernelGrid grid = KernelGrid.Aligned(13, 9, depth, 1, 2, 0.5);
            byte[] codes = OpacityFields.Balls(grid, random);
            byte[] Run(bool portable)
            {
                using (KernelRig rig = KernelRig.SobelNormals(portable))
                {
                    rig.Set(grid);
                    rig.SetUncarved(grid);
                    rig.SetOpacities("_OpacityAA", grid, codes);
                    return Written(rig, "_NormalsOut", grid, 2);
                }
            }
            byte[] compact = Run(false);
            Assert.That(compact, Has.Some.GreaterThan(0), "the field is not empty");
            Assert.That(Run(true), Is.EqualTo(compact));
        }

        [Test]
        public void Raymarch_PortableLayout_MakesTheSamePicture([Values(1, 2, 3, 4)] int seed)
        {
            var random = new Random(seed);
            RayScene scene = RayScene.Random(KernelGrid.Random(random, 8, 30), random);
            double size = scene.Grid.ReferenceMm * 40;
            scene.LookFrom(RayScene.Scale(RayScene.RandomDirection(random), size), new double[3], 0.6, 1, random);
            RayPicture compact = RayPicture.Render(scene, GraphicsFormat.R8_UNorm);
            RayPicture portable = RayPicture.Render(scene, GraphicsFormat.R32_UInt);
            Assert.That(compact.Segments, Has.Some.Not.EqualTo(RayScene.NoSegment), "something is seen");
            Assert.That(portable.Segments, Is.EqualTo(compact.Segments));
            for (int p = 0; p < compact.Colors.Length; p++)
            {
                Assert.That(portable.DepthsMm[p], Is.EqualTo(compact.DepthsMm[p]).Within(DepthRounding), "depth of pixel " + p);
                Assert.That((portable.Colors[p] - compact.Colors[p]).magnitude, Is.LessThan(ColorRounding), "colour of pixel " + p);
            }
        }

        [Test]
        public void Raymarch_PortableLayout_HasNoHardwareFilter()
        {
            var random = new Random(9);
            RayScene scene = RayScene.Random(KernelGrid.Aligned(20, 20, 20), random);
            scene.LookFrom(new double[] { 50, 20, 30 }, new double[3], 0.3, 1, random);
            RayPicture exact = RayPicture.Render(scene, GraphicsFormat.R32_UInt);
            scene.Filter = OpacityFilter.Hardware;
            Assert.That(RayPicture.Render(scene, GraphicsFormat.R32_UInt).Colors, Is.EqualTo(exact.Colors));
        }

        static byte[] Written(KernelRig rig, string name, KernelGrid grid, int bytesPerVoxel)
        {
            RenderTexture target = rig.BytesTarget(name, grid, bytesPerVoxel);
            rig.DispatchBricks(grid);
            return rig.ReadBytes(target, grid, bytesPerVoxel);
        }
    }
}
