using System;

namespace AnatomyCarve.Volumes
{
    /// <summary>
    /// Where the voxels of a grid lie in the patient. Integer (i, j, k) is a voxel's centre; i runs fastest in memory.
    /// Oblique and sheared grids are carried as they are. Immutable.
    /// </summary>
    public sealed class VolumeGeometry
    {
        /// <summary>The corners of the box that a volume fills; see <see cref="CornerOffset"/>.</summary>
        public const int Corners = 8;

        /// <summary>Axes whose unit vectors span less than this volume are taken for parallel.</summary>
        const double SmallestUnitDeterminant = 1e-6;

        /// <summary>Makes a geometry.</summary>
        /// <param name="sizeI">Voxels along i, at least 1.</param>
        /// <param name="sizeJ">Voxels along j, at least 1.</param>
        /// <param name="sizeK">Voxels along k, at least 1.</param>
        /// <param name="ijkToLps">Voxel index to LPS millimetres; its origin is the centre of voxel (0, 0, 0).</param>
        /// <exception cref="ArgumentException">A size below 1; an element that is not finite; axes of no length or parallel to each other.</exception>
        public VolumeGeometry(int sizeI, int sizeJ, int sizeK, Affine ijkToLps)
        {
            if (sizeI < 1 || sizeJ < 1 || sizeK < 1)
                throw new ArgumentException(FormattableString.Invariant($"A volume has at least one voxel along each axis, not {sizeI} x {sizeJ} x {sizeK}."));
            string problem = FindProblem(ijkToLps);
            if (problem != null)
                throw new ArgumentException(problem, nameof(ijkToLps));
            SizeI = sizeI;
            SizeJ = sizeJ;
            SizeK = sizeK;
            IjkToLps = ijkToLps;
            LpsToIjk = ijkToLps.Inverse();
            SpacingMm = new VectorMm(ijkToLps.Column(0).Length, ijkToLps.Column(1).Length, ijkToLps.Column(2).Length);
            ReferenceLengthMm = Math.Min(SpacingMm.X, Math.Min(SpacingMm.Y, SpacingMm.Z));
            CentreLps = ijkToLps.TransformPoint(new PointMm((sizeI - 1) / 2.0, (sizeJ - 1) / 2.0, (sizeK - 1) / 2.0));
            VectorMm toOrigin = ijkToLps.Origin - CentreLps;
            IjkToCentredMm = Affine.FromColumns(
                ijkToLps.Column(0), ijkToLps.Column(1), ijkToLps.Column(2), new PointMm(toOrigin.X, toOrigin.Y, toOrigin.Z));
            OrientationCode = VolumeOrientation.Code(ijkToLps);
        }

        /// <summary>Voxels along i, the axis that runs fastest in memory.</summary>
        public int SizeI { get; }

        /// <summary>Voxels along j.</summary>
        public int SizeJ { get; }

        /// <summary>Voxels along k, the slowest axis.</summary>
        public int SizeK { get; }

        /// <summary>The number of voxels, SizeI x SizeJ x SizeK.</summary>
        public long VoxelCount => (long)SizeI * SizeJ * SizeK;

        /// <summary>Voxel index to LPS millimetres.</summary>
        public Affine IjkToLps { get; }

        /// <summary>LPS millimetres to (fractional) voxel index.</summary>
        public Affine LpsToIjk { get; }

        /// <summary>Distances of neighbouring voxels' centres along i, j, k, mm.</summary>
        public VectorMm SpacingMm { get; }

        /// <summary>The smallest of the three spacings, mm: the length that opacities refer to.</summary>
        public double ReferenceLengthMm { get; }

        /// <summary>The grid's centre, index (dims - 1) / 2, LPS mm.</summary>
        public PointMm CentreLps { get; }

        /// <summary>Voxel index to LPS millimetres relative to <see cref="CentreLps"/>.</summary>
        public Affine IjkToCentredMm { get; }

        /// <summary>Where i, j and k run to, such as "RAS": one letter of R/L, A/P, S/I each, the closest for an oblique grid.</summary>
        public string OrientationCode { get; }

        /// <summary>Says why a map can't place a volume, or null when it can.</summary>
        /// <param name="ijkToLps">Voxel index to LPS millimetres.</param>
        /// <returns>One sentence, or null.</returns>
        public static string FindProblem(Affine ijkToLps)
        {
            if (!ijkToLps.IsFinite)
                return "The map from voxel index to millimetres holds NaN or infinite numbers.";
            double volume = ijkToLps.Column(0).Length * ijkToLps.Column(1).Length * ijkToLps.Column(2).Length;
            if (volume == 0 || double.IsInfinity(volume))
                return "An axis of the grid has no length, or an infinite one.";
            return Math.Abs(ijkToLps.Determinant) / volume < SmallestUnitDeterminant ? "Axes of the grid are parallel." : null;
        }

        /// <summary>From the centre to a corner of the box that the volume fills, half a voxel beyond the voxels' centres, in LPS millimetres.</summary>
        /// <param name="corner">0 to 7: bit 0 = the high end of i, bit 1 = of j, bit 2 = of k.</param>
        public VectorMm CornerOffset(int corner) => IjkToCentredMm.TransformPoint(new PointMm(
            (corner & 1) == 0 ? -0.5 : SizeI - 0.5, (corner & 2) == 0 ? -0.5 : SizeJ - 0.5, (corner & 4) == 0 ? -0.5 : SizeK - 0.5)) - default(PointMm);

        /// <summary>The unit vectors of the axes as the columns of a 3x3 matrix, LPS.</summary>
        /// <returns>A new array [row, column].</returns>
        public double[,] Direction()
        {
            var direction = new double[3, 3];
            for (int col = 0; col < 3; col++)
            {
                VectorMm axis = IjkToLps.Column(col).Normalized();
                direction[0, col] = axis.X;
                direction[1, col] = axis.Y;
                direction[2, col] = axis.Z;
            }

            return direction;
        }

        /// <summary>True when two axes are not at right angles.</summary>
        /// <param name="tolerance">The largest cosine between axes that still counts as a right angle.</param>
        public bool IsSheared(double tolerance = 1e-3)
        {
            VectorMm i = IjkToLps.Column(0).Normalized();
            VectorMm j = IjkToLps.Column(1).Normalized();
            VectorMm k = IjkToLps.Column(2).Normalized();
            return Math.Abs(i.Dot(j)) > tolerance || Math.Abs(j.Dot(k)) > tolerance || Math.Abs(k.Dot(i)) > tolerance;
        }

        /// <summary>True when another grid has the same sizes and each of its corner voxels lies within a tolerance of ours.</summary>
        /// <param name="other">The other geometry.</param>
        /// <param name="toleranceMm">The largest distance of corresponding corners, mm.</param>
        /// <param name="difference">What differs, in a sentence; null when nothing does.</param>
        /// <exception cref="ArgumentNullException"><paramref name="other"/> is null.</exception>
        public bool Matches(VolumeGeometry other, double toleranceMm, out string difference)
        {
            if (other == null)
                throw new ArgumentNullException(nameof(other));
            if (SizeI != other.SizeI || SizeJ != other.SizeJ || SizeK != other.SizeK)
            {
                difference = FormattableString.Invariant(
                    $"The sizes differ: {SizeI} x {SizeJ} x {SizeK} and {other.SizeI} x {other.SizeJ} x {other.SizeK} voxels.");
                return false;
            }

            double distanceMm = LargestCornerDistanceMm(IjkToLps, other.IjkToLps, SizeI, SizeJ, SizeK);
            difference = distanceMm <= toleranceMm
                ? null
                : FormattableString.Invariant(
                    $"The positions differ by up to {distanceMm:0.###} mm (origins {IjkToLps.Origin} and {other.IjkToLps.Origin}, orientations {OrientationCode} and {other.OrientationCode}).");
            return difference == null;
        }

        /// <summary>As the other overload, with the tolerance <see cref="SegmentedVolume.GeometryToleranceMm"/>.</summary>
        /// <param name="other">The other geometry.</param>
        /// <param name="difference">What differs, in a sentence; null when nothing does.</param>
        public bool Matches(VolumeGeometry other, out string difference) => Matches(other, SegmentedVolume.GeometryToleranceMm, out difference);

        /// <summary>How far two maps place the corner voxels of a grid apart, at most; mm.</summary>
        internal static double LargestCornerDistanceMm(Affine a, Affine b, int sizeI, int sizeJ, int sizeK)
        {
            double largest = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                var ijk = new PointMm(
                    (corner & 1) == 0 ? 0 : sizeI - 1, (corner & 2) == 0 ? 0 : sizeJ - 1, (corner & 4) == 0 ? 0 : sizeK - 1);
                largest = Math.Max(largest, a.TransformPoint(ijk).DistanceTo(b.TransformPoint(ijk)));
            }

            return largest;
        }
    }
}
