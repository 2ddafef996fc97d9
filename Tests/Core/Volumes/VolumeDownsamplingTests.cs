using System;
using System.Linq;
using System.Threading;
using AnatomyCarve.Formats;
using AnatomyCarve.Tests.TestSupport;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public static class VolumeDownsamplingTests
    {
        static readonly VoxelFactors[] Several =
        {
            new VoxelFactors(2, 2, 2), new VoxelFactors(1, 3, 2), new VoxelFactors(4, 1, 1), new VoxelFactors(2, 5, 3), new VoxelFactors(50, 50, 50),
        };

        [Test]
        public static void Intensity_OfWholeCells_IsTheMeanRoundedOnce()
        {
            int[] codes = { 0, 1, 10, 13, 2, 3, 20, 20 }; // cells of 2 x 2 x 1: 0 1 2 3 and 10 13 20 20

            SegmentedVolume coarse = VolumeDownsampling.Of(Make(4, 2, 1, v => codes[v], v => 0, 1), new VoxelFactors(2, 2, 1));

            Assert.That(coarse.Intensity.Codes, Is.EqualTo(new ushort[] { 2, 16 }), "1.5 and 15.75");
        }

        [Test]
        public static void Intensity_WhereTheFactorDoesNotDivide_CountsVoxelsByTheirParts()
        {
            // Three voxels in two cells of 1.5: the one in the middle lies in both by half.
            SegmentedVolume coarse = VolumeDownsampling.Of(Make(3, 1, 1, v => new[] { 0, 300, 900 }[v], v => 0, 1), new VoxelFactors(2, 1, 1));

            Assert.That(coarse.Intensity.Codes, Is.EqualTo(new ushort[] { 100, 700 }));
        }

        [Test]
        public static void Intensity_OfAConstantVolume_StaysAsItIs([ValueSource(nameof(Several))] VoxelFactors factors)
        {
            SegmentedVolume coarse = VolumeDownsampling.Of(Make(7, 11, 5, v => 65535, v => 0, 1), factors);

            Assert.That(coarse.Intensity.Codes, Is.All.EqualTo(65535));
        }

        [Test]
        public static void Intensity_OfARamp_KeepsItsPlace()
        {
            // Code = 100 * i: the code at a coarse voxel's place, wherever it lies.
            SegmentedVolume fine = Make(9, 3, 2, v => 100 * (v % 9), v => 0, 1);

            SegmentedVolume coarse = VolumeDownsampling.Of(fine, new VoxelFactors(3, 1, 1));

            for (int i = 0; i < 3; i++)
            {
                PointMm place = coarse.Geometry.IjkToLps.TransformPoint(new PointMm(i, 0, 0));
                Assert.That(coarse.Intensity.Codes[i], Is.EqualTo(100 * fine.Geometry.LpsToIjk.TransformPoint(place).X).Within(1e-9));
            }
        }

        [Test]
        public static void Values_OfTheCodes_AreThoseOfTheFineVolume()
        {
            SegmentedVolume fine = Make(4, 4, 4, v => v, v => 0, 1);

            IntensityVolume coarse = VolumeDownsampling.Of(fine, new VoxelFactors(2, 2, 2)).Intensity;

            Assert.That((coarse.CodeOffset, coarse.CodeScale, coarse.ValueMax), Is.EqualTo((fine.Intensity.CodeOffset, fine.Intensity.CodeScale, fine.Intensity.ValueMax)));
        }

        [TestCase("1122", 1, Description = "equal: the first in the table")]
        [TestCase("2211", 1, Description = "in whatever order they come")]
        [TestCase("1222", 2)]
        [TestCase("0012", 1, Description = "label 0 fills no more than three quarters")]
        [TestCase("0001", 1, Description = "three quarters are not more than three quarters")]
        [TestCase("0002", 2)]
        [TestCase("0000", 0)]
        public static void Label_OfACell_IsWhatMostOfItIs(string labels, int expected)
        {
            SegmentedVolume coarse = VolumeDownsampling.Of(Make(2, 2, 1, v => 0, v => labels[v] - '0', 3), new VoxelFactors(2, 2, 1));

            Assert.That(coarse.Labels.Indices, Is.EqualTo(new[] { (ushort)expected }));
        }

        [Test]
        public static void Label_OfOneVoxelInFive_Vanishes()
        {
            SegmentedVolume coarse = VolumeDownsampling.Of(Make(5, 1, 1, v => 0, v => v == 2 ? 1 : 0, 2), new VoxelFactors(5, 1, 1));

            Assert.That(coarse.Labels.Indices, Is.EqualTo(new ushort[] { 0 }));
        }

        [Test]
        public static void Label_OfAThreadOneVoxelThin_LivesThroughFactorTwo([Values(0, 1, 2)] int axis)
        {
            const int size = 16;
            SegmentedVolume fine = Make(size, size, size, v => 0, v =>
            {
                int[] place = { v % size, v / size % size, v / size / size };
                return place[(axis + 1) % 3] == 6 && place[(axis + 2) % 3] == 9 ? 1 : 0;
            }, 2);

            SegmentedVolume coarse = VolumeDownsampling.Of(fine, new VoxelFactors(2, 2, 2));

            Assert.That(coarse.Labels.VoxelCounts[1], Is.EqualTo(size / 2));
        }

        [Test]
        public static void Volume_OfAnySize_HasTheSameBoxSegmentsAndOrigin([ValueSource(nameof(Several))] VoxelFactors factors)
        {
            SegmentedVolume fine = SampleVolumes.Scan(13, 9, 7, 6, 3);

            SegmentedVolume coarse = VolumeDownsampling.Of(fine, factors);

            Assert.That(coarse.Geometry.CentreLps.DistanceTo(fine.Geometry.CentreLps), Is.LessThan(1e-9));
            Assert.That(coarse.Segments, Is.SameAs(fine.Segments));
            Assert.That(coarse.Origin, Is.SameAs(fine.Origin));
            Assert.That(coarse.AutomaticTransferFunction, Is.SameAs(fine.AutomaticTransferFunction));
            Assert.That(coarse.Warnings, Is.EqualTo(fine.Warnings));
        }

        [Test]
        public static void Middle_OfEachCell_IsTheOnlySliceThatCounts()
        {
            SegmentedVolume fine = Make(1, 1, 6, v => 10 * v, v => v, 6); // cells of slices 0 to 2 and 3 to 5

            SegmentedVolume coarse = VolumeDownsampling.Of(fine, new VoxelFactors(1, 1, 3), CellSlices.Middle);

            Assert.That(coarse.Intensity.Codes, Is.EqualTo(new ushort[] { 10, 40 }));
            Assert.That(coarse.Labels.Indices, Is.EqualTo(new ushort[] { 1, 4 }));
        }

        [Test]
        public static void Volumes_OfOtherOrientations_AreTheSameInThePatient()
        {
            // The same voxels stored with i and k turned round.
            const int size = 6;
            SegmentedVolume fine = SampleVolumes.Scan(size, size, size, 5, 8);
            VolumeGeometry g = fine.Geometry;
            var turn = Affine.FromColumns(new VectorMm(-1, 0, 0), new VectorMm(0, 1, 0), new VectorMm(0, 0, -1), new PointMm(size - 1, 0, size - 1));
            int Turned(int v) => (size - 1 - (v % size)) + (size * ((v / size % size) + (size * (size - 1 - (v / size / size)))));
            SegmentedVolume turned = SampleVolumes.Of(
                new VolumeGeometry(size, size, size, g.IjkToLps * turn), v => fine.Intensity.Codes[Turned(v)], v => fine.Labels.Indices[Turned(v)], 5);

            SegmentedVolume a = VolumeDownsampling.Of(fine, new VoxelFactors(2, 3, 2)), b = VolumeDownsampling.Of(turned, new VoxelFactors(2, 3, 2));

            for (int v = 0; v < a.Labels.Indices.Length; v++)
            {
                PointMm place = b.Geometry.LpsToIjk.TransformPoint(a.Geometry.IjkToLps.TransformPoint(new PointMm(v % 3, v / 3 % 2, v / 6)));
                int there = (int)Math.Round(place.X) + (3 * ((int)Math.Round(place.Y) + (2 * (int)Math.Round(place.Z))));
                Assert.That((b.Intensity.Codes[there], b.Labels.Indices[there]), Is.EqualTo((a.Intensity.Codes[v], a.Labels.Indices[v])), "voxel " + v);
            }
        }

        [Test]
        public static void FactorsOfOne_GiveTheVolumeItself()
        {
            SegmentedVolume fine = SampleVolumes.Scan(4, 4, 4, 3, 1);

            Assert.That(VolumeDownsampling.Of(fine, new VoxelFactors(1, 1, 1)), Is.SameAs(fine));
        }

        [Test]
        public static void Work_ThatIsCancelled_Ends()
        {
            using (var source = new CancellationTokenSource())
            {
                source.Cancel();
                Assert.That(
                    () => VolumeDownsampling.Of(SampleVolumes.Scan(8, 8, 8, 3, 1), new VoxelFactors(2, 2, 2), CellSlices.All, source.Token),
                    Throws.InstanceOf<OperationCanceledException>());
            }
        }

        [Test]
        public static void PackedVolume_ReadCoarse_IsWhatDownsamplingMakesOfIt(
            [ValueSource(nameof(Several))] VoxelFactors factors, [Values] CellSlices slices)
        {
            SegmentedVolume fine = SampleVolumes.Scan(181, 97, 31, 9, 5); // five blocks, whose borders lie inside slices
            PackedVolumeReader packed = PackedVolume.Open(PackedVolume.Write(fine), "packed");

            SegmentedVolume coarse = packed.ReadCoarse(factors, slices), expected = VolumeDownsampling.Of(fine, factors, slices);

            Assert.That(coarse.Intensity.Codes, Is.EqualTo(expected.Intensity.Codes));
            Assert.That(coarse.Labels.Indices, Is.EqualTo(expected.Labels.Indices));
            Assert.That(coarse.Geometry.Matches(expected.Geometry, 0, out string difference), Is.True, difference);
        }

        [Test]
        public static void PackedVolume_ReadTwice_GivesVolumesOfOneOriginAndTable()
        {
            PackedVolumeReader packed = PackedVolume.Open(PackedVolume.Write(SampleVolumes.Scan(9, 8, 7, 4, 2)), "packed");

            SegmentedVolume coarse = packed.ReadCoarse(new VoxelFactors(2, 2, 2)), whole = packed.Read();

            Assert.That(coarse.Origin, Is.SameAs(whole.Origin));
            Assert.That(coarse.Segments, Is.SameAs(whole.Segments));
        }

        [Test]
        public static void Volumes_MadeApart_HaveDifferentOrigins()
        {
            SegmentedVolume one = SampleVolumes.Scan(4, 4, 4, 3, 1), sameLabels = new SegmentedVolume(one.Intensity, one.Labels);

            Assert.That(sameLabels.Origin, Is.Not.SameAs(one.Origin));
        }

        [Test]
        public static void WithWarning_AddsTheSentenceAndNothingElse()
        {
            SegmentedVolume volume = SampleVolumes.Scan(4, 4, 4, 3, 1);

            SegmentedVolume warned = volume.WithWarning("It was odd.");

            Assert.That(warned.Warnings, Is.EqualTo(volume.Warnings.Append("It was odd.")));
            Assert.That(warned.Labels, Is.SameAs(volume.Labels));
            Assert.That(warned.Origin, Is.SameAs(volume.Origin));
        }

        static SegmentedVolume Make(int i, int j, int k, Func<int, int> code, Func<int, int> index, int segments) => SampleVolumes.Of(i, j, k, code, index, segments);
    }
}
