using System.Linq;
using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public static class LabelMapGridTests
    {
        static readonly Affine ScanToLps = Affine.FromColumns(
            new VectorMm(0.6, 0.3, 0), new VectorMm(-0.36, 0.72, 0), new VectorMm(0, 0, 2), new PointMm(10, -20, 30));

        static readonly VolumeGeometry Scan = new VolumeGeometry(7, 5, 4, ScanToLps);

        [Test]
        public static void OnGridOf_TheSameGrid_IsTheSameMap()
        {
            LabelMap map = Numbered(Scan);

            Assert.That(map.OnGridOf(Scan), Is.SameAs(map));
        }

        [Test]
        public static void OnGridOf_CroppedMap_KeepsEachVoxelInPlace()
        {
            // Voxel (0, 0, 0) of the map is voxel (2, 1, 1) of the scan.
            LabelMap map = Numbered(new VolumeGeometry(3, 4, 2, Moved(ScanToLps, 2, 1, 1)));

            LabelMap onScan = map.OnGridOf(Scan);

            Assert.That(onScan.Indices[At(Scan, 2, 1, 1)], Is.EqualTo(map.Indices[0]));
            Assert.That(onScan.Indices[At(Scan, 4, 4, 2)], Is.EqualTo(map.Indices[At(map.Geometry, 2, 3, 1)]));
            Assert.That(onScan.Indices.Count(index => index != 0), Is.EqualTo(map.Indices.Length), "nothing else is labelled");
            Assert.That(onScan.Warnings, Is.Empty);
        }

        [Test]
        public static void OnGridOf_MapWithAxesSwappedAndTurned_KeepsEachVoxelInPlace()
        {
            // The map's i runs along the scan's -k, its j along the scan's i, its k along the scan's j.
            var axes = Affine.FromColumns(new VectorMm(0, 0, -1), new VectorMm(1, 0, 0), new VectorMm(0, 1, 0), new PointMm(0, 0, 3));
            LabelMap map = Numbered(new VolumeGeometry(4, 7, 5, ScanToLps * axes));

            LabelMap onScan = map.OnGridOf(Scan);

            Assert.That(onScan.Indices[At(Scan, 6, 2, 0)], Is.EqualTo(map.Indices[At(map.Geometry, 3, 6, 2)]));
            Assert.That(onScan.Indices[At(Scan, 1, 4, 3)], Is.EqualTo(map.Indices[At(map.Geometry, 0, 1, 4)]));
        }

        [Test]
        public static void OnGridOf_MapThatReachesBeyond_WarnsHowMuchIsLost()
        {
            LabelMap map = Numbered(new VolumeGeometry(3, 5, 4, Moved(ScanToLps, 5, 0, 0)));

            LabelMap onScan = map.OnGridOf(Scan);

            Assert.That(onScan.Warnings, Has.Count.EqualTo(1));
            Assert.That(onScan.Warnings[0], Does.StartWith("20 labelled voxels"));
        }

        [Test]
        public static void OnGridOf_MapHalfAVoxelAside_IsLeftForTheVolumeToRefuse()
        {
            LabelMap map = Numbered(new VolumeGeometry(7, 5, 4, Moved(ScanToLps, 0.5, 0, 0)));
            var intensity = new IntensityVolume(Scan, new ushort[Scan.VoxelCount], 0, 1, 0);

            Assert.That(map.OnGridOf(Scan), Is.SameAs(map));
            Assert.That(() => new SegmentedVolume(intensity, map), Throws.TypeOf<VolumeMismatchException>());
        }

        [TestCase(0.5)]
        [TestCase(2.0)]
        public static void OnGridOf_MapOfAnotherResolution_IsLeftForTheVolumeToRefuse(double spacingFactor)
        {
            // Every voxel of the coarser grid coincides with one of the finer grid; taking those alone would drop the rest without a word.
            var scale = Affine.FromColumns(
                new VectorMm(spacingFactor, 0, 0), new VectorMm(0, spacingFactor, 0), new VectorMm(0, 0, spacingFactor), new PointMm(0, 0, 0));
            LabelMap map = Numbered(new VolumeGeometry(7, 5, 4, ScanToLps * scale));

            Assert.That(map.OnGridOf(Scan), Is.SameAs(map));
        }

        static Affine Moved(Affine ijkToLps, double i, double j, double k) => Affine.FromColumns(
            ijkToLps.Column(0), ijkToLps.Column(1), ijkToLps.Column(2), ijkToLps.TransformPoint(new PointMm(i, j, k)));

        static int At(VolumeGeometry grid, int i, int j, int k) => i + grid.SizeI * (j + grid.SizeJ * k);

        /// <summary>A map in which every voxel has a segment of its own.</summary>
        static LabelMap Numbered(VolumeGeometry grid)
        {
            int voxels = (int)grid.VoxelCount;
            var table = new SegmentTable(Enumerable.Range(0, voxels + 1).Select(n => new Segment(n, n, "Label " + n, new SegmentColor(1, 2, 3))));
            return new LabelMap(grid, Enumerable.Range(1, voxels).Select(n => (ushort)n).ToArray(), table);
        }
    }
}
