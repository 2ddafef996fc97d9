using System;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// Which voxels of a brick are meant: of each quarter of its columns along k, 4 x 4 of them, those from one k to another. What kernels work on after an edit,
    /// where a whole brick would be more than can differ. Immutable.
    /// </summary>
    public readonly struct BrickPart : IEquatable<BrickPart>
    {
        /// <summary>Columns along a quarter's edges.</summary>
        public const int QuarterSize = BrickGrid.BrickSize / 2;

        /// <summary>The quarters of a brick: number x + 2 * y, both 0 or 1.</summary>
        public const int Quarters = 4;

        /// <summary>Voxels along k that opacities are computed together: so many share a texel of the portable layout, and a cell of the skip structure.</summary>
        public const int OpacityStep = 4;

        /// <summary>Voxels along k that normals are computed together: so many share a texel of the portable layout.</summary>
        public const int NormalsStep = 2;

        const int QuarterBits = 8, EndShift = 4;
        const uint PlaceMask = 15;

        BrickPart(uint packed) => Packed = packed;

        /// <summary>No voxel.</summary>
        public static BrickPart None => default;

        /// <summary>All voxels.</summary>
        public static BrickPart Whole => new BrickPart(0x80808080u);

        /// <summary>As the kernels take it: eight bits a quarter, the first place along k, 0 to 8, in the lower four, the end (one beyond the last) in the others.</summary>
        public uint Packed { get; }

        /// <summary>Whether it holds no voxel.</summary>
        public bool IsNone => Packed == 0;

        /// <summary>The same part with other places of one quarter.</summary>
        /// <param name="quarter">The quarter, 0 to 3.</param>
        /// <param name="first">The first place along k, 0 to 7; rounded down to a step.</param>
        /// <param name="last">The last place, likewise; rounded up. Below <paramref name="first"/> = none.</param>
        /// <param name="step"><see cref="OpacityStep"/> or <see cref="NormalsStep"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such quarter, place or step.</exception>
        public BrickPart With(int quarter, int first, int last, int step)
        {
            Check(quarter, Quarters, nameof(quarter));
            if (step != OpacityStep && step != NormalsStep)
                throw new ArgumentOutOfRangeException(nameof(step), step, FormattableString.Invariant($"A step is {NormalsStep} or {OpacityStep} voxels."));
            uint others = Packed & ~(((1u << QuarterBits) - 1) << (QuarterBits * quarter));
            if (last < first)
                return new BrickPart(others);
            Check(first, BrickGrid.BrickSize, nameof(first));
            Check(last, BrickGrid.BrickSize, nameof(last));
            uint from = (uint)(first / step * step), end = (uint)((last / step + 1) * step);
            return new BrickPart(others | (from | end << EndShift) << (QuarterBits * quarter));
        }

        /// <summary>Whether a voxel of the brick belongs to it.</summary>
        /// <param name="i">The voxel's offset in its brick along i, 0 to 7; likewise j and k.</param>
        /// <param name="j">Along j.</param>
        /// <param name="k">Along k.</param>
        public bool Holds(int i, int j, int k)
        {
            uint places = Packed >> (QuarterBits * (i / QuarterSize + 2 * (j / QuarterSize)));
            return k >= (int)(places & PlaceMask) && k < (int)((places >> EndShift) & PlaceMask);
        }

        /// <summary>The number of its voxels that lie in the volume.</summary>
        /// <param name="brick">The brick's voxels that do.</param>
        public int VoxelsIn(in VoxelBox brick)
        {
            int voxels = 0, sizeI = brick.MaxI - brick.MinI + 1, sizeJ = brick.MaxJ - brick.MinJ + 1, sizeK = brick.MaxK - brick.MinK + 1;
            for (int quarter = 0; quarter < Quarters; quarter++)
            {
                uint places = Packed >> (QuarterBits * quarter);
                int columnsI = Within(sizeI - QuarterSize * (quarter & 1)), columnsJ = Within(sizeJ - QuarterSize * (quarter >> 1));
                int length = Math.Min(sizeK, (int)((places >> EndShift) & PlaceMask)) - (int)(places & PlaceMask);
                voxels += columnsI * columnsJ * Math.Max(0, length);
            }
            return voxels;
        }

        /// <inheritdoc/>
        public bool Equals(BrickPart other) => Packed == other.Packed;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is BrickPart other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => (int)Packed;

        /// <summary>Whether two parts hold the same voxels.</summary>
        public static bool operator ==(BrickPart left, BrickPart right) => left.Equals(right);

        /// <summary>Whether two parts hold different voxels.</summary>
        public static bool operator !=(BrickPart left, BrickPart right) => !left.Equals(right);

        static int Within(int size) => Math.Max(0, Math.Min(QuarterSize, size));

        static void Check(int value, int count, string argument)
        {
            if (value < 0 || value >= count)
                throw new ArgumentOutOfRangeException(argument, value, FormattableString.Invariant($"It is 0 to {count - 1}."));
        }
    }
}
