using System;
using System.Linq;
using AnatomyCarve.Carving;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace AnatomyCarve.Tests.Stress
{
    /// <summary>Volumes with unusual contents: constant, without finite numbers, fully opaque or empty, with as many labels as there can be.</summary>
    sealed class ContentTests : StressScene
    {
        static readonly VectorMm TowardsEye = new VectorMm(0.6, -0.7, 0.39).Normalized();

        [Test]
        public void Volume_OfOneIntensity_IsShownAsOpaqueAsItsTransferFunctionSays([Values(0, 500, 65535)] int code, [Values(0, 0.25, 1)] double opacity)
        {
            VolumeGeometry geometry = Grid(12, 11, 10, 1, 1, 1);
            CarvedVolumeRenderer renderer = MakeVolume(Volume(geometry, Constant(geometry, code), new ushort[geometry.VoxelCount], 1));
            renderer.TransferFunction = OpacityTransferFunction.Constant(opacity);
            PictureData picture = renderer.Render(Look(geometry, TowardsEye, 16)).Read();
            AssertSane(picture, 1, "whole");
            Assert.That(AssertTexturesAreTheFields(renderer, "whole"), Is.EqualTo(opacity > 0 ? geometry.VoxelCount : 0));
            float middle = picture.Color[16 * 8 + 8].a;
            Assert.That(middle, opacity == 0 ? Is.Zero : Is.GreaterThan(0.9f));
            renderer.Stack.Carving.SetActive(geometry.CentreLps, 3);
            AssertSane(renderer.Render(Look(geometry, TowardsEye, 16)).Read(), 1, "carved");
            AssertTexturesAreTheFields(renderer, "carved");
        }

        [Test]
        public void Volume_WithItsAutomaticTransferFunction_IsSaneWhateverItsFloats(
            [Values(float.NaN, float.PositiveInfinity, float.NegativeInfinity, float.MaxValue, -0f, float.Epsilon)] float odd,
            [Values(0.02, 0.5, 1)] double share)
        {
            var random = new Random(3);
            VolumeGeometry geometry = Grid(14, 13, 12, 1, 1, 1);
            SegmentedVolume ball = Ball(geometry);
            float[] floats = ball.Intensity.Codes.Select(code => random.NextDouble() < share ? odd : code).ToArray();
            var volume = new SegmentedVolume(IntensityVolume.FromVolumeData(new VolumeData(geometry, floats)), ball.Labels);
            CarvedVolumeRenderer renderer = MakeVolume(volume);
            renderer.TransferFunction = null;
            CutOpen(renderer, TowardsEye);
            AssertSane(renderer.Render(Look(geometry, TowardsEye, 16)).Read(), SegmentCount, "automatic");
            AssertTexturesAreTheFields(renderer, "automatic");
            renderer.TransferFunction = Ramp();
            AssertSane(renderer.Render(Look(geometry, TowardsEye, 16)).Read(), SegmentCount, "ramp");
            AssertTexturesAreTheFields(renderer, "ramp");
        }

        [Test]
        public void Segments_OfOpacityZeroOrOne_AreHiddenOrShownWhole(
            [Values("0:1", "0:0", "500:0,500:1", "-1e30:0,1e30:1", "0:0,1e-30:1")] string transferFunction, [Values] CutMode cut)
        {
            CarvedVolumeRenderer renderer = MakeVolume(Ball(Grid(14, 13, 12, 1, 1, 1)));
            renderer.TransferFunction = OpacityTransferFunction.Parse(transferFunction);
            renderer.Quality.CutMode = cut;
            CutOpen(renderer, TowardsEye);
            for (int hidden = 0; hidden <= SegmentCount; hidden++)
            {
                SegmentTable table = renderer.Volume.Segments;
                for (int s = 0; s < hidden; s++)
                    table = table.WithOpacity(s, 0f);
                renderer.Segments = table;
                PictureData picture = renderer.Render(Look(renderer.Volume.Geometry, TowardsEye, 16)).Read();
                string what = $"{hidden} segments hidden";
                AssertSane(picture, SegmentCount, what);
                int visible = AssertTexturesAreTheFields(renderer, what);
                if (hidden == SegmentCount)
                    Assert.That(visible + CountSeen(picture), Is.Zero, what);
            }
        }

        [Test]
        public void Labels_AsManyAsThereCanBe_AreCutOneByOne()
        {
            const int most = SegmentTable.MaximumCount;
            VolumeGeometry geometry = Grid(41, 40, 40, 1, 1, 1);
            ushort[] indices = Enumerable.Range(0, (int)geometry.VoxelCount).Select(v => (ushort)(v % most)).ToArray();
            CarvedVolumeRenderer renderer = MakeVolume(Volume(geometry, Constant(geometry, 1000), indices, most));
            CarvingStack carving = renderer.Stack.Carving;
            carving.SetActive(geometry.CentreLps, 100);
            int[] cut = { 0, 31, 32, 2047, 2048, 2049, 2050, 32768, most - 2, most - 1 };
            carving.SetActiveMask(SegmentMask.FromIndices(most, cut));
            AssertSane(renderer.Render(Look(geometry, TowardsEye, 16)).Read(), most, "65,535 segments");
            int clipped = cut.Sum(label => label < geometry.VoxelCount - most ? 2 : 1);
            Assert.That(AssertTexturesAreTheFields(renderer, "65,535 segments"), Is.EqualTo(geometry.VoxelCount - clipped));
        }

        [Test]
        public void Labels_WithGaps_AreShownAndCutAsWhatTheyAre([Values(2047, 2048, 2049, 2050, 65535)] int label)
        {
            int[] labels = { 0, 2047, 2048, 2049, 2050, 65535 };
            VolumeGeometry geometry = Grid(6, 6, 6, 1, 1, 1);
            var voxels = new int[geometry.VoxelCount];
            for (int v = 0; v < voxels.Length; v++)
                voxels[v] = labels[v % 6]; // a slab of each along i
            var map = LabelMap.FromVolumeData(new VolumeData(geometry, voxels));
            var volume = new SegmentedVolume(new IntensityVolume(geometry, Constant(geometry, 1000), 0, 1, 1000), map);
            CarvedVolumeRenderer renderer = MakeVolume(volume);
            int index = map.Segments.IndexOfLabel(label);
            PictureRays rays = PictureRays.Orthographic(geometry.CentreLps + new VectorMm(0, -20, 0), geometry.CentreLps, Superior, 6, 6, 6);
            PictureData whole = renderer.Render(rays).Read();
            renderer.Stack.Carving.SetActive(geometry.CentreLps, 50);
            renderer.Stack.Carving.SetActiveMask(SegmentMask.FromIndices(map.Segments.Count, new[] { index }));
            PictureData cut = renderer.Render(rays).Read();
            AssertTexturesAreTheFields(renderer, "label " + label);
            Assert.That(map.Segments[index].Label, Is.EqualTo(label));
            Assert.That(Count(whole, index), Is.EqualTo(6), "its column of pixels");
            Assert.That(Count(cut, index), Is.Zero);
        }

        static ushort[] Constant(VolumeGeometry geometry, int code) => Enumerable.Repeat((ushort)code, (int)geometry.VoxelCount).ToArray();
    }
}
