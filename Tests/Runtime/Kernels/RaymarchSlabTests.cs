using System;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;
using Range = NUnit.Framework.RangeAttribute;

namespace AnatomyCarve.Tests.Kernels
{
    /// <summary>Uniform matter has an analytic result: alpha = 1 - (1 - a)^(length in reference lengths), whatever the step. Observed: within 2e-7.</summary>
    public sealed class RaymarchSlabTests
    {
        static readonly double[] Steps = { 2, 1, 0.7, 0.5, 0.25 };

        [Test]
        public void Raymarch_UniformSlab_HasTheAnalyticAlphaAtEveryStep([Values(0.01f, 0.1f, 0.3f)] float opacity, [Values(0.5, 1, 2)] double spacing)
        {
            KernelGrid grid = KernelGrid.Aligned(9, 9, 9, spacing, spacing * 1.5, spacing * 3);
            double thickness = 9 * 3;
            double expected = 1 - Math.Pow(1 - opacity, thickness);
            foreach (double step in Steps)
            {
                RayScene scene = RayScene.Uniform(grid, opacity, Vector4.one);
                scene.OpaqueAlpha = 1;
                scene.Step = step;
                scene.LookAlong(new double[] { 0, 0, -1 }, new double[] { -1, 0, 0 }, new double[] { 0, 1, 0 }, 3 * spacing, 100);
                foreach (Vector4 color in RayPicture.Render(scene).Colors)
                    Assert.That(color.w, Is.EqualTo(expected).Within(1e-4), "step " + step);
            }
        }

        [Test]
        public void Raymarch_UniformVolumeAtAnAngle_LooksTheSameAtEveryStep([Range(1, 3)] int seed)
        {
            var random = new Random(seed);
            KernelGrid grid = KernelGrid.Random(random, 9, 9);
            double distance = 40 * grid.ReferenceMm;
            double[] eye = RayScene.Scale(RayScene.RandomDirection(random), distance);
            Vector4[] first = null;
            foreach (double step in Steps)
            {
                RayScene scene = RayScene.Uniform(grid, 0.05f, Vector4.one);
                scene.OpaqueAlpha = 1;
                scene.Step = step;
                scene.LookFrom(eye, new double[3], 0.4, 1, new Random(seed));
                Vector4[] colors = RayPicture.Render(scene).Colors;
                first = first ?? colors;
                for (int pixel = 0; pixel < colors.Length; pixel++)
                    Assert.That(colors[pixel].w, Is.EqualTo(first[pixel].w).Within(1e-4), "step " + step + ", seed " + seed);
            }
        }

        [Test]
        public void Raymarch_FirstVisiblePointOfASlab_LiesAtTheAnalyticDepthAtEveryStep()
        {
            const float opacity = 0.1f;
            KernelGrid grid = KernelGrid.Aligned(9, 9, 20);
            double expected = 100 - 10 + Math.Log(0.5) / Math.Log(1 - opacity); // 6.58 mm into the volume, which begins 10 mm before its centre
            foreach (double step in Steps)
            {
                RayScene scene = RayScene.Uniform(grid, opacity, Vector4.one);
                scene.Step = step;
                scene.LookAlong(new double[] { 0, 0, -1 }, new double[] { -1, 0, 0 }, new double[] { 0, 1, 0 }, 5, 100);
                RayPicture picture = RayPicture.Render(scene);
                foreach (float depth in picture.DepthsMm)
                    Assert.That(depth, Is.EqualTo(expected).Within(1e-3), "mm, step " + step);
                Assert.That(picture.Segments, Is.All.EqualTo(0u));
            }
        }

        [Test]
        public void Raymarch_OpaqueMatter_IsSeenAtItsSurface()
        {
            KernelGrid grid = KernelGrid.Aligned(9, 9, 20);
            RayScene scene = RayScene.Uniform(grid, 1, new Vector4(0.5f, 0.25f, 1, 1));
            scene.LookAlong(new double[] { 0, 0, -1 }, new double[] { -1, 0, 0 }, new double[] { 0, 1, 0 }, 5, 100);
            RayPicture picture = RayPicture.Render(scene);
            foreach (float depth in picture.DepthsMm)
                Assert.That(depth, Is.EqualTo(90).Within(1e-4), "mm");
            double specular = scene.Specular; // the light stands behind the viewer, the surface faces both
            foreach (Vector4 color in picture.Colors)
            {
                Assert.That(color.x, Is.EqualTo(0.5 + specular).Within(1e-4));
                Assert.That(color.y, Is.EqualTo(0.25 + specular).Within(1e-4));
                Assert.That(color.w, Is.EqualTo(1));
            }
        }
    }
}
