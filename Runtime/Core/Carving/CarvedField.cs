using System;
using System.Collections.Generic;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Carving
{
    /// <summary>
    /// What the kernels <c>ClipVoxels</c> and <c>AntiAlias</c> make of a volume and its carving, on the CPU and only where somebody looks: a voxel is computed
    /// when it is first asked for and kept until an input of its brick (8 x 8 x 8 voxels) changes, or until what is kept reaches a limit: then all of it
    /// is forgotten. Used by one thread at a time; separate fields share nothing that changes.
    /// </summary>
    public sealed class CarvedField
    {
        /// <summary>The memory that a field may keep voxels in, unless told otherwise: 64 MiB, about 45,000 bricks or 23 million voxels.</summary>
        public const long DefaultCacheLimitBytes = 64L << 20;

        readonly OpacityCache[] raw;
        readonly VoxelCache[] smoothed;
        readonly DirtyBrickSet dirty;
        readonly SphereIndex index;
        readonly float[] around = new float[AntiAlias.Neighbourhood];
        CarvingInputs inputs;
        VisibleContents contents;
        VoxelOpacity opacity;

        /// <summary>Prepares a field; <see cref="Update"/> says what it shows.</summary>
        /// <param name="volume">The volume.</param>
        /// <param name="cacheLimitBytes">The memory that voxels may be kept in, closely; 0 or more.</param>
        /// <exception cref="ArgumentNullException"><paramref name="volume"/> is null.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The volume is longer than 8,192 voxels, or the limit is negative.</exception>
        public CarvedField(SegmentedVolume volume, long cacheLimitBytes = DefaultCacheLimitBytes)
        {
            if (cacheLimitBytes < 0)
                throw new ArgumentOutOfRangeException(nameof(cacheLimitBytes), cacheLimitBytes, "The limit is 0 bytes or more.");
            Volume = volume ?? throw new ArgumentNullException(nameof(volume));
            Grid = new CentredGrid(volume.Geometry);
            Bricks = new BrickGrid(volume.Geometry);
            raw = new OpacityCache[Bricks.Count];
            smoothed = new VoxelCache[Bricks.Count];
            index = new SphereIndex(Bricks, Grid);
            dirty = new DirtyBrickSet(Bricks, Grid) { Index = index };
            CacheLimitBytes = cacheLimitBytes;
        }

        /// <summary>The volume.</summary>
        public SegmentedVolume Volume { get; }

        /// <summary>The volume's grid as the kernels see it.</summary>
        public CentredGrid Grid { get; }

        /// <summary>The volume's bricks.</summary>
        public BrickGrid Bricks { get; }

        /// <summary>The memory that voxels may be kept in.</summary>
        public long CacheLimitBytes { get; }

        /// <summary>The memory that voxels are kept in now. It may pass the limit by one brick's.</summary>
        public long CachedBytes { get; private set; }

        /// <summary>How many voxels' opacities were computed so far, for those who count work.</summary>
        public long OpacityVoxelsComputed { get; private set; }

        /// <summary>How many voxels were anti-aliased so far.</summary>
        public long AntiAliasedVoxelsComputed { get; private set; }

        /// <summary>
        /// Says what the field shows from now on, and forgets the bricks that this can change. Free where every argument is the very one of the last
        /// call, so that it can be called in each frame with a <see cref="CarvingSnapshot"/>.
        /// </summary>
        /// <param name="spheres">The carving; a list that may change later is copied.</param>
        /// <param name="transferFunction">Opacity by intensity.</param>
        /// <param name="segments">The segments with their opacities, as many as the volume has.</param>
        /// <param name="cut">The cut mode.</param>
        /// <param name="antiAlias">The anti-aliasing's settings.</param>
        /// <exception cref="ArgumentNullException">An argument is null.</exception>
        /// <exception cref="ArgumentException">The segments, or a sphere's mask, are not as many as the volume's segments.</exception>
        public void Update(
            IReadOnlyList<ClipSphere> spheres, OpacityTransferFunction transferFunction, SegmentTable segments, CutMode cut, AntiAliasSettings antiAlias)
        {
            if (inputs != null && inputs.AreExactly(spheres, transferFunction, segments, cut, antiAlias))
                return;
            CarvingInputs wanted = CarvingInputs.Take(Volume, spheres, transferFunction, segments, cut, antiAlias);
            bool sharesOpacities = inputs != null && inputs.SharesOpacitiesWith(wanted);
            bool sharesAntiAlias = sharesOpacities && inputs.AntiAlias.Equals(wanted.AntiAlias);
            index.Update(wanted.Spheres);
            if (sharesOpacities)
                ForgetBetween(inputs, wanted, cut, 0, raw);
            else
                ForgetAll(raw);
            if (sharesAntiAlias)
                ForgetBetween(inputs, wanted, cut, CarvingReach.AntiAliasVoxels, smoothed);
            else
                ForgetAll(smoothed);
            bool sharesLookup = inputs != null && inputs.SharesTransferFunctionWith(wanted);
            OpacityLookup lookup = sharesLookup ? opacity.Lookup : new OpacityLookup(transferFunction, Volume.Intensity);
            inputs = wanted;
            if (!sharesOpacities)
                dirty.Contents = contents = VisibleContents.Of(Volume, lookup, wanted.SegmentOpacities);
            opacity = new VoxelOpacity(Volume, Grid, Bricks, index, contents, lookup, wanted.SegmentOpacities, cut);
        }

        /// <summary>Eq. 1 for a voxel, whatever the cut mode.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The voxel lies outside the volume.</exception>
        /// <exception cref="InvalidOperationException"><see cref="Update"/> was never called.</exception>
        public bool IsClipped(int i, int j, int k)
        {
            Check(i, j, k);
            return opacity.IsClipped(i, j, k);
        }

        /// <summary>A voxel's carved opacity as the kernel stores it: opacity * 255, rounded to the nearest, ties to even.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The voxel lies outside the volume.</exception>
        /// <exception cref="InvalidOperationException"><see cref="Update"/> was never called.</exception>
        public byte OpacityCode(int i, int j, int k)
        {
            Check(i, j, k);
            return RawCode(i, j, k);
        }

        /// <summary>A voxel's anti-aliased opacity as the kernel stores it, 0 to 255.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The voxel lies outside the volume.</exception>
        /// <exception cref="InvalidOperationException"><see cref="Update"/> was never called.</exception>
        public byte AntiAliasedCode(int i, int j, int k)
        {
            Check(i, j, k);
            return SmoothedCode(i, j, k);
        }

        /// <summary>The anti-aliased opacity at any place, 0 to 1, trilinear between voxel centres; beyond the outermost centres they continue.</summary>
        /// <param name="x">Continuous voxel index along i; a voxel's centre is an integer.</param>
        /// <param name="y">Along j.</param>
        /// <param name="z">Along k.</param>
        /// <exception cref="InvalidOperationException"><see cref="Update"/> was never called.</exception>
        public double SampleAntiAliased(double x, double y, double z)
        {
            CheckUpdated();
            SplitClamped(x, Bricks.SizeI, out int i, out int i1, out double fx);
            SplitClamped(y, Bricks.SizeJ, out int j, out int j1, out double fy);
            SplitClamped(z, Bricks.SizeK, out int k, out int k1, out double fz);
            double c00 = Lerp(SmoothedCode(i, j, k), SmoothedCode(i1, j, k), fx);
            double c10 = Lerp(SmoothedCode(i, j1, k), SmoothedCode(i1, j1, k), fx);
            double c01 = Lerp(SmoothedCode(i, j, k1), SmoothedCode(i1, j, k1), fx);
            double c11 = Lerp(SmoothedCode(i, j1, k1), SmoothedCode(i1, j1, k1), fx);
            return Lerp(Lerp(c00, c10, fy), Lerp(c01, c11, fy), fz) / 255;
        }

        /// <summary>
        /// The segment that a place shows: that of the most opaque, before anti-aliasing, of the eight voxels around it; where all eight are empty, of
        /// the 4 x 4 x 4 around it. Of equally opaque voxels the first counts, i fastest.
        /// </summary>
        /// <param name="x">Continuous voxel index along i.</param>
        /// <param name="y">Along j.</param>
        /// <param name="z">Along k.</param>
        /// <returns>A dense segment index; -1 where all 64 are empty.</returns>
        /// <exception cref="InvalidOperationException"><see cref="Update"/> was never called.</exception>
        public int SegmentAt(double x, double y, double z)
        {
            CheckUpdated();
            int i = FloorWithin(x, Bricks.SizeI), j = FloorWithin(y, Bricks.SizeJ), k = FloorWithin(z, Bricks.SizeK);
            int segment = MostOpaqueSegment(i, j, k, 0, 1);
            return segment >= 0 ? segment : MostOpaqueSegment(i, j, k, -1, 2);
        }

        /// <summary>
        /// Whether it is certain that the anti-aliased opacity is 0 at every place whose lower neighbour along each axis is a voxel of the brick,
        /// whatever the carving. False does not say that it is not.
        /// </summary>
        internal bool IsClearFrom(int brickX, int brickY, int brickZ) => !contents.IsNearMatter(Bricks.IndexOf(brickX, brickY, brickZ));

        int MostOpaqueSegment(int i, int j, int k, int first, int last)
        {
            int best = 0;
            long bestVoxel = -1;
            for (int dk = first; dk <= last; dk++)
                for (int dj = first; dj <= last; dj++)
                    for (int di = first; di <= last; di++)
                    {
                        int vi = Clamp(i + di, Bricks.SizeI), vj = Clamp(j + dj, Bricks.SizeJ), vk = Clamp(k + dk, Bricks.SizeK);
                        int code = RawCode(vi, vj, vk);
                        if (code > best)
                        {
                            best = code;
                            bestVoxel = vi + (long)Bricks.SizeI * (vj + (long)Bricks.SizeJ * vk);
                        }
                    }
            return bestVoxel < 0 ? -1 : Volume.Labels.Indices[bestVoxel];
        }

        byte RawCode(int i, int j, int k)
        {
            OpacityCache cache = CacheOf(raw, Bricks.IndexOfVoxel(i, j, k));
            int voxel = InBrick(i, j, k);
            if (cache.TryGet(voxel, out byte code))
                return code;
            OpacityVoxelsComputed++;
            long bytesBefore = cache.Bytes;
            List<CentredSphere> reaching = cache.Reaching(opacity, i / BrickGrid.BrickSize, j / BrickGrid.BrickSize, k / BrickGrid.BrickSize);
            CachedBytes += cache.Bytes - bytesBefore;
            return cache.Keep(voxel, opacity.Code(i, j, k, reaching));
        }

        byte SmoothedCode(int i, int j, int k)
        {
            VoxelCache cache = CacheOf(smoothed, Bricks.IndexOfVoxel(i, j, k));
            int voxel = InBrick(i, j, k);
            if (cache.TryGet(voxel, out byte code))
                return code;
            AntiAliasedVoxelsComputed++;
            return cache.Keep(voxel, inputs.AntiAlias.Strength == 0 ? RawCode(i, j, k) : Smooth(i, j, k));
        }

        byte Smooth(int i, int j, int k)
        {
            int next = 0;
            for (int dk = -1; dk <= 1; dk++)
                for (int dj = -1; dj <= 1; dj++)
                    for (int di = -1; di <= 1; di++)
                        around[next++] = RawCode(Clamp(i + di, Bricks.SizeI), Clamp(j + dj, Bricks.SizeJ), Clamp(k + dk, Bricks.SizeK)) / 255f;
            return (byte)Math.Round(AntiAlias.Filter(around, inputs.AntiAlias) * 255f, MidpointRounding.ToEven);
        }

        /// <summary>
        /// A brick's cache, made when first asked for. Where the limit is reached all others go first; whoever still holds one of those may go on
        /// using it.
        /// </summary>
        T CacheOf<T>(T[] caches, int brick)
            where T : VoxelCache, new()
        {
            T cache = caches[brick];
            if (cache != null)
                return cache;
            if (CachedBytes >= CacheLimitBytes)
            {
                Array.Clear(raw, 0, raw.Length);
                Array.Clear(smoothed, 0, smoothed.Length);
                CachedBytes = 0;
            }
            cache = new T();
            CachedBytes += cache.Bytes;
            return caches[brick] = cache;
        }

        void ForgetBetween(CarvingInputs before, CarvingInputs after, CutMode cut, int haloVoxels, VoxelCache[] caches)
        {
            dirty.Compute(before.Spheres, after.Spheres, cut, haloVoxels);
            for (int n = 0; n < dirty.Count; n++)
                caches[dirty.Indices[n]]?.Forget();
        }

        void Check(int i, int j, int k)
        {
            CheckUpdated();
            if ((uint)i >= (uint)Bricks.SizeI || (uint)j >= (uint)Bricks.SizeJ || (uint)k >= (uint)Bricks.SizeK)
                throw new ArgumentOutOfRangeException(nameof(i), FormattableString.Invariant(
                    $"Voxel ({i}, {j}, {k}) lies outside the volume of {Bricks.SizeI} x {Bricks.SizeJ} x {Bricks.SizeK} voxels."));
        }

        void CheckUpdated()
        {
            if (inputs == null)
                throw new InvalidOperationException("Update says what the field shows; it was not called yet.");
        }

        static void ForgetAll(VoxelCache[] caches)
        {
            foreach (VoxelCache cache in caches)
                cache?.Forget();
        }

        static int InBrick(int i, int j, int k) =>
            i % BrickGrid.BrickSize + BrickGrid.BrickSize * (j % BrickGrid.BrickSize + BrickGrid.BrickSize * (k % BrickGrid.BrickSize));

        static int Clamp(int index, int size) => index < 0 ? 0 : index >= size ? size - 1 : index;

        static int FloorWithin(double x, int size) => x > -2 ? (int)Math.Floor(Math.Min(x, size + 1)) : -2;

        static void SplitClamped(double x, int size, out int index, out int next, out double fraction)
        {
            double clamped = x > 0 ? Math.Min(x, size - 1) : 0;
            index = (int)clamped;
            next = Math.Min(index + 1, size - 1);
            fraction = clamped - index;
        }

        static double Lerp(double a, double b, double share) => a + (b - a) * share;
    }
}
