using AnatomyCarve.Volumes;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Volumes
{
    public static class VoxelFactorsTests
    {
        static readonly Affine Oblique = Affine.FromColumns(
            new VectorMm(0.6, 0.3, 0), new VectorMm(-0.36, 0.72, 0), new VectorMm(0.1, 0, 2), new PointMm(10, -20, 30));

        [Test]
        public static void Fitting_AGridThatFits_IsOne() =>
            Assert.That(VoxelFactors.Fitting(Grid(5, 6, 7, 1, 1, 1), (i, j, k) => true), Is.EqualTo(new VoxelFactors(1, 1, 1)));

        [Test]
        public static void Fitting_NotEvenOneVoxel_IsNone() =>
            Assert.That(VoxelFactors.Fitting(Grid(5, 6, 7, 1, 1, 1), (i, j, k) => false), Is.Null);

        [Test]
        public static void Fitting_ThickSlices_KeepsThemAndCoarsensInThePlane() =>
            Assert.That(Fitting(Grid(512, 512, 100, 0.7, 0.7, 3), 512 * 512 * 30), Is.EqualTo(new VoxelFactors(2, 2, 1)));

        [Test]
        public static void Fitting_EqualSpacings_TakesTheLongestAxisFirst() =>
            Assert.That(Fitting(Grid(100, 100, 400, 1, 1, 1), 100 * 100 * 250), Is.EqualTo(new VoxelFactors(1, 1, 2)));

        [Test]
        public static void Fitting_AlongOneAxis_IsTheSmallestFactorThere() =>
            Assert.That(VoxelFactors.Fitting(Grid(10, 1, 1, 1, 1, 1), (i, j, k) => i <= 3), Is.EqualTo(new VoxelFactors(4, 1, 1)));

        [TestCase(1, 1, 1)]
        [TestCase(2, 3, 1)]
        [TestCase(7, 5, 9)]
        [TestCase(3, 2, 4)]
        public static void Apply_AnyFactors_KeepsCentreAndCorners(int i, int j, int k)
        {
            var grid = new VolumeGeometry(7, 6, 5, Oblique);

            VolumeGeometry coarse = new VoxelFactors(i, j, k).Apply(grid);

            Assert.That(coarse.CentreLps.DistanceTo(grid.CentreLps), Is.LessThan(1e-12));
            for (int corner = 0; corner < VolumeGeometry.Corners; corner++)
                Assert.That((coarse.CornerOffset(corner) - grid.CornerOffset(corner)).Length, Is.LessThan(1e-12), "corner " + corner);
            Assert.That(coarse.OrientationCode, Is.EqualTo(grid.OrientationCode));
        }

        [Test]
        public static void Apply_FactorsThatDivide_PutsAVoxelAtTheCentreOfItsCell()
        {
            var grid = new VolumeGeometry(6, 4, 6, Oblique);

            VolumeGeometry coarse = new VoxelFactors(3, 2, 2).Apply(grid);

            Assert.That((coarse.SizeI, coarse.SizeJ, coarse.SizeK), Is.EqualTo((2, 2, 3)));
            PointMm expected = grid.IjkToLps.TransformPoint(new PointMm(4, 0.5, 2.5)); // voxels 3 to 5, 0 to 1, 2 to 3
            Assert.That(coarse.IjkToLps.TransformPoint(new PointMm(1, 0, 1)).DistanceTo(expected), Is.LessThan(1e-12));
        }

        [TestCase(0, 1, 1)]
        [TestCase(1, 1, -1)]
        public static void Factors_BelowOne_AreRefused(int i, int j, int k) =>
            Assert.That(() => new VoxelFactors(i, j, k), Throws.InstanceOf<System.ArgumentOutOfRangeException>());

        static VoxelFactors? Fitting(VolumeGeometry grid, long voxels) => VoxelFactors.Fitting(grid, (i, j, k) => (long)i * j * k <= voxels);

        static VolumeGeometry Grid(int i, int j, int k, double x, double y, double z) => new VolumeGeometry(
            i, j, k, Affine.FromColumns(new VectorMm(x, 0, 0), new VectorMm(0, y, 0), new VectorMm(0, 0, z), default));
    }
}
