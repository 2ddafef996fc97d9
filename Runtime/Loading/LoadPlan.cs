using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve
{
    /// <summary>What one load does about a volume's size, as it was set when the load began. Made on the main thread, used on any.</summary>
    sealed class LoadPlan
    {
        /// <summary>Voxels of a volume that is shown first: 128 x 128 x 128 are unpacked, uploaded and carved in a frame or two.</summary>
        const long CoarseVoxels = 1 << 21;

        readonly VolumeLimits limits;
        readonly WhenTooLarge whenTooLarge;
        readonly long coarseAbove;
        readonly IProgress<SegmentedVolume> coarse;

        /// <param name="loader">Whose settings hold; the renderer beside it says how the volume will lie in textures.</param>
        /// <param name="coarse">Told of a coarse volume to be shown first, on any thread; null = none is wanted.</param>
        public LoadPlan(VolumeLoader loader, IProgress<SegmentedVolume> coarse)
        {
            MemorySettings settings = loader.Memory;
            TextureLayout layout = loader.TryGetComponent(out CarvedVolumeRenderer shown) ? shown.Layout : TextureLayout.Automatic;
            limits = VolumeLimits.OfDevice(layout, settings.BudgetMiB);
            whenTooLarge = settings.WhenTooLarge;
            coarseAbove = settings.CoarseAboveVoxels;
            this.coarse = coarse;
        }

        public VolumeLimits Limits => limits;

        /// <summary>Whether a volume can be held as it is.</summary>
        public bool Fits(VolumeGeometry grid, int segments) => limits.Hold(grid.SizeI, grid.SizeJ, grid.SizeK, segments);

        /// <summary>By how much a volume has to get coarser; all 1 where it fits.</summary>
        /// <param name="segments">Rows of its segment table; the fewest that there can be, where they are not known yet.</param>
        /// <exception cref="VolumeTooLargeException">It does not fit and is to be refused, or nothing of it would fit.</exception>
        public VoxelFactors Factors(VolumeGeometry grid, int segments, string name)
        {
            VolumeLimits holds = limits;
            VoxelFactors? fitting = VoxelFactors.Fitting(grid, (i, j, k) => holds.Hold(i, j, k, segments));
            if (fitting.HasValue && (fitting.Value.AreOne || whenTooLarge == WhenTooLarge.Downsample))
                return fitting.Value;
            string help = fitting.HasValue
                ? $"{Sizes(fitting.Value.Apply(grid))} voxels would fit: set When Too Large to Downsample, raise the budget, or resample or crop the scan"
                : "not even one voxel would fit: raise the budget";
            throw new VolumeTooLargeException(
                $"{name}: the volume of {Sizes(grid)} voxels cannot be held, as {limits.Reason(grid, segments)}; {help}.");
        }

        /// <summary>What to warn of when a volume was made coarser.</summary>
        /// <param name="grid">Its grid before.</param>
        public string Warning(VolumeGeometry grid, int segments, VolumeGeometry coarser, string name) =>
            $"{name}: the volume was made coarser, from {Sizes(grid)} to {Sizes(coarser)} voxels, as {limits.Reason(grid, segments)}.";

        /// <summary>Shows a coarse volume first, where one is wanted of so large a volume.</summary>
        /// <param name="grid">The grid of what will be loaded in the end.</param>
        /// <param name="source">The grid of what the coarse volume is made of.</param>
        /// <param name="make">Makes it.</param>
        public void ShowCoarse(VolumeGeometry grid, VolumeGeometry source, Func<VoxelFactors, SegmentedVolume> make)
        {
            if (coarse == null || coarseAbove == 0 || grid.VoxelCount <= coarseAbove)
                return;
            long most = Math.Min(CoarseVoxels, coarseAbove);
            VoxelFactors? factors = VoxelFactors.Fitting(source, (i, j, k) => (long)i * j * k <= most);
            if (factors.HasValue)
                coarse.Report(make(factors.Value));
        }

        static string Sizes(VolumeGeometry g) => FormattableString.Invariant($"{g.SizeI} x {g.SizeJ} x {g.SizeK}");
    }
}
