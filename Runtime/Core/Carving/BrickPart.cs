using System;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// Which voxels of a brick are meant: of each strip of its columns along k, 4 x 2 of them, those from one k to another. What kernels work on after an edit,
    /// where a whole brick would be more than can differ. Immutable.
    /// </summary>
    public readonly struct BrickPart : IEquatable<BrickPart>
    {
        /// <summary>A strip's columns along i.</summary>
        public const int StripColumns = BrickGrid.BrickSize / 2;

        /// <summary>A strip's columns along j.</summary>
        public const int StripRows = BrickGrid.BrickSize / 4;

        /// <summary>The strips of a brick: the number is 1 for the upper two rows of a quarter + 2 * the half along i + 4 * the half along j.</summary>
        public const int Strips = BrickGrid.BrickSize / StripColumns * (BrickGrid.BrickSize / StripRows);

        /// <summary>Voxels along each axis that opacities are computed together: a cell of the skip structure; so many share a texel of the portable layout.</summary>
        public const int OpacityStep = 4;

        /// <summary>Voxels along k that normals are computed together: so many share a texel of the portable layout.</summary>
        public const int NormalsStep = 2;

        const int StripBits = 4, LastStep = BrickGrid.BrickSize / NormalsStep - 1;
        const uint StripMask = (1u << StripBits) - 1;

        BrickPart(uint packed) => Packed = packed;

        /// <summary>No voxel.</summary>
        public static BrickPart None => default;

        /// <summary>All voxels.</summary>
        public static BrickPart Whole => new BrickPart(uint.MaxValue);

        /// <summary>
        /// As the kernels take it: four bits a strip; of the places along k, in steps of <see cref="NormalsStep"/>, 3 less the first one in the lower two, the last
        /// one in the others. None of them: all 0.
        /// </summary>
        public uint Packed { get; }

        /// <summary>Whether it holds no voxel.</summary>
        public bool IsNone => Packed == 0;

        /// <summary>The same part with other places of one strip.</summary>
        /// <param name="strip">The strip, 0 to 7.</param>
        /// <param name="first">The first place along k, 0 to 7; rounded down to a step.</param>
        /// <param name="last">The last place, likewise; rounded up. Below <paramref name="first"/> = none.</param>
        /// <param name="step"><see cref="OpacityStep"/> or <see cref="NormalsStep"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such strip, place or step.</exception>
        public BrickPart With(int strip, int first, int last, int step)
        {
            Check(strip, Strips, nameof(strip));
            if (step != OpacityStep && step != NormalsStep)
                throw new ArgumentOutOfRangeException(nameof(step), step, FormattableString.Invariant($"A step is {NormalsStep} or {OpacityStep} voxels."));
            uint others = Packed & ~(StripMask << (StripBits * strip));
            if (last < first)
                return new BrickPart(others);
            Check(first, BrickGrid.BrickSize, nameof(first));
            Check(last, BrickGrid.BrickSize, nameof(last));
            int from = first / step * step / NormalsStep, to = ((last / step + 1) * step - 1) / NormalsStep;
            return new BrickPart(others | (uint)(LastStep - from | to << 2) << (StripBits * strip));
        }

        /// <summary>Whether a voxel of the brick belongs to it.</summary>
        /// <param name="i">The voxel's offset in its brick along i, 0 to 7; likewise j and k.</param>
        /// <param name="j">Along j.</param>
        /// <param name="k">Along k.</param>
        public bool Holds(int i, int j, int k)
        {
            PlacesOf((j / StripRows & 1) + 2 * (i / StripColumns) + 4 * (j / (2 * StripRows)), out int first, out int end);
            return k >= first && k < end;
        }

        /// <summary>The number of its voxels that lie in the volume.</summary>
        /// <param name="brick">The brick's voxels that do.</param>
        public int VoxelsIn(in VoxelBox brick)
        {
            int voxels = 0, sizeI = brick.MaxI - brick.MinI + 1, sizeJ = brick.MaxJ - brick.MinJ + 1, sizeK = brick.MaxK - brick.MinK + 1;
            for (int strip = 0; strip < Strips; strip++)
            {
                PlacesOf(strip, out int first, out int end);
                int columnsI = Within(sizeI - FirstColumnOf(strip), StripColumns), columnsJ = Within(sizeJ - FirstRowOf(strip), StripRows);
                voxels += columnsI * columnsJ * Math.Max(0, Math.Min(sizeK, end) - first);
            }
            return voxels;
        }

        /// <summary>A strip's first column along i.</summary>
        internal static int FirstColumnOf(int strip) => StripColumns * (strip >> 1 & 1);

        /// <summary>A strip's first column along j.</summary>
        internal static int FirstRowOf(int strip) => StripRows * (strip & 1 | strip >> 1 & 2);

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

        /// <summary>Of the places along k of a strip the first and the end (one beyond the last), which lies before it where there are none.</summary>
        void PlacesOf(int strip, out int first, out int end)
        {
            int bits = (int)(Packed >> (StripBits * strip));
            first = NormalsStep * (LastStep - (bits & 3));
            end = NormalsStep * (1 + (bits >> 2 & 3));
        }

        static int Within(int size, int most) => Math.Max(0, Math.Min(most, size));

        static void Check(int value, int count, string argument)
        {
            if (value < 0 || value >= count)
                throw new ArgumentOutOfRangeException(argument, value, FormattableString.Invariant($"It is 0 to {count - 1}."));
        }
    }
}
