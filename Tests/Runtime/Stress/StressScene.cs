using System;
using System.Collections.Generic;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Tests.Kernels;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>
    /// What tests under extreme conditions share: matter that is defined in voxels, so that it is the same at any spacing, and what must hold of any picture.
    /// </summary>
    abstract class StressScene : PlayModeScene
    {
        /// <summary>One code of 8 bits.</summary>
        protected const float Code = 1f / 255f;

        protected const int SegmentCount = 5;

        readonly HashSet<RenderTexture> former = new HashSet<RenderTexture>();

        protected static readonly VectorMm Superior = new VectorMm(0, 0, 1);

        /// <summary>Semi-transparent outside, opaque inside.</summary>
        protected static OpacityTransferFunction Ramp() => OpacityTransferFunction.Parse("100:0,400:0.4,900:1");

        /// <summary>A grid along the patient's axes.</summary>
        protected static VolumeGeometry Grid(int sizeI, int sizeJ, int sizeK, double spacingI, double spacingJ, double spacingK, PointMm origin = default)
        {
            VectorMm i = new VectorMm(spacingI, 0, 0), j = new VectorMm(0, spacingJ, 0), k = new VectorMm(0, 0, spacingK);
            return new VolumeGeometry(sizeI, sizeJ, sizeK, Affine.FromColumns(i, j, k, origin));
        }

        /// <summary>A soft ball that nearly fills the volume, of four segments and some unlabelled matter in its middle.</summary>
        protected static SegmentedVolume Ball(VolumeGeometry geometry)
        {
            var codes = new ushort[geometry.VoxelCount];
            var indices = new ushort[geometry.VoxelCount];
            int v = 0;
            for (int k = 0; k < geometry.SizeK; k++)
                for (int j = 0; j < geometry.SizeJ; j++)
                    for (int i = 0; i < geometry.SizeI; i++, v++)
                    {
                        double x = (2 * i + 1.0) / geometry.SizeI - 1, y = (2 * j + 1.0) / geometry.SizeJ - 1, z = (2 * k + 1.0) / geometry.SizeK - 1;
                        double fromCentre = Math.Sqrt(x * x + y * y + z * z);
                        codes[v] = (ushort)Math.Max(0, Math.Min(1000, 2500 * (0.95 - fromCentre)));
                        indices[v] = (ushort)(fromCentre < 0.3 ? 0 : 1 + (x < 0 ? 0 : 1) + (z < 0 ? 0 : 2));
                    }
            return Volume(geometry, codes, indices, SegmentCount);
        }

        protected static SegmentedVolume Volume(VolumeGeometry geometry, ushort[] codes, ushort[] indices, int segments)
        {
            var table = new SegmentTable(Enumerable.Range(0, segments).Select(
                s => new Segment(s, s, "segment " + s, new SegmentColor((byte)(40 + 50 * s), (byte)(220 - 40 * s), (byte)(90 * s)))));
            return new SegmentedVolume(new IntensityVolume(geometry, codes, 0, 1, 1000), new LabelMap(geometry, indices, table));
        }

        protected CarvedVolumeRenderer MakeRamp(SegmentedVolume volume)
        {
            CarvedVolumeRenderer renderer = MakeVolume(volume);
            renderer.TransferFunction = Ramp();
            return renderer;
        }

        /// <summary>From the centre of a volume to the middle of a corner's voxel.</summary>
        protected static double Radius(VolumeGeometry geometry) => geometry.CornerOffset(0).Length;

        /// <summary>A sphere in millimetres that is the same in voxels at any spacing: it opens the ball from the viewer's side, but for segment 2.</summary>
        protected static void CutOpen(CarvedVolumeRenderer renderer, VectorMm towardsEye)
        {
            VolumeGeometry geometry = renderer.Volume.Geometry;
            CarvingStack carving = renderer.Stack.Carving;
            carving.SetActive(geometry.CentreLps + 0.35 * Radius(geometry) * towardsEye, 0.25 * Radius(geometry));
            carving.ToggleSegment(2);
        }

        protected static PictureRays Look(VolumeGeometry geometry, VectorMm towardsEye, int pixels = 32) => PictureRays.Perspective(
            geometry.CentreLps + 2.5 * Radius(geometry) * towardsEye, geometry.CentreLps, Superior, 50, pixels, pixels);

        /// <summary>Colours are finite and within an alpha of 1, depth is finite exactly where a segment is seen, and the segment exists.</summary>
        protected static void AssertSane(PictureData picture, int segments, string what)
        {
            for (int p = 0; p < picture.Segments.Length; p++)
            {
                Color c = picture.Color[p];
                bool isFinite = IsFinite(c.r) && IsFinite(c.g) && IsFinite(c.b) && IsFinite(c.a);
                if (!isFinite || c.a < 0 || c.a > 1 || c.r < 0 || c.g < 0 || c.b < 0)
                    Assert.Fail($"{what}: pixel {p} has the colour {c}");
                bool isSeen = picture.Segments[p] != PictureData.NoSegment;
                float depth = picture.DepthMm[p];
                if (isSeen ? !IsFinite(depth) || depth < 0 || picture.Segments[p] >= segments : !float.IsPositiveInfinity(depth))
                    Assert.Fail($"{what}: pixel {p} has the depth {depth} and the segment {picture.Segments[p]}");
            }
        }

        /// <summary>
        /// Opacity of the only volume on the GPU, voxel by voxel, as the CPU says; anti-aliased opacity likewise, but for a code where float rounds to one side
        /// or the other.
        /// </summary>
        /// <returns>Voxels in which something is visible.</returns>
        protected int AssertTexturesAreTheFields(CarvedVolumeRenderer renderer, string what)
        {
            VolumeGeometry geometry = renderer.Volume.Geometry;
            CarvedField field = renderer.Field;
            byte[] opacity = ReadVolume("AnatomyCarve opacity", renderer), smoothed = ReadVolume("AnatomyCarve anti-aliased opacity", renderer);
            int v = 0, wrong = 0, wrongSmoothed = 0, visible = 0;
            for (int k = 0; k < geometry.SizeK; k++)
                for (int j = 0; j < geometry.SizeJ; j++)
                    for (int i = 0; i < geometry.SizeI; i++, v++)
                    {
                        wrong += opacity[v] == field.OpacityCode(i, j, k) ? 0 : 1;
                        wrongSmoothed += Math.Abs(smoothed[v] - field.AntiAliasedCode(i, j, k)) <= 1 ? 0 : 1;
                        visible += opacity[v] > 0 ? 1 : 0;
                    }
            Assert.That(wrong, Is.Zero, "opacities, " + what);
            Assert.That(wrongSmoothed, Is.Zero, "anti-aliased opacities, " + what);
            return visible;
        }

        /// <summary>The largest difference of a colour's component.</summary>
        protected static float WorstColor(PictureData a, PictureData b)
        {
            float worst = 0;
            for (int p = 0; p < a.Color.Length; p++)
            {
                Color difference = a.Color[p] - b.Color[p];
                for (int channel = 0; channel < 4; channel++)
                    worst = Math.Max(worst, Math.Abs(difference[channel]));
            }
            return worst;
        }

        /// <summary>The same bits; the message says which pixel differs first, and how.</summary>
        protected static void AssertIdentical(PictureData expected, PictureData actual, string what)
        {
            int different = 0;
            string first = "";
            for (int p = 0; p < expected.Color.Length; p++)
                if (!expected.Color[p].Equals(actual.Color[p]) || !expected.DepthMm[p].Equals(actual.DepthMm[p]) || expected.Segments[p] != actual.Segments[p])
                    first = different++ > 0 ? first : FormattableString.Invariant($"{p}: {Describe(expected, p)} became {Describe(actual, p)}");
            Assert.That(different, Is.Zero, $"pixels, {what}; {first}");
        }

        static string Describe(PictureData picture, int p)
        {
            Color c = picture.Color[p];
            return FormattableString.Invariant($"({c.r:g6} {c.g:g6} {c.b:g6} {c.a:g6}), {picture.DepthMm[p]:r} mm, segment {picture.Segments[p]}");
        }

        protected static int CountSeen(PictureData picture) => picture.Segments.Count(segment => segment != PictureData.NoSegment);

        protected static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);

        /// <summary>What is on the GPU now goes with the frame's end; tests that last no frame no longer look at it.</summary>
        protected void LeaveTextures() => former.UnionWith(Resources.FindObjectsOfTypeAll<RenderTexture>());

        /// <summary>The renderer's volumes on the GPU, in the order of their names.</summary>
        protected RenderTexture[] VolumeTextures() => Resources.FindObjectsOfTypeAll<RenderTexture>()
            .Where(texture => texture.dimension == TextureDimension.Tex3D && texture.IsCreated() && !former.Contains(texture))
            .OrderBy(texture => texture.name, StringComparer.Ordinal).ToArray();

        byte[] ReadVolume(string name, CarvedVolumeRenderer renderer) =>
            StoredVoxels.Whole(KernelRig.Read<byte>(VolumeTextures().Single(texture => texture.name == name)), renderer);
    }
}
